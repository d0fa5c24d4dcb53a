#pragma once

#include <cstdint>

#include "haptics/timing/clock_statistics.h"
#include "study/model/view_report.h"

namespace study::gui::scene {

/// Counts frames: how many, how far apart, how old what they show.
class FrameStatistics {
 public:
  /// @param period  that frames are meant to be apart [ns], > 0.
  explicit FrameStatistics(std::int64_t period) : period_(period) {}

  /// A frame was shown at @p shown, of a device that was read at @p sampled (0: it was not). Both
  /// in [ns on CLOCK_MONOTONIC].
  void add(std::int64_t shown, std::int64_t sampled);

  std::int64_t frames() const noexcept { return frames_; }
  ViewReport report() const;

 private:
  std::int64_t period_;
  std::int64_t frames_ = 0;
  std::int64_t dropped_ = 0;
  std::int64_t first_ = 0;
  std::int64_t last_ = 0;
  haptics::timing::LatenessHistogram intervals_;  // in [µs]
  haptics::timing::LatenessHistogram latencies_;
};

}  // namespace study::gui::scene

#pragma once

#include <cstdint>

#include "haptics/timing/clock_statistics.h"
#include "study/model/trial_record.h"

namespace study::gui::scene {

/// Counts displayed frames and measures their intervals and latencies.
class FrameStatistics {
 public:
  /// @param period  the intended interval between frames [ns], > 0.
  explicit FrameStatistics(std::int64_t period) : period_(period) {}

  /// Adds a frame displayed at @p shown that shows a device sample taken at @p sampled (0: no
  /// sample), both in ns on CLOCK_MONOTONIC.
  void add(std::int64_t shown, std::int64_t sampled);

  std::int64_t frames() const noexcept { return frames_; }
  double longest() const noexcept;  ///< the longest interval [ms]
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

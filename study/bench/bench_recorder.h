#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "haptics/timing/lateness_histogram.h"

namespace study::app {

/// How fast a way of keeping samples is.
struct RecorderRun {
  std::string way;
  double samplesPerSecond = 0.0;
  double bytesPerSample = 0.0;
  double worstCall = 0.0;  ///< for a thousand samples [ms]
};

/// A thousand samples at a time, each time safe on the disk: our chunks, rows of a table, a raw
/// file. In turn, so that the disk's moods fall on all alike. Leaves nothing in @p folder.
std::vector<RecorderRun> raceRecorders(const std::string& folder, double seconds);

/// What recording costs in the loop.
struct RecorderLoop {
  haptics::timing::LatenessHistogram push;  ///< time of handing a sample over [µs]
  std::uint64_t ticks = 0;
  std::uint64_t kept = 0;
  std::uint64_t lost = 0;  ///< the ring was full
  double seconds = 0.0;
};

/// A loop of @p rate [Hz] that hands its samples to a recorder's thread, which keeps them in
/// @p folder, for so many seconds.
RecorderLoop recordInLoop(const std::string& folder, double rate, double seconds);

}  // namespace study::app

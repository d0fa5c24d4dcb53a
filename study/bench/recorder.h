#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "haptics/timing/clock_statistics.h"

namespace study::bench {

/// How fast a way of keeping samples is.
struct RecorderRun {
  std::string way;
  double samplesPerSecond = 0.0;
  double bytesPerSample = 0.0;
  double worstCall = 0.0;  ///< for a thousand samples [ms]
};

/// A thousand samples at a time, each time safe on the disk: as studies keep them, and as a raw
/// file, in turn. Leaves nothing in @p folder.
/// @throws UserError, storage::StorageError  if the folder takes no files.
std::vector<RecorderRun> compareRecorders(const std::string& folder, double seconds);

/// What recording costs in the loop.
struct RecorderLoop {
  haptics::timing::LatenessHistogram push;  ///< time of handing a sample over [µs]
  std::uint64_t ticks = 0;
  std::uint64_t kept = 0;
  double seconds = 0.0;
};

/// A loop of @p rate [Hz] hands its samples to a recorder's thread, which keeps them in @p folder.
RecorderLoop recordInLoop(const std::string& folder, double rate, double seconds);

}  // namespace study::bench

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "haptics/timing/clock_statistics.h"

namespace study::bench {

/// The speed of one way of storing samples.
struct RecorderRun {
  std::string way;
  double samplesPerSecond = 0.0;
  double bytesPerSample = 0.0;
  double worstCall = 0.0;  ///< longest time to store a thousand samples [ms]
};

/// Stores a thousand samples at a time, each time synchronised to the disk: once as studies do and
/// once in a raw file, alternately. Leaves nothing in @p folder.
/// @throws UserError, storage::StorageError  if the folder cannot be written.
std::vector<RecorderRun> compareRecorders(const std::string& folder, double seconds);

/// The cost of recording in the force loop.
struct RecorderLoop {
  haptics::timing::LatenessHistogram push;  ///< time to pass a sample to the recorder [µs]
  std::uint64_t ticks = 0;
  std::uint64_t kept = 0;
  double seconds = 0.0;
};

/// Runs a loop at @p rate [Hz] for @p seconds, which passes its samples to a recorder thread; the
/// thread stores them in @p folder.
RecorderLoop recordInLoop(const std::string& folder, double rate, double seconds);

}  // namespace study::bench

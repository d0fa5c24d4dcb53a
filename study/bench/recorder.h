#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "haptics/timing/clock_statistics.h"

namespace study::bench {

/// The speed of one method of storing samples.
struct RecorderRun {
  std::string method;
  double samplesPerSecond = 0.0;
  double bytesPerSample = 0.0;
  double worstCall = 0.0;  ///< longest time to store a thousand samples [ms]
};

/// Stores a thousand samples at a time, each time synchronised to the disk: alternately by the
/// method of studies and in a raw file. Leaves nothing in @p folder.
/// @throws UserError, storage::StorageError  if the folder cannot be written.
std::vector<RecorderRun> compareRecorders(const std::string& folder, double seconds);

/// The cost of recording in the force loop.
struct RecorderLoop {
  haptics::timing::LatenessHistogram push;  ///< time for passing a sample to the recorder [µs]
  std::uint64_t ticks = 0;
  std::uint64_t kept = 0;  ///< number of stored samples
  double seconds = 0.0;
};

/// Runs a loop at @p rate [Hz] for @p seconds [s], which passes its samples to a recorder thread;
/// this thread stores them in @p folder.
RecorderLoop recordInLoop(const std::string& folder, double rate, double seconds);

}  // namespace study::bench

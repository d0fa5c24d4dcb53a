#pragma once

#include <cstdint>
#include <optional>

#include "haptics/timing/clock_statistics.h"

namespace haptics::devices {

/// What has come over a wire, what has not, and how long it took.
struct LinkReport {
  bool isThere = false;                 ///< there is a wire
  std::uint64_t received = 0;           ///< that were acted upon
  std::uint64_t lost = 0;               ///< never came
  std::uint64_t doubled = 0;            ///< came twice; the second was not acted upon
  std::uint64_t late = 0;               ///< overtaken; not acted upon
  std::uint64_t damaged = 0;            ///< not as they had been sent
  std::uint64_t foreign = 0;            ///< from somebody else
  std::uint64_t restarts = 0;           ///< the device began to count anew
  std::uint64_t skipped = 0;            ///< came together with a newer one, after we had been late
  std::uint64_t stale = 0;              ///< ticks without a new sample
  std::uint64_t unsent = 0;             ///< answers that found no room on the wire
  std::uint64_t poor = 0;               ///< samples while the connection was too bad for a force
  std::uint64_t clipped = 0;            ///< forces beyond what the device gives
  std::uint64_t expired = 0;            ///< the device let go because we were late
  timing::LatenessHistogram roundTrip;  ///< from our answer to the sample that has seen it [µs]
  std::optional<double> drift;          ///< our clock against the device's [parts per million]
  std::int64_t clockOffset = 0;         ///< our clock at the device's 0 [ns]
};

}  // namespace haptics::devices

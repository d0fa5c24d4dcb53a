#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "haptics/bench/measurement.h"

namespace haptics::bench {

/// A measurement on one line, for another process to read; and back. Nothing where the line is
/// none.
std::string asLine(const Measurement& measurement);
std::optional<Measurement> fromLine(const std::string& line);

/// The same thing measured by several processes: a process has one layout of memory all its life,
/// which may be lucky or not.
struct Repeated {
  Measurement measurement;  ///< times are medians over the processes
  double fastest = 0.0;     ///< of the processes' medians [ns]
  double slowest = 0.0;     ///< [ns]
  int processes = 0;
};

/// In the order in which things were first measured.
std::vector<Repeated> gathered(const std::vector<Measurement>& measurements);

}  // namespace haptics::bench

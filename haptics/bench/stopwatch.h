#pragma once

#include <functional>
#include <string>
#include <vector>

namespace haptics::bench {

/// How long a step takes [ns]: the median over many short batches, and what 99 % of them do not
/// exceed.
struct Timing {
  double median = 0.0;
  double p99 = 0.0;
};

/// Somebody in a race.
struct Contestant {
  std::string method;
  std::function<double(int steps)> run;  ///< makes so many steps; returns what it came to
};

/// Times everybody in turn – A, B, C, A, B, C … – so that whatever the machine does meanwhile falls
/// on all of them alike. Batches take 300 µs, or one step,
/// and each is run once without being timed before: warm caches. There are 101 of each, fewer of
/// what is slow, but no fewer than 21.
std::vector<Timing> race(const std::vector<Contestant>& contestants);

/// One step at a time, each after as much other memory has been read as no cache holds (80 MB): how
/// a servo's tick meets its data. The way to the contestant is warmed by making no step; the clock
/// is read once, about 20 ns.
std::vector<Timing> raceCold(const std::vector<Contestant>& contestants, int rounds);

}  // namespace haptics::bench

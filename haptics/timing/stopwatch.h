#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace haptics::timing {

double secondsSince(std::chrono::steady_clock::time_point start);
double nanosecondsSince(std::chrono::steady_clock::time_point start);

/// Duration of a step [ns]: median and 99 % quantile over many short batches.
struct Timing {
  double median = 0.0;
  double p99 = 0.0;
};

/// One of several implementations whose times are compared.
struct Contestant {
  std::string method;
  /// Performs that many steps; returns a result, so that they are not optimised away.
  std::function<double(int steps)> run;
};

/// Times all contestants in turn (A, B, C, A, B, C …), so that other load of the computer affects
/// all of them equally. A batch has as many steps as take 300 to 600 µs, and is run once untimed
/// before it is timed (warm caches). If one step takes longer than that, it is the whole batch, and
/// is run only once. Each contestant has 101 batches; slow contestants fewer, but at least 21.
std::vector<Timing> compareTimes(const std::vector<Contestant>& contestants);

/// Times single steps with cold caches, as in the tick of a loop: before each, 80 MB of other
/// memory are read, more than a cache holds. A call with 0 steps before each keeps the call itself
/// warm; reading the clock adds about 20 ns.
std::vector<Timing> compareColdTimes(const std::vector<Contestant>& contestants, int rounds);

}  // namespace haptics::timing

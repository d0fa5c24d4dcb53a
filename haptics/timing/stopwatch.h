#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace haptics::timing {

/// [s]
double secondsSince(std::chrono::steady_clock::time_point start);

/// How long a step takes [ns]: the median over many short batches, and what 99 % of them do not
/// exceed.
struct Timing {
  double median = 0.0;
  double p99 = 0.0;
};

/// One of several ways of doing something that are timed beside each other.
struct Contestant {
  std::string method;
  std::function<double(int steps)> run;  ///< performs so many steps; returns their result
};

/// Times all contestants in turn (A, B, C, A, B, C …), so that other load of the computer falls on
/// all of them alike. A batch takes 300 µs, or one step, and is run once without being timed before
/// (warm caches). There are 101 batches of each contestant, fewer of slow ones, but at least 21.
std::vector<Timing> compareTimes(const std::vector<Contestant>& contestants);

/// Times one step at a time, each after 80 MB of other memory have been read, more than a cache
/// holds, because the tick of a loop also finds cold caches. A call with 0 steps before each keeps
/// the call itself warm; reading the clock adds about 20 ns.
std::vector<Timing> compareColdTimes(const std::vector<Contestant>& contestants, int rounds);

}  // namespace haptics::timing

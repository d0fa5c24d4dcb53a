#include "haptics/timing/stopwatch.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace haptics::timing {
namespace {

using Clock = std::chrono::steady_clock;

/// Stores a result, so that the compiler does not remove its computation.
void storeResult(double value) {
  [[maybe_unused]] static volatile double sink = 0.0;
  sink = value;
}

double batch(const Contestant& contestant, int steps) {
  const auto start = Clock::now();
  storeResult(contestant.run(steps));
  return nanosecondsSince(start);
}

/// How a contestant is timed: steps per batch, and number of batches.
struct Plan {
  int steps = 1;
  int batches = 101;
  std::vector<double> times;
};

Plan planFor(const Contestant& contestant) {
  constexpr double kLongStep = 300'000.0;  // [ns]
  constexpr double kTimeLimit = 0.3e9;     // [ns] for all batches of a contestant
  constexpr int kFewest = 21;
  Plan plan;
  double time = batch(contestant, plan.steps);
  while (time < kLongStep && plan.steps < 1'000'000) {
    plan.steps *= 2;
    time = batch(contestant, plan.steps);
  }
  plan.batches = std::clamp(static_cast<int>(kTimeLimit / time), kFewest, plan.batches);
  return plan;
}

Timing timingOf(std::vector<double> times) {
  std::ranges::sort(times);
  const auto last = static_cast<double>(times.size() - 1);
  return {times[times.size() / 2], times[static_cast<std::size_t>(std::ceil(0.99 * last))]};
}

}  // namespace

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

double nanosecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::nano>(Clock::now() - start).count();
}

std::vector<Timing> compareTimes(const std::vector<Contestant>& contestants) {
  std::vector<Plan> plans;
  int rounds = 0;
  for (const auto& contestant : contestants) {
    plans.push_back(planFor(contestant));
    rounds = std::max(rounds, plans.back().batches);
  }
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < contestants.size(); ++i) {
      auto& plan = plans[i];
      // The batches of slow contestants are spread evenly over all rounds.
      const bool takesPart = (round + 1) * plan.batches / rounds > round * plan.batches / rounds;
      if (!takesPart) continue;
      if (plan.steps > 1) batch(contestants[i], plan.steps);
      plan.times.push_back(batch(contestants[i], plan.steps) / plan.steps);
    }
  }
  std::vector<Timing> timings;
  for (auto& plan : plans) timings.push_back(timingOf(std::move(plan.times)));
  return timings;
}

std::vector<Timing> compareColdTimes(const std::vector<Contestant>& contestants, int rounds) {
  constexpr std::size_t kWordsBeyondCaches = std::size_t{80} * 1024 * 1024 / sizeof(std::uint64_t);
  static std::vector<std::uint64_t> other(kWordsBeyondCaches, 1);
  std::vector<std::vector<double>> times(contestants.size());
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < contestants.size(); ++i) {
      std::uint64_t sum = 0;
      for (auto& word : other) sum += word++;
      storeResult(static_cast<double>(sum));
      batch(contestants[i], 0);  // warms the call itself, which is not compared
      times[i].push_back(batch(contestants[i], 1));
    }
  }
  std::vector<Timing> timings;
  for (auto& all : times) timings.push_back(timingOf(std::move(all)));
  return timings;
}

}  // namespace haptics::timing

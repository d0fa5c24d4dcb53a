#include "analysis/tests/rank_sums.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <stdexcept>

namespace analysis {
namespace {

constexpr std::uint64_t kMostValues = 1000;  // C(1000, 500) ≈ 3e299 is still a double
constexpr std::uint64_t kMostSteps = 50'000'000;

/// Doubled midranks of all values from the smallest, as whole numbers of steps above the first.
struct ReducedRanks {
  std::vector<std::uint64_t> steps;
  std::uint64_t lowest = 0;
  std::uint64_t unit = 1;
};

ReducedRanks reducedRanks(const TiedGroups& groups) {
  ReducedRanks ranks;
  std::uint64_t below = 0;
  for (const auto& value : groups.values) {
    const std::uint64_t ties = value.first + value.second;
    ranks.steps.insert(ranks.steps.end(), ties, 2 * below + ties + 1);
    below += ties;
  }
  ranks.lowest = ranks.steps.front();
  std::uint64_t unit = 0;
  for (auto& rank : ranks.steps) {
    rank -= ranks.lowest;
    unit = std::gcd(unit, rank);
  }
  ranks.unit = std::max<std::uint64_t>(unit, 1);
  for (auto& rank : ranks.steps) rank /= ranks.unit;
  return ranks;
}

/// The largest sum of so many ranks.
std::uint64_t reachOf(const ReducedRanks& ranks, std::uint64_t chosen) {
  return std::accumulate(
      ranks.steps.end() - static_cast<std::ptrdiff_t>(chosen), ranks.steps.end(), std::uint64_t{0});
}

/// In how many ways so many of the ranks have each sum.
std::vector<DoubleDouble> waysTo(const ReducedRanks& ranks, std::size_t chosen) {
  const std::size_t width = reachOf(ranks, chosen) + 1;
  std::vector<std::vector<DoubleDouble>> ways(chosen + 1, std::vector<DoubleDouble>(width));
  ways[0][0] = 1.0;
  std::size_t seen = 0;
  for (const auto rank : ranks.steps) {
    ++seen;
    // Downwards, so that each rank is chosen at most once.
    for (std::size_t count = std::min(seen, chosen); count > 0; --count) {
      for (std::size_t sum = rank; sum < width; ++sum) {
        const DoubleDouble& without = ways[count - 1][sum - rank];
        if (!without.isZero()) ways[count][sum] = ways[count][sum] + without;
      }
    }
  }
  return ways[chosen];
}

}  // namespace

bool RankSums::canHold(const TiedGroups& groups) {
  if (groups.n1 > kMostValues || groups.n2 > kMostValues) return false;
  const std::uint64_t all = groups.n1 + groups.n2;
  if (all > kMostValues) return false;
  if (groups.isEmpty()) return true;
  const std::uint64_t chosen = std::min(groups.n1, groups.n2);
  return all * chosen * (reachOf(reducedRanks(groups), chosen) + 1) <= kMostSteps;
}

RankSums::RankSums(const TiedGroups& groups) {
  if (!canHold(groups)) throw std::invalid_argument("too many rank sums to compute their law");
  if (groups.isEmpty()) throw std::invalid_argument("a group has no values");
  const bool isFirst = groups.n1 <= groups.n2;
  const auto chosen = static_cast<std::int64_t>(std::min(groups.n1, groups.n2));
  const ReducedRanks ranks = reducedRanks(groups);
  mean_ = static_cast<std::int64_t>(groups.n1 * groups.n2);

  // 2U of the smaller group: its doubled rank sum less the least that it could be
  const std::int64_t first =
      chosen * static_cast<std::int64_t>(ranks.lowest) - chosen * (chosen + 1);
  least_ = isFirst ? first : 2 * mean_ - first;
  step_ = static_cast<std::int64_t>(ranks.unit) * (isFirst ? 1 : -1);

  probabilities_ = waysTo(ranks, static_cast<std::size_t>(chosen));
  DoubleDouble all;
  for (const auto& ways : probabilities_) all = all + ways;
  for (auto& ways : probabilities_) ways = ways / all;
}

std::int64_t RankSums::doubledUAt(std::size_t index) const {
  return least_ + step_ * static_cast<std::int64_t>(index);
}

double RankSums::atMost(std::int64_t doubledU) const {
  DoubleDouble sum;
  for (std::size_t i = 0; i < probabilities_.size(); ++i) {
    if (doubledUAt(i) <= doubledU) sum = sum + probabilities_[i];
  }
  return sum.high;
}

double RankSums::atLeast(std::int64_t doubledU) const {
  DoubleDouble sum;
  for (std::size_t i = 0; i < probabilities_.size(); ++i) {
    if (doubledUAt(i) >= doubledU) sum = sum + probabilities_[i];
  }
  return sum.high;
}

double RankSums::asFar(std::int64_t doubledU) const {
  const std::int64_t distance = std::abs(doubledU - mean_);
  DoubleDouble sum;
  for (std::size_t i = 0; i < probabilities_.size(); ++i) {
    if (std::abs(doubledUAt(i) - mean_) >= distance) sum = sum + probabilities_[i];
  }
  return sum.high;
}

}  // namespace analysis

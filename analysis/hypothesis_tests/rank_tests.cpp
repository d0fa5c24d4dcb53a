#include "analysis/hypothesis_tests/rank_tests.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "analysis/numerics/distributions.h"
#include "analysis/numerics/exact_arithmetic.h"
#include "analysis/numerics/tail_probabilities.h"

namespace analysis {
namespace {

constexpr std::uint64_t kMostValues = 1000;  // C(1000, 500) ≈ 3e299 is still a double
constexpr std::uint64_t kMostSteps = 50'000'000;

/// Doubled midranks of all values in ascending order, as lowest + unit · step.
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

/// The largest sum of @p chosen ranks.
std::uint64_t largestSumOf(const ReducedRanks& ranks, std::uint64_t chosen) {
  return std::accumulate(
      ranks.steps.end() - static_cast<std::ptrdiff_t>(chosen), ranks.steps.end(), std::uint64_t{0});
}

/// For each sum, the number of subsets of @p chosen ranks that have it.
std::vector<DoubleDouble> subsetCountsBySum(const ReducedRanks& ranks, std::size_t chosen) {
  const std::size_t width = largestSumOf(ranks, chosen) + 1;
  std::vector<std::vector<DoubleDouble>> ways(chosen + 1, std::vector<DoubleDouble>(width));
  ways[0][0] = 1.0;
  std::size_t ranksSeen = 0;
  for (const auto rank : ranks.steps) {
    ++ranksSeen;
    // Downwards, so that each rank is chosen at most once.
    for (std::size_t count = std::min(ranksSeen, chosen); count > 0; --count) {
      for (std::size_t sum = rank; sum < width; ++sum) {
        const DoubleDouble& without = ways[count - 1][sum - rank];
        if (!without.isZero()) ways[count][sum] = ways[count][sum] + without;
      }
    }
  }
  return ways[chosen];
}

}  // namespace

bool RankSumDistribution::isComputable(const TiedGroups& groups) {
  if (groups.n1 > kMostValues || groups.n2 > kMostValues) return false;
  const std::uint64_t all = groups.n1 + groups.n2;
  if (all > kMostValues) return false;
  if (groups.isEmpty()) return true;
  const std::uint64_t chosen = std::min(groups.n1, groups.n2);
  return all * chosen * (largestSumOf(reducedRanks(groups), chosen) + 1) <= kMostSteps;
}

RankSumDistribution::RankSumDistribution(const TiedGroups& groups) {
  if (!isComputable(groups)) throw std::invalid_argument("too many rank sums to compute their law");
  if (groups.isEmpty()) throw std::invalid_argument("a group has no values");
  const bool isFirst = groups.n1 <= groups.n2;
  const auto chosen = static_cast<std::int64_t>(std::min(groups.n1, groups.n2));
  const ReducedRanks ranks = reducedRanks(groups);
  const auto mean = static_cast<std::int64_t>(groups.n1 * groups.n2);  // of 2U

  // 2U of the smaller group: its doubled rank sum minus the smallest possible one
  const std::int64_t first =
      chosen * static_cast<std::int64_t>(ranks.lowest) - chosen * (chosen + 1);
  least_ = isFirst ? first : 2 * mean - first;
  step_ = static_cast<std::int64_t>(ranks.unit) * (isFirst ? 1 : -1);

  probabilities_ = subsetCountsBySum(ranks, static_cast<std::size_t>(chosen));
  DoubleDouble all;
  for (const auto& ways : probabilities_) all = all + ways;
  for (auto& ways : probabilities_) ways = ways / all;
}

std::int64_t RankSumDistribution::doubledUAt(std::size_t index) const {
  return least_ + step_ * static_cast<std::int64_t>(index);
}

double RankSumDistribution::atMost(std::int64_t doubledU) const {
  DoubleDouble sum;
  for (std::size_t i = 0; i < probabilities_.size(); ++i) {
    if (doubledUAt(i) <= doubledU) sum = sum + probabilities_[i];
  }
  return sum.high;
}

double RankSumDistribution::atLeast(std::int64_t doubledU) const {
  DoubleDouble sum;
  for (std::size_t i = 0; i < probabilities_.size(); ++i) {
    if (doubledUAt(i) >= doubledU) sum = sum + probabilities_[i];
  }
  return sum.high;
}

namespace {

Reason whyNotRanked(const TiedGroups& groups) {
  if (groups.n1 == 0) return reason("group_is_empty", 1);
  if (groups.n2 == 0) return reason("group_is_empty", 2);
  if (groups.areTooLargeForExactRanks()) return reason("groups_too_large");
  return {};
}

void addExact(MannWhitneyResult& result, const TiedGroups& groups, Int128 doubledU) {
  if (!RankSumDistribution::isComputable(groups)) {
    result.reason = reason("too_many_values");
    return;
  }
  const RankSumDistribution distribution(groups);
  const auto u = static_cast<std::int64_t>(doubledU);
  result.pLess = distribution.atMost(u);
  result.pGreater = distribution.atLeast(u);
  result.p = std::min(1.0, 2.0 * std::min(*result.pLess, *result.pGreater));
}

void addAsymptotic(
    MannWhitneyResult& result, const TiedGroups& groups, const Placements& placements) {
  const auto pairs = static_cast<Int128>(groups.n1) * static_cast<Int128>(groups.n2);
  const auto all = static_cast<Int128>(groups.n1) + static_cast<Int128>(groups.n2);
  const Int128 untied = all * all * all - all - placements.tieSum;
  const DoubleDouble variance =
      exactQuotient(untied, 12 * all * (all - 1)) * exactQuotient(pairs, 1);
  result.variance = variance.high;
  if (untied == 0) {
    result.reason = reason("all_values_equal");
    return;
  }
  const Int128 excess = placements.sum1 - pairs;  // 2 (U − its mean)
  // The continuity correction moves U by ½, that is 2U by 1, towards its mean.
  const Int128 corrected = excess > 0 ? excess - 1 : excess < 0 ? excess + 1 : 0;
  const DoubleDouble deviation = squareRoot(variance) * 2.0;
  result.z = (exactQuotient(excess, 1) / deviation).high;
  result.pAsymptotic = normalTwoSidedP(*result.z);
  result.pAsymptoticContinuity = normalTwoSidedP((exactQuotient(corrected, 1) / deviation).high);
}

}  // namespace

MannWhitneyResult mannWhitneyTest(std::span<const double> group1, std::span<const double> group2) {
  return mannWhitneyTest(tiedGroupsOf(group1, group2));
}

MannWhitneyResult mannWhitneyTest(const TiedGroups& groups) {
  MannWhitneyResult result;
  result.n1 = groups.n1;
  result.n2 = groups.n2;
  result.reason = whyNotRanked(groups);
  if (!result.reason.empty()) return result;

  const Placements placements = placementsOf(groups);
  result.u = exactQuotient(placements.sum1, 2).high;
  addExact(result, groups, placements.sum1);
  addAsymptotic(result, groups, placements);
  return result;
}

namespace {

Reason whyUndefined(const TiedGroups& groups) {
  if (groups.n1 < 2) return reason("fewer_than_two", 1);
  if (groups.n2 < 2) return reason("fewer_than_two", 2);
  if (groups.areTooLargeForExactRanks()) return reason("groups_too_large");
  return {};
}

/// 4 n S², S² the variance of the placements: (n Σ (2 placement)² − (Σ 2 placement)²) / (n − 1).
DoubleDouble spread(Int128 n, Int128 sum, Int128 squares) {
  return exactQuotient(n * squares - sum * sum, n - 1);
}

void addProbabilities(BrunnerMunzelResult& result) {
  const StudentDistribution distribution(*result.degreesOfFreedom);
  const double p = distribution.twoSidedP(*result.w);
  result.p = p;
  result.log10P = distribution.log10TwoSidedP(*result.w);
  result.pLess = *result.w > 0.0 ? 0.5 * p : 1.0 - 0.5 * p;
  result.pGreater = *result.w > 0.0 ? 1.0 - 0.5 * p : 0.5 * p;
}

void addTest(BrunnerMunzelResult& result, const Placements& placements) {
  const auto n1 = static_cast<Int128>(result.n1);
  const auto n2 = static_cast<Int128>(result.n2);
  const Int128 excess = n1 * n2 - placements.sum1;  // n₁n₂ − 2U
  const DoubleDouble spread1 = spread(n1, placements.sum1, placements.squares1);
  const DoubleDouble spread2 = spread(n2, placements.sum2, placements.squares2);
  const DoubleDouble both = spread1 + spread2;
  if (both.isZero()) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    result.reason = excess == 0 ? reason("all_values_equal") : reason("no_overlap");
    if (excess != 0) result.w = excess > 0 ? kInfinity : -kInfinity;
    return;
  }
  result.w = (exactQuotient(excess, 1) / squareRoot(both)).high;
  const DoubleDouble share1 = spread1 / both;
  const DoubleDouble share2 = spread2 / both;
  const DoubleDouble inverse =
      share1 * share1 / static_cast<double>(n1 - 1) + share2 * share2 / static_cast<double>(n2 - 1);
  result.degreesOfFreedom = (DoubleDouble(1.0) / inverse).high;
  addProbabilities(result);
}

}  // namespace

BrunnerMunzelResult brunnerMunzelTest(
    std::span<const double> group1, std::span<const double> group2) {
  return brunnerMunzelTest(tiedGroupsOf(group1, group2));
}

BrunnerMunzelResult brunnerMunzelTest(const TiedGroups& groups) {
  BrunnerMunzelResult result;
  result.n1 = groups.n1;
  result.n2 = groups.n2;
  result.reason = whyUndefined(groups);
  if (groups.isEmpty() || groups.areTooLargeForExactRanks()) return result;

  const Placements placements = placementsOf(groups);
  const auto pairs = static_cast<Int128>(groups.n1) * static_cast<Int128>(groups.n2);
  result.probability = exactQuotient(placements.sum2, 2 * pairs).high;
  if (result.reason.empty()) addTest(result, placements);
  return result;
}

}  // namespace analysis

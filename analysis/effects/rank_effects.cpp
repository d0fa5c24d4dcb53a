#include "analysis/effects/rank_effects.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "analysis/numerics/exact_arithmetic.h"
#include "analysis/numerics/fair_coin.h"
#include "analysis/numerics/tail_probabilities.h"

namespace analysis {
namespace {

/// The unbiased variance of δ, from whole numbers: with Pᵢ and Qⱼ the doubled placements,
///
///     (Σ(P − P̄)² + Σ(Q − Q̄)² − Σ(sign − δ)²) / (n₁n₂ (n₁ − 1)(n₂ − 1)).
DoubleDouble unbiasedVariance(const TiedGroups& groups, const Placements& places) {
  const auto n1 = static_cast<Wide>(groups.n1);
  const auto n2 = static_cast<Wide>(groups.n2);
  const Wide pairs = n1 * n2;
  const Wide excess = places.sum1 - pairs;
  const Wide numerator = pairs * (places.squares1 + places.squares2 - pairs + places.equalPairs) -
                         n2 * places.sum1 * places.sum1 - n1 * places.sum2 * places.sum2 +
                         excess * excess;
  return exactQuotient(numerator, pairs) / exactQuotient(pairs, 1) /
         exactQuotient((n1 - 1) * (n2 - 1), 1);
}

Interval fengCliffInterval(
    const DoubleDouble& delta, const DoubleDouble& rest, const DoubleDouble& variance, double z) {
  const DoubleDouble reach = variance * z * z;
  const DoubleDouble middle = delta * rest;
  const DoubleDouble radius = squareRoot(reach * (rest * rest + reach));
  const DoubleDouble under = rest + reach;
  return {.low = ((middle - radius) / under).high, .high = ((middle + radius) / under).high};
}

void addSpread(CliffDelta& result, const TiedGroups& groups, const Placements& places, double z) {
  const auto pairs = static_cast<Wide>(groups.n1) * static_cast<Wide>(groups.n2);
  const Wide excess = places.sum1 - pairs;
  const DoubleDouble variance = unbiasedVariance(groups, places);
  result.variance = variance.high;
  if (excess == pairs || excess == -pairs) {
    result.reason = reason("no_overlap_no_interval");
    return;
  }
  // 1 − δ², without cancellation
  const DoubleDouble rest =
      exactQuotient(pairs - excess, pairs) * exactQuotient(pairs + excess, pairs);
  const DoubleDouble least = rest / exactQuotient(pairs - 1, 1);
  const bool isLess = (variance - least).high < 0.0;
  result.interval =
      fengCliffInterval(exactQuotient(excess, pairs), rest, isLess ? least : variance, z);
}

constexpr std::size_t kMostDifferences = 4000;  // eight million averages

std::vector<double> walshAverages(std::span<const double> differences) {
  std::vector<double> averages;
  averages.reserve(differences.size() * (differences.size() + 1) / 2);
  for (std::size_t i = 0; i < differences.size(); ++i) {
    for (std::size_t j = i; j < differences.size(); ++j) {
      averages.push_back(std::midpoint(differences[i], differences[j]));
    }
  }
  std::ranges::sort(averages);
  return averages;
}

void addInterval(HodgesLehmannResult& result, const std::vector<double>& averages, double level) {
  std::vector<std::uint64_t> ranks(result.n);
  std::iota(ranks.begin(), ranks.end(), std::uint64_t{1});
  if (!SubsetSums::isFeasible(ranks)) {
    result.reason = reason("too_many_for_interval");
    return;
  }
  const SubsetSums law(ranks);
  const double tail = 0.5 * (1.0 - level);
  if (law.atMost(0) > tail) {
    result.reason = reason("no_such_confidence");
    return;
  }
  std::uint64_t low = 0;  // the largest sum of ranks that would be rejected
  for (std::uint64_t high = averages.size(); high - low > 1;) {
    const std::uint64_t middle = std::midpoint(low, high);
    (law.atMost(middle) > tail ? high : low) = middle;
  }
  result.confidence = 1.0 - 2.0 * law.atMost(low);
  result.interval = Interval{.low = averages[low], .high = averages[averages.size() - 1 - low]};
}

}  // namespace

CliffDelta cliffDelta(
    std::span<const double> group1, std::span<const double> group2, double level) {
  return cliffDelta(tiedGroupsOf(group1, group2), level);
}

CliffDelta cliffDelta(const TiedGroups& groups, double level) {
  const double z = normalTwoSidedQuantile(level);
  CliffDelta result;
  result.n1 = groups.n1;
  result.n2 = groups.n2;
  if (groups.isEmpty() || groups.areTooLarge()) {
    result.reason = groups.isEmpty() ? reason("a_group_is_empty") : reason("groups_too_large");
    return result;
  }
  const Placements places = placementsOf(groups);
  const auto pairs = static_cast<Wide>(groups.n1) * static_cast<Wide>(groups.n2);
  result.delta = exactQuotient(places.sum1 - pairs, pairs).high;
  result.probabilityOfSuperiority = exactQuotient(places.sum1, 2 * pairs).high;
  if (groups.n1 < 2 || groups.n2 < 2) {
    result.reason = reason("two_values_needed");
    return result;
  }
  addSpread(result, groups, places, z);
  return result;
}

HodgesLehmannResult hodgesLehmann(std::span<const double> differences, double level) {
  if (!(level > 0.0 && level < 1.0)) {
    throw std::invalid_argument("a confidence level lies between 0 and 1");
  }
  if (!std::ranges::all_of(differences, [](double number) { return std::isfinite(number); })) {
    throw std::invalid_argument("a difference is infinite or no number");
  }
  HodgesLehmannResult result;
  result.n = differences.size();
  if (differences.empty() || differences.size() > kMostDifferences) {
    result.reason = differences.empty() ? reason("no_differences") : reason("too_many_averages");
    return result;
  }
  const auto averages = walshAverages(differences);
  const std::size_t half = averages.size() / 2;
  result.estimate =
      averages.size() % 2 == 1 ? averages[half] : std::midpoint(averages[half - 1], averages[half]);
  addInterval(result, averages, level);
  return result;
}

}  // namespace analysis

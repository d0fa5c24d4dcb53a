#include "analysis/effects/cliff_delta.h"

#include "analysis/numerics/double_double.h"
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

}  // namespace

CliffDelta cliffDelta(
    std::span<const double> group1, std::span<const double> group2, double level) {
  return cliffDelta(tiedGroupsOf(group1, group2), level);
}

CliffDelta cliffDelta(const LikertCounts& group1, const LikertCounts& group2, double level) {
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

}  // namespace analysis

#include "analysis/tests/mann_whitney.h"

#include <algorithm>

#include "analysis/numerics/exact_arithmetic.h"
#include "analysis/numerics/tail_probabilities.h"
#include "analysis/tests/rank_sums.h"

namespace analysis {
namespace {

Reason whyNotRanked(const TiedGroups& groups) {
  if (groups.n1 == 0) return reason("group_is_empty", 1);
  if (groups.n2 == 0) return reason("group_is_empty", 2);
  if (groups.areTooLarge()) return reason("groups_too_large");
  return {};
}

void addExact(MannWhitneyResult& result, const TiedGroups& groups, Wide doubledU) {
  if (!RankSums::canHold(groups)) {
    result.reason = reason("too_many_values");
    return;
  }
  const RankSums law(groups);
  const auto u = static_cast<std::int64_t>(doubledU);
  result.pLess = law.atMost(u);
  result.pGreater = law.atLeast(u);
  result.p = std::min(1.0, 2.0 * std::min(*result.pLess, *result.pGreater));
  result.pAbs = law.asFar(u);
}

void addAsymptotic(MannWhitneyResult& result, const TiedGroups& groups, const Placements& places) {
  const auto pairs = static_cast<Wide>(groups.n1) * static_cast<Wide>(groups.n2);
  const auto all = static_cast<Wide>(groups.n1) + static_cast<Wide>(groups.n2);
  const Wide untied = all * all * all - all - places.tieSum;
  const DoubleDouble variance =
      exactQuotient(untied, 12 * all * (all - 1)) * exactQuotient(pairs, 1);
  result.variance = variance.high;
  if (untied == 0) {
    result.reason = reason("all_values_equal");
    return;
  }
  const Wide excess = places.sum1 - pairs;  // 2 (U − its mean)
  // The continuity correction moves U by ½, that is 2U by 1, towards its mean.
  const Wide corrected = excess > 0 ? excess - 1 : excess < 0 ? excess + 1 : 0;
  const DoubleDouble deviation = squareRoot(variance) * 2.0;
  result.z = (exactQuotient(excess, 1) / deviation).high;
  result.pAsymptotic = normalTwoSidedP(*result.z);
  result.log10PAsymptotic = log10NormalTwoSidedP(*result.z);
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

  const Placements places = placementsOf(groups);
  result.u = exactQuotient(places.sum1, 2).high;
  addExact(result, groups, places.sum1);
  addAsymptotic(result, groups, places);
  return result;
}

}  // namespace analysis

#include "analysis/tests/brunner_munzel.h"

#include <limits>

#include "analysis/numerics/exact_arithmetic.h"
#include "analysis/numerics/student_distribution.h"

namespace analysis {
namespace {

Reason whyUndefined(const TiedGroups& groups) {
  if (groups.n1 < 2) return reason("fewer_than_two", 1);
  if (groups.n2 < 2) return reason("fewer_than_two", 2);
  if (groups.areTooLarge()) return reason("groups_too_large");
  return {};
}

/// 4 n S²: n Σ (2 placement)² − (Σ 2 placement)², over n − 1.
DoubleDouble spread(Wide n, Wide sum, Wide squares) {
  return exactQuotient(n * squares - sum * sum, n - 1);
}

void addProbabilities(BrunnerMunzelResult& result) {
  const StudentDistribution law(*result.degreesOfFreedom);
  const double p = law.twoSidedP(*result.w);
  result.p = p;
  result.log10P = law.log10TwoSidedP(*result.w);
  result.pLess = *result.w > 0.0 ? 0.5 * p : 1.0 - 0.5 * p;
  result.pGreater = *result.w > 0.0 ? 1.0 - 0.5 * p : 0.5 * p;
}

void addTest(BrunnerMunzelResult& result, const Placements& places) {
  const auto n1 = static_cast<Wide>(result.n1);
  const auto n2 = static_cast<Wide>(result.n2);
  const Wide excess = n1 * n2 - places.sum1;  // n₁n₂ − 2U
  const DoubleDouble spread1 = spread(n1, places.sum1, places.squares1);
  const DoubleDouble spread2 = spread(n2, places.sum2, places.squares2);
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
  if (groups.isEmpty() || groups.areTooLarge()) return result;

  const Placements places = placementsOf(groups);
  const auto pairs = static_cast<Wide>(groups.n1) * static_cast<Wide>(groups.n2);
  result.probability = exactQuotient(places.sum2, 2 * pairs).high;
  if (result.reason.empty()) addTest(result, places);
  return result;
}

}  // namespace analysis

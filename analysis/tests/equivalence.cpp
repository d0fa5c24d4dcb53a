#include "analysis/tests/equivalence.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "analysis/numerics/student_distribution.h"

namespace analysis {
namespace {

/// P(T ≥ t).
OneSidedTest upperTail(double t, const StudentDistribution& law) {
  if (std::isinf(t)) return {.t = t, .p = t > 0.0 ? 0.0 : 1.0, .log10P = std::nullopt};
  const double half = 0.5 * law.twoSidedP(t);
  if (t < 0.0) return {.t = t, .p = 1.0 - half, .log10P = std::log1p(-half) / std::numbers::ln10};
  return {.t = t, .p = half, .log10P = law.log10TwoSidedP(t) - std::log10(2.0)};
}

/// P(T ≤ t).
OneSidedTest lowerTail(double t, const StudentDistribution& law) {
  OneSidedTest test = upperTail(-t, law);
  test.t = t;
  return test;
}

EquivalenceResult twoOneSidedTests(
    const std::optional<double>& difference,
    const std::optional<double>& standardError,
    const std::optional<double>& degreesOfFreedom,
    const EquivalenceBounds& bounds,
    const Reason& whyNone) {
  if (!(bounds.lower < bounds.upper) || !std::isfinite(bounds.lower) ||
      !std::isfinite(bounds.upper)) {
    throw std::invalid_argument("the lower bound of equivalence lies below the upper one");
  }
  EquivalenceResult result;
  result.bounds = bounds;
  if (!difference || !standardError || !degreesOfFreedom) {
    result.reason = whyNone;
    return result;
  }

  const StudentDistribution law(*degreesOfFreedom);
  const OneSidedTest above = upperTail((*difference - bounds.lower) / *standardError, law);
  const OneSidedTest below = lowerTail((*difference - bounds.upper) / *standardError, law);
  result.aboveLower = above;
  result.belowUpper = below;
  result.p = std::max(above.p, below.p);
  if (above.log10P && below.log10P) result.log10P = std::max(*above.log10P, *below.log10P);
  if (!result.log10P) result.reason = reason("t_too_large");
  return result;
}

}  // namespace

EquivalenceResult equivalenceTest(const WelchResult& test, const EquivalenceBounds& bounds) {
  return twoOneSidedTests(
      test.difference, test.standardError, test.degreesOfFreedom, bounds, test.reason);
}

EquivalenceResult equivalenceTest(const PairedTResult& test, const EquivalenceBounds& bounds) {
  return twoOneSidedTests(
      test.meanDifference, test.standardError, test.degreesOfFreedom, bounds, test.reason);
}

}  // namespace analysis

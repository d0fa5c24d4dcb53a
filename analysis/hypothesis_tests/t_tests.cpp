#include "analysis/hypothesis_tests/t_tests.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "analysis/data/moments.h"
#include "analysis/numerics/distributions.h"

namespace analysis {
namespace {

Reason tooFew(int group, std::uint64_t n) {
  return n == 0 ? reason("group_empty_needs_two", group) : reason("group_of_one_needs_two", group);
}

/// Why the test is not defined; empty if it is defined.
Reason whyUndefined(const Moments& group1, const Moments& group2) {
  if (group1.n < 2) return tooFew(1, group1.n);
  if (group2.n < 2) return tooFew(2, group2.n);
  if (!group1.isConstant() || !group2.isConstant()) return {};

  const Contrast contrast = contrastOf(group1, group2);
  return contrast.difference.isZero() ? reason("constant_equal") : reason("constant_differ");
}

/// Welch–Satterthwaite degrees of freedom ν, from v = s²/n of each group.
double welchSatterthwaite(const DoubleDouble& v1, double n1, const DoubleDouble& v2, double n2) {
  const DoubleDouble share1 = v1 / (v1 + v2);
  const DoubleDouble share2 = v2 / (v1 + v2);
  const DoubleDouble inverse = share1 * share1 / (n1 - 1.0) + share2 * share2 / (n2 - 1.0);
  return (DoubleDouble(1.0) / inverse).high;
}

template <typename Result>
void addProbabilities(Result& result) {
  const double t = *result.t;
  const StudentDistribution distribution(*result.degreesOfFreedom);
  const double p = distribution.twoSidedP(t);
  result.p = p;
  result.log10P = distribution.log10TwoSidedP(t);
  result.pLess = t < 0.0 ? 0.5 * p : 1.0 - 0.5 * p;
  result.pGreater = t < 0.0 ? 1.0 - 0.5 * p : 0.5 * p;
}

void addTest(WelchResult& result, const Contrast& contrast) {
  const auto n1 = static_cast<double>(result.n1);
  const auto n2 = static_cast<double>(result.n2);
  const DoubleDouble v1 = contrast.variance1 / n1;
  const DoubleDouble v2 = contrast.variance2 / n2;
  const DoubleDouble standardError = squareRoot(v1 + v2);
  const double t = tOf(contrast, standardError);

  result.standardError = toDouble(standardError, contrast.spreadExponent);
  result.t = t;
  if (standardError.isZero()) {
    if (contrast.difference.isZero()) result.t.reset();
    return;
  }
  result.degreesOfFreedom = welchSatterthwaite(v1, n1, v2, n2);
  if (!std::isfinite(t)) return;
  addProbabilities(result);
}

Reason whyIncomplete(const WelchResult& result) {
  if (result.t && !std::isfinite(*result.t)) return reason("t_too_large");
  if (!result.variance1 || !result.variance2) {
    return reason("variance_beyond_double");
  }
  if (!result.difference || !result.standardError) {
    return reason("difference_beyond_double_df");
  }
  return {};
}

}  // namespace

WelchResult welchTTest(std::span<const double> group1, std::span<const double> group2) {
  return welchTTest(momentsOf(group1), momentsOf(group2));
}

WelchResult welchTTest(const Moments& group1, const Moments& group2) {
  const Summary summary1 = summarise(group1);
  const Summary summary2 = summarise(group2);
  WelchResult result;
  result.n1 = group1.n;
  result.n2 = group2.n;
  result.mean1 = summary1.mean;
  result.mean2 = summary2.mean;
  result.variance1 = summary1.variance;
  result.variance2 = summary2.variance;
  if (group1.n > 0 && group2.n > 0) {
    const Contrast contrast = contrastOf(group1, group2);
    result.difference = toDouble(contrast.difference, contrast.meanExponent);
    if (group1.n > 1 && group2.n > 1) addTest(result, contrast);
  }
  result.reason = whyUndefined(group1, group2);
  if (result.reason.empty()) result.reason = whyIncomplete(result);
  return result;
}

std::optional<Interval> confidenceInterval(const WelchResult& result, double level) {
  return studentInterval(result.difference, result.standardError, result.degreesOfFreedom, level);
}

StudentResult studentTTest(std::span<const double> group1, std::span<const double> group2) {
  return studentTTest(momentsOf(group1), momentsOf(group2));
}

StudentResult studentTTest(const Moments& group1, const Moments& group2) {
  StudentResult result;
  if (group1.n == 0 || group2.n == 0 || group1.n + group2.n < 3) return result;

  const auto n1 = static_cast<double>(group1.n);
  const auto n2 = static_cast<double>(group2.n);
  const Contrast contrast = contrastOf(group1, group2);
  const DoubleDouble squares = contrast.variance1 * (n1 - 1.0) + contrast.variance2 * (n2 - 1.0);
  const DoubleDouble pooled = squares / (n1 + n2 - 2.0);
  const double t = tOf(contrast, squareRoot(pooled * (DoubleDouble(n1) + n2) / n1 / n2));
  if (pooled.isZero() && t == 0.0) return result;

  result.t = t;
  if (pooled.isZero()) return result;

  result.degreesOfFreedom = n1 + n2 - 2.0;
  if (std::isfinite(t)) result.p = StudentDistribution(*result.degreesOfFreedom).twoSidedP(t);
  return result;
}

namespace {

bool isNumber(double value) {
  return std::isfinite(value);
}

std::vector<double> differencesOf(std::span<const double> x, std::span<const double> y) {
  if (x.size() != y.size()) throw std::invalid_argument("a pair has two values");
  if (!std::ranges::all_of(x, isNumber) || !std::ranges::all_of(y, isNumber)) {
    throw std::invalid_argument("a value is infinite or no number: it has no place in a mean");
  }
  std::vector<double> differences;
  differences.reserve(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) differences.push_back(x[i] - y[i]);
  return differences;
}

/// Where all differences are the same up to rounding errors, makes them equal; zero if that is what
/// they are.
void makeEqualUpToRounding(std::vector<double>& differences, double size) {
  const auto [least, greatest] = std::ranges::minmax(differences);
  if (!isRoundingError(greatest - least, size)) return;
  const double same = isRoundingError(differences.front(), size) ? 0.0 : differences.front();
  std::ranges::fill(differences, same);
}

Reason whyUndefined(const Moments& differences) {
  if (differences.n == 0) return reason("no_pairs");
  if (differences.n == 1) return reason("one_pair");
  if (!differences.isConstant()) return {};
  return differences.mean.isZero() ? reason("pairs_equal") : reason("differences_same");
}

void addTest(PairedTResult& result, const Moments& differences) {
  const auto n = static_cast<double>(differences.n);
  const DoubleDouble standardError = squareRoot(differences.variance / n);
  result.variance = toDouble(differences.variance, 2 * differences.exponent);
  result.standardError = toDouble(standardError, differences.exponent);
  if (differences.isConstant()) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    if (!differences.mean.isZero()) result.t = std::copysign(kInfinity, differences.mean.high);
    return;
  }
  result.t = (differences.mean / standardError).high;
  result.degreesOfFreedom = n - 1.0;
  addProbabilities(result);
}

}  // namespace

PairedTResult pairedTTest(std::span<const double> x, std::span<const double> y) {
  double size = 0.0;
  for (const double value : x) size = std::max(size, std::abs(value));
  for (const double value : y) size = std::max(size, std::abs(value));
  return pairedTTest(differencesOf(x, y), size);
}

PairedTResult pairedTTest(std::vector<double> values, double size) {
  PairedTResult result;
  result.n = values.size();
  if (!std::ranges::all_of(values, isNumber)) {
    result.reason = reason("difference_beyond_double");
    return result;
  }

  if (!values.empty()) makeEqualUpToRounding(values, size);
  const Moments differences = momentsOf(values);
  if (differences.n > 0) {
    result.meanDifference = toDouble(differences.mean, differences.exponent);
  }
  if (differences.n > 1) addTest(result, differences);
  result.reason = whyUndefined(differences);
  if (!result.reason.empty()) return result;

  if (!result.meanDifference || !result.variance || !result.standardError) {
    result.reason = reason("moment_beyond_double");
  }
  return result;
}

std::optional<Interval> confidenceInterval(const PairedTResult& result, double level) {
  return studentInterval(
      result.meanDifference, result.standardError, result.degreesOfFreedom, level);
}

namespace {

/// P(T ≥ t).
OneSidedTest upperTail(double t, const StudentDistribution& distribution) {
  if (std::isinf(t)) return {.t = t, .p = t > 0.0 ? 0.0 : 1.0, .log10P = std::nullopt};
  const double half = 0.5 * distribution.twoSidedP(t);
  if (t < 0.0) return {.t = t, .p = 1.0 - half, .log10P = std::log1p(-half) / std::numbers::ln10};
  return {.t = t, .p = half, .log10P = distribution.log10TwoSidedP(t) - std::log10(2.0)};
}

/// P(T ≤ t).
OneSidedTest lowerTail(double t, const StudentDistribution& distribution) {
  OneSidedTest test = upperTail(-t, distribution);
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

  const StudentDistribution distribution(*degreesOfFreedom);
  const OneSidedTest above = upperTail((*difference - bounds.lower) / *standardError, distribution);
  const OneSidedTest below = lowerTail((*difference - bounds.upper) / *standardError, distribution);
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

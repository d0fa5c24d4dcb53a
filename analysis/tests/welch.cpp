#include "analysis/tests/welch.h"

#include <cmath>
#include <stdexcept>

#include "analysis/data/moments.h"
#include "analysis/numerics/student_distribution.h"

namespace analysis {
namespace {

Reason tooFew(int group, std::uint64_t n) {
  return n == 0 ? reason("group_empty_needs_two", group) : reason("group_of_one_needs_two", group);
}

/// Why the test itself is not defined; empty where it is.
Reason whyUndefined(const Moments& group1, const Moments& group2) {
  if (group1.n < 2) return tooFew(1, group1.n);
  if (group2.n < 2) return tooFew(2, group2.n);
  if (!group1.isConstant() || !group2.isConstant()) return {};

  const Contrast contrast = contrastOf(group1, group2);
  return contrast.difference.isZero() ? reason("constant_equal") : reason("constant_differ");
}

/// ν for v = s²/n of either group.
double welchSatterthwaite(const DoubleDouble& v1, double n1, const DoubleDouble& v2, double n2) {
  const DoubleDouble share1 = v1 / (v1 + v2);
  const DoubleDouble share2 = v2 / (v1 + v2);
  const DoubleDouble inverse = share1 * share1 / (n1 - 1.0) + share2 * share2 / (n2 - 1.0);
  return (DoubleDouble(1.0) / inverse).high;
}

void addProbabilities(WelchResult& result) {
  const double t = *result.t;
  const StudentDistribution law(*result.degreesOfFreedom);
  const StudentDistribution toolpak(std::floor(*result.degreesOfFreedom + 0.5));
  const double p = law.twoSidedP(t);

  result.p = p;
  result.log10P = law.log10TwoSidedP(t);
  result.pLess = t < 0.0 ? 0.5 * p : 1.0 - 0.5 * p;
  result.pGreater = t < 0.0 ? 1.0 - 0.5 * p : 0.5 * p;
  result.pToolpak = toolpak.twoSidedP(t);
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
  if (std::isfinite(t)) addProbabilities(result);
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

WelchResult welchTTest(const LikertCounts& group1, const LikertCounts& group2) {
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
  if (!(level > 0.0 && level < 1.0)) {
    throw std::invalid_argument("a confidence level lies between 0 and 1");
  }
  if (!result.difference || !result.standardError || !result.degreesOfFreedom) return std::nullopt;

  const StudentDistribution law(*result.degreesOfFreedom);
  const double reach = law.twoSidedQuantile(1.0 - level) * *result.standardError;
  if (!std::isfinite(std::abs(*result.difference) + reach)) return std::nullopt;
  return Interval{.low = *result.difference - reach, .high = *result.difference + reach};
}

}  // namespace analysis

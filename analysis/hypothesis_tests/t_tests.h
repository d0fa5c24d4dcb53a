#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "analysis/data/likert_counts.h"
#include "analysis/data/moments.h"
#include "analysis/data/reason.h"
#include "analysis/numerics/interval.h"

namespace analysis {

/// The result of Welch's t-test. An undefined number is std::nullopt, and `reason` says why.
struct WelchResult {
  std::uint64_t n1 = 0;
  std::uint64_t n2 = 0;
  std::optional<double> mean1;
  std::optional<double> mean2;
  std::optional<double> variance1;  ///< divided by n − 1
  std::optional<double> variance2;

  std::optional<double> difference;     ///< mean of group 1 − mean of group 2
  std::optional<double> standardError;  ///< of the difference
  std::optional<double> t;  ///< ±infinity for constant groups that differ, and beyond a double
  std::optional<double> degreesOfFreedom;  ///< Welch–Satterthwaite; rarely a whole number

  std::optional<double> p;         ///< two-sided, not yet adjusted for the number of tests
  std::optional<double> log10P;    ///< defined even if p is too small for a double
  std::optional<double> pLess;     ///< one-sided; alternative: group 1 < group 2
  std::optional<double> pGreater;  ///< one-sided; alternative: group 1 > group 2

  Reason reason;  ///< why something above is missing; empty if nothing is
};

/// Welch's t-test: do two groups differ in their mean, if their variances may differ too?
///
///     t = (m₁ − m₂) / √(s₁²/n₁ + s₂²/n₂)
///     ν = (s₁²/n₁ + s₂²/n₂)² / ((s₁²/n₁)² / (n₁ − 1) + (s₂²/n₂)² / (n₂ − 1))
///     p = P(|T| ≥ |t|),  T of Student's t distribution with ν degrees of freedom
///
/// Difference and variances are computed with 31 digits and a larger range than a double's, so that
/// an offset of 1e9 or values of 1e-200 cost no accuracy. The spreadsheet's Analysis ToolPak rounds
/// ν to the nearest whole number.
///
/// The test is not defined for a group of fewer than two values, nor if both groups are constant,
/// as can happen in small panels on a Likert scale.
///
/// @throws std::invalid_argument  if a value is infinite or NaN.
WelchResult welchTTest(std::span<const double> group1, std::span<const double> group2);
WelchResult welchTTest(const Moments& group1, const Moments& group2);

/// The confidence interval of the difference of the means at @p level, for instance 0.95;
/// std::nullopt if the test is not defined or a limit is beyond what a double can hold.
///
/// @throws std::invalid_argument  for a level that is not between 0 and 1.
std::optional<Interval> confidenceInterval(const WelchResult& result, double level);

/// The result of Student's t-test of two groups. If it is not defined, all numbers are
/// std::nullopt.
struct StudentResult {
  std::optional<double> t;                 ///< ±infinity for two constant groups that differ
  std::optional<double> degreesOfFreedom;  ///< n₁ + n₂ − 2
  std::optional<double> p;                 ///< two-sided
};

/// Student's t-test, which assumes that both groups have the same variance.
///
///     t = (m₁ − m₂) / √(s² (1/n₁ + 1/n₂)),   s² = ((n₁ − 1) s₁² + (n₂ − 1) s₂²) / (n₁ + n₂ − 2)
///
/// Used for comparison with published results. Otherwise use welchTTest(), which does not assume
/// equal variances.
///
/// @throws std::invalid_argument  if a value is infinite or NaN.
StudentResult studentTTest(std::span<const double> group1, std::span<const double> group2);
StudentResult studentTTest(const Moments& group1, const Moments& group2);

/// The result of the paired t-test. An undefined number is std::nullopt, and `reason` says why.
struct PairedTResult {
  std::uint64_t n = 0;  ///< number of pairs

  std::optional<double> meanDifference;  ///< of x − y
  std::optional<double> variance;        ///< of the differences, divided by n − 1
  std::optional<double> standardError;   ///< of their mean
  std::optional<double> t;               ///< ±infinity for differences that are all the same
  std::optional<double> degreesOfFreedom;

  std::optional<double> p;         ///< two-sided, not yet adjusted for the number of tests
  std::optional<double> log10P;    ///< defined even if p is too small for a double
  std::optional<double> pLess;     ///< one-sided; alternative: x < y
  std::optional<double> pGreater;  ///< one-sided; alternative: x > y

  Reason reason;  ///< why something above is missing; empty if nothing is
};

/// The paired t-test: do the same participants answer differently under two conditions?
///
///     t = d̄ / (s_d / √n),   d = x − y,   n − 1 degrees of freedom
///
/// The differences are computed as doubles, so that rank tests of them use the same numbers; their
/// mean and variance are computed with 31 digits.
///
/// The test is not defined for fewer than two pairs, nor for differences that are all the same:
/// that differ by rounding errors only (isRoundingError()).
///
/// @throws std::invalid_argument  if there are not as many y as x, or a value is infinite or NaN.
PairedTResult pairedTTest(std::span<const double> x, std::span<const double> y);

/// The same test of differences that are already computed.
///
/// @param size  the largest magnitude of what they were computed from.
PairedTResult pairedTTest(std::vector<double> differences, double size);

/// The confidence interval of the mean difference at @p level, for instance 0.95; std::nullopt if
/// the test is not defined or a limit is beyond what a double can hold.
///
/// @throws std::invalid_argument  for a level that is not between 0 and 1.
std::optional<Interval> confidenceInterval(const PairedTResult& result, double level);

/// The equivalence margins: a difference between them is too small to matter. A protocol sets them,
/// in units of the scale.
struct EquivalenceBounds {
  double lower = 0.0;
  double upper = 0.0;
};

/// One of the two one-sided tests.
struct OneSidedTest {
  double t = 0.0;  ///< (difference − bound) / standard error; ±infinity beyond a double
  double p = 1.0;
  std::optional<double> log10P;  ///< defined even if p is too small for a double
};

/// Whether two conditions are equivalent within the bounds.
struct EquivalenceResult {
  EquivalenceBounds bounds;
  std::optional<OneSidedTest> aboveLower;  ///< small p: the difference is above the lower bound
  std::optional<OneSidedTest> belowUpper;  ///< small p: the difference is below the upper bound
  std::optional<double> p;                 ///< the larger p of the two tests
  std::optional<double> log10P;
  Reason reason;  ///< why something above is missing; empty if nothing is
};

/// Two one-sided tests (Schuirmann 1987; Lakens 2017): is the difference within the bounds?
///
///     p = max(P(T ≥ (diff − lower) / se), P(T ≤ (diff − upper) / se))
///
/// With p ≤ α, the confidence interval of the difference at 1 − 2α lies within the bounds. A
/// difference that is not significant is no evidence of equivalence.
///
/// Not defined if the t-test is not defined.
///
/// @throws std::invalid_argument  unless lower < upper, both finite.
EquivalenceResult equivalenceTest(const WelchResult& test, const EquivalenceBounds& bounds);
EquivalenceResult equivalenceTest(const PairedTResult& test, const EquivalenceBounds& bounds);

}  // namespace analysis

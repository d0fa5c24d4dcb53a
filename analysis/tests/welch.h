#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "analysis/data/likert_counts.h"
#include "analysis/data/moments.h"
#include "analysis/data/reason.h"
#include "analysis/numerics/interval.h"

namespace analysis {

/// What Welch's t-test says about two groups. What is not defined is missing,
/// with a reason.
struct WelchResult {
  std::uint64_t n1 = 0;
  std::uint64_t n2 = 0;
  std::optional<double> mean1;
  std::optional<double> mean2;
  std::optional<double> variance1;  ///< with n − 1
  std::optional<double> variance2;

  std::optional<double> difference;     ///< mean of group 1 − mean of group 2
  std::optional<double> standardError;  ///< of the difference
  std::optional<double> t;  ///< ±infinity for constant groups that differ, and beyond a double
  std::optional<double> degreesOfFreedom;  ///< Welch–Satterthwaite; rarely a whole number

  std::optional<double> p;         ///< two-sided, not yet adjusted for the number of tests
  std::optional<double> log10P;    ///< of p; also where p is too small for a double
  std::optional<double> pLess;     ///< if only group 1 < group 2 were of interest
  std::optional<double> pGreater;  ///< if only group 1 > group 2 were of interest
  std::optional<double> pToolpak;  ///< two-sided, as the spreadsheet has it

  Reason reason;  ///< why something above is missing; empty if nothing is
};

/// Welch's t-test: do two groups differ in their mean, if their variances may differ too?
///
///     t = (m₁ − m₂) / √(s₁²/n₁ + s₂²/n₂)
///     ν = (s₁²/n₁ + s₂²/n₂)² / ((s₁²/n₁)² / (n₁ − 1) + (s₂²/n₂)² / (n₂ − 1))
///     p = P(|T| ≥ |t|),  T of Student's law with ν degrees of freedom
///
/// The difference and the variances are taken with 31 digits and beyond a double's range, so that
/// an offset of 1e9 or values of 1e-200 cost nothing. The spreadsheet's Analysis ToolPak rounds ν
/// to the nearest whole number.
///
/// The test is not defined for a group of fewer than two, nor for two groups that each answered
/// with one voice. Small panels on a Likert scale do that.
///
/// @throws std::invalid_argument  if a value is infinite or NaN.
WelchResult welchTTest(std::span<const double> group1, std::span<const double> group2);
WelchResult welchTTest(const LikertCounts& group1, const LikertCounts& group2);
WelchResult welchTTest(const Moments& group1, const Moments& group2);

/// Where the difference of the means lies, with a confidence of @p level, for instance 0.95;
/// std::nullopt if the test is not defined or a limit is beyond what a double can hold.
///
/// @throws std::invalid_argument  for a level that is not between 0 and 1.
std::optional<Interval> confidenceInterval(const WelchResult& result, double level);

}  // namespace analysis

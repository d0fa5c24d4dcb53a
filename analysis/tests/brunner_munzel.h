#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "analysis/data/ranks.h"
#include "analysis/data/reason.h"

namespace analysis {

/// What Brunner & Munzel's test says about two groups. What is not defined is missing,
/// with a reason.
struct BrunnerMunzelResult {
  std::uint64_t n1 = 0;
  std::uint64_t n2 = 0;
  std::optional<double> probability;  ///< P(X < Y) + ½ P(X = Y), X of group 1, Y of group 2
  std::optional<double> w;  ///< positive if group 2 ranks higher; ±infinity without overlap
  std::optional<double> degreesOfFreedom;  ///< as in Welch's test; rarely a whole number
  std::optional<double> p;                 ///< two-sided
  std::optional<double> log10P;            ///< also where p is too small for a double
  std::optional<double> pLess;             ///< if only group 1 < group 2 were of interest
  std::optional<double> pGreater;          ///< if only group 1 > group 2 were of interest
  Reason reason;                           ///< why something above is missing; empty if nothing is
};

/// Brunner & Munzel's test (2000, Biometrical Journal 42): does one group tend to larger values, if
/// they may be scattered differently? With U as in mannWhitneyTest() and Sᵢ² the variance of group
/// i's placements (ranks among all − ranks in its own group),
///
///     W = (n₁n₂/2 − U) / √(n₁S₁² + n₂S₂²)
///     ν = (n₁S₁² + n₂S₂²)² / ((n₁S₁²)²/(n₁ − 1) + (n₂S₂²)²/(n₂ − 1)),   p of Student's law with ν
///
/// Undefined for a group of fewer than two, and where the placements do not vary: groups that do
/// not overlap, or all values equal.
///
/// @throws std::invalid_argument  if a value is infinite or NaN.
BrunnerMunzelResult brunnerMunzelTest(
    std::span<const double> group1, std::span<const double> group2);
BrunnerMunzelResult brunnerMunzelTest(const TiedGroups& groups);

}  // namespace analysis

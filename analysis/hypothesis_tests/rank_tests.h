#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "analysis/data/ranks.h"
#include "analysis/data/reason.h"
#include "analysis/numerics/exact_arithmetic.h"

namespace analysis {

/// The exact distribution of Mann & Whitney's U if each choice of n₁ of all values as group 1 is
/// equally likely. Uses the midranks of the data, ties included, and computes by dynamic
/// programming over rank sums with 31 digits.
class RankSumDistribution {
 public:
  /// Whether the distribution fits into memory and is computed within about a second: two groups of
  /// some 50 values.
  static bool isComputable(const TiedGroups& groups);

  /// @throws std::invalid_argument  for groups that isComputable() refuses, and for an empty one.
  explicit RankSumDistribution(const TiedGroups& groups);

  /// P(2U ≤ u)
  double atMost(std::int64_t doubledU) const;
  /// P(2U ≥ u)
  double atLeast(std::int64_t doubledU) const;

 private:
  std::int64_t doubledUAt(std::size_t index) const;

  std::int64_t least_ = 0;
  std::int64_t step_ = 1;  // negative if group 2 is smaller, because its rank sums are then counted
  std::vector<DoubleDouble> probabilities_;
};

/// The result of the Mann–Whitney test. An undefined number is std::nullopt, and `reason` says why.
struct MannWhitneyResult {
  std::uint64_t n1 = 0;
  std::uint64_t n2 = 0;
  /// Number of pairs in which the value of group 1 is larger; equal pairs count half.
  std::optional<double> u;
  std::optional<double> variance;  ///< of U, ties taken into account; zero if all values are equal

  std::optional<double> p;         ///< exact, two-sided: 2 min(P(≤ U), P(≥ U)), at most 1
  std::optional<double> pLess;     ///< exact, one-sided: P(≤ U); alternative: group 1 < group 2
  std::optional<double> pGreater;  ///< exact, one-sided: P(≥ U); alternative: group 1 > group 2

  std::optional<double> z;                      ///< normal, without continuity correction
  std::optional<double> pAsymptotic;            ///< two-sided, of z
  std::optional<double> pAsymptoticContinuity;  ///< with U moved by ½ towards its mean

  Reason reason;  ///< why something above is missing; empty if nothing is
};

/// Mann & Whitney's test (1947), which is Wilcoxon's rank sum test: does one group tend to larger
/// values?
///
///     U = #{x > y} + ½ #{x = y}
///     σ² = n₁ n₂ / 12 · (N + 1 − Σ (t³ − t) / (N (N − 1))),   N = n₁ + n₂
///
/// The exact p values (see RankSumDistribution) exist for two groups of up to about 50 values, or
/// if one group is very small.
///
/// @throws std::invalid_argument  if a value is infinite or NaN.
MannWhitneyResult mannWhitneyTest(std::span<const double> group1, std::span<const double> group2);
MannWhitneyResult mannWhitneyTest(const TiedGroups& groups);

/// The result of the Brunner–Munzel test. An undefined number is std::nullopt, and `reason` says
/// why.
struct BrunnerMunzelResult {
  std::uint64_t n1 = 0;
  std::uint64_t n2 = 0;
  std::optional<double> probability;  ///< P(X < Y) + ½ P(X = Y), X of group 1, Y of group 2
  std::optional<double> w;  ///< positive if group 2 ranks higher; ±infinity without overlap
  std::optional<double> degreesOfFreedom;  ///< as in Welch's test; rarely a whole number
  std::optional<double> p;                 ///< two-sided
  std::optional<double> log10P;            ///< defined even if p is too small for a double
  std::optional<double> pLess;             ///< one-sided; alternative: group 1 < group 2
  std::optional<double> pGreater;          ///< one-sided; alternative: group 1 > group 2
  Reason reason;                           ///< why something above is missing; empty if nothing is
};

/// Brunner & Munzel's test (2000, Biometrical Journal 42): does one group tend to larger values, if
/// their spreads may differ? With U as in mannWhitneyTest() and Sᵢ² the variance of group i's
/// placements (ranks among all − ranks in its own group),
///
///     W = (n₁n₂/2 − U) / √(n₁S₁² + n₂S₂²)
///     ν = (n₁S₁² + n₂S₂²)² / ((n₁S₁²)²/(n₁ − 1) + (n₂S₂²)²/(n₂ − 1))
///     p from Student's t distribution with ν degrees of freedom
///
/// Not defined for a group of fewer than two values, or if the placements do not vary: the groups
/// do not overlap, or all values are equal.
///
/// @throws std::invalid_argument  if a value is infinite or NaN.
BrunnerMunzelResult brunnerMunzelTest(
    std::span<const double> group1, std::span<const double> group2);
BrunnerMunzelResult brunnerMunzelTest(const TiedGroups& groups);

}  // namespace analysis

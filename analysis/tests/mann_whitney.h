#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "analysis/data/ranks.h"
#include "analysis/data/reason.h"

namespace analysis {

/// What Mann & Whitney's test says about two groups. What is not defined is missing, with
/// a reason.
struct MannWhitneyResult {
  std::uint64_t n1 = 0;
  std::uint64_t n2 = 0;
  std::optional<double> u;         ///< pairs in which group 1 is larger, equal ones counting half
  std::optional<double> variance;  ///< of U, ties taken into account; zero if all values are equal

  std::optional<double> p;         ///< exact, two-sided: 2 min(P(≤ U), P(≥ U)), at most 1
  std::optional<double> pAbs;      ///< exact, two-sided: P(U as far from its mean)
  std::optional<double> pLess;     ///< exact P(≤ U): if only group 1 < group 2 were of interest
  std::optional<double> pGreater;  ///< exact P(≥ U)

  std::optional<double> z;                      ///< normal, without continuity correction
  std::optional<double> pAsymptotic;            ///< two-sided, of z
  std::optional<double> log10PAsymptotic;       ///< also where p is too small for a double
  std::optional<double> pAsymptoticContinuity;  ///< with U moved by ½ towards its mean

  Reason reason;  ///< why something above is missing; empty if nothing is
};

/// Mann & Whitney's test (1947), which is Wilcoxon's rank sum test: does one group tend to larger
/// values?
///
///     U = #{x > y} + ½ #{x = y}
///     σ² = n₁ n₂ / 12 · (N + 1 − Σ (t³ − t) / (N (N − 1))),   N = n₁ + n₂
///
/// The exact law is that of the given midranks under all choices of group 1 (RankSums), for two
/// groups of some 50 or one very small one. The two exact two-sided p differ where ties make the
/// law skew.
///
/// @throws std::invalid_argument  if a value is infinite or NaN.
MannWhitneyResult mannWhitneyTest(std::span<const double> group1, std::span<const double> group2);
MannWhitneyResult mannWhitneyTest(const TiedGroups& groups);

}  // namespace analysis

#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "analysis/data/ranks.h"
#include "analysis/data/reason.h"
#include "analysis/hypothesis_tests/t_tests.h"
#include "analysis/numerics/interval.h"

namespace analysis {

/// An effect size, a difference in units of a standard deviation, and its confidence interval.
struct EffectSize {
  std::optional<double> value;
  std::optional<Interval> interval;
};

/// Effect sizes of the difference of two means. An undefined one is std::nullopt, and `reason` says
/// why.
struct MeanEffects {
  double level = 0.95;  ///< of the intervals

  EffectSize cohenD;                ///< difference / pooled standard deviation
  std::optional<double> hedgesJ;    ///< hedgesCorrection(n₁ + n₂ − 2)
  EffectSize hedgesG;               ///< hedgesJ · cohenD
  EffectSize cohenDAv;              ///< difference / √((s₁² + s₂²) / 2)
  std::optional<double> hedgesJAv;  ///< hedgesCorrection(ν), with ν Welch's degrees of freedom
  EffectSize hedgesGAv;             ///< hedgesJAv · cohenDAv

  std::optional<double> glassDelta1;  ///< difference / standard deviation of group 1
  std::optional<double> glassDelta2;  ///< difference / standard deviation of group 2
  std::optional<double>
      commonLanguageEffectSize;  ///< P(X > Y) of two normal distributions, in 0 … 1

  Reason reason;  ///< why something above is missing; empty if nothing is
};

/// Effect sizes of the mean difference of paired answers.
struct PairedEffects {
  double level = 0.95;
  EffectSize cohenDz;             ///< mean difference / standard deviation of the differences
  std::optional<double> hedgesJ;  ///< hedgesCorrection(n − 1)
  EffectSize hedgesGz;            ///< hedgesJ · cohenDz
  Reason reason;                  ///< why something above is missing; empty if nothing is
};

/// The factor that makes d unbiased (Hedges 1981), exactly:
///
///     J(ν) = Γ(ν/2) / (√(ν/2) Γ((ν − 1)/2))
///
/// std::nullopt for ν ≤ 1, where Γ has a pole.
std::optional<double> hedgesCorrection(double degreesOfFreedom);

/// Cohen's d and related measures; positive if group 1 has the larger mean.
///
/// The intervals of d and g invert the noncentral t of Student's test (Steiger & Fouladi 1997): d =
/// δ √(1/n₁ + 1/n₂), times J for g. Those of d_av and g_av invert Welch's t with its degrees of
/// freedom, d_av = δ √((s₁²/n₁ + s₂²/n₂) / ((s₁² + s₂²)/2)), which is an approximation. No interval
/// for |t| > 1e100. The common language effect size of McGraw & Wong 1992 is Φ(difference / √(s₁² +
/// s₂²)).
///
/// @throws std::invalid_argument  if a value is infinite or NaN, or for a level that is not between
///     0 and 1.
MeanEffects effectSizes(
    std::span<const double> group1, std::span<const double> group2, double level = 0.95);

/// d_z = t / √n with the interval δ / √n, and g_z = J(n − 1) d_z with its interval.
///
/// @throws std::invalid_argument  for a level that is not between 0 and 1.
PairedEffects effectSizes(const PairedTResult& test, double level = 0.95);

/// Cliff's δ of two groups. An undefined number is std::nullopt, and `reason` says why.
struct CliffDelta {
  std::uint64_t n1 = 0;
  std::uint64_t n2 = 0;
  std::optional<double> delta;     ///< −1 … 1
  std::optional<double> variance;  ///< Cliff's unbiased variance of δ; it can be negative
  std::optional<Interval> interval;
  Reason reason;  ///< why something above is missing; empty if nothing is
};

/// Cliff's δ (1993): P(X > Y) − P(X < Y) for X of group 1 and Y of group 2, with Feng & Cliff's
/// asymmetric interval (2004, J. Modern Applied Statistical Methods 3),
///
///     (δ − δ³ ± z s √((1 − δ²)² + z² s²)) / (1 − δ² + z² s²)
///
/// where s² is the unbiased variance, but not below (1 − δ²)/(n₁n₂ − 1), and z the normal quantile
/// of the level.
///
/// Variance and interval need two values in each group; groups that do not overlap have no
/// interval.
///
/// @throws std::invalid_argument  if a value is infinite or NaN, or for a level that is not between
///     0 and 1.
CliffDelta cliffDelta(
    std::span<const double> group1, std::span<const double> group2, double level = 0.95);
CliffDelta cliffDelta(const TiedGroups& groups, double level = 0.95);

/// The location of paired differences, from the signed rank test. If a number is missing, `reason`
/// says why.
struct HodgesLehmannResult {
  std::uint64_t n = 0;
  std::optional<double> estimate;
  Reason reason;  ///< why something above is missing; empty if nothing is
};

/// Hodges & Lehmann's estimate (1963): the median of the Walsh averages (dᵢ + dⱼ)/2, i ≤ j.
///
/// @throws std::invalid_argument  if a difference is infinite or NaN.
HodgesLehmannResult hodgesLehmann(std::span<const double> differences);

}  // namespace analysis

#pragma once

#include <optional>

#include "analysis/numerics/interval.h"

namespace analysis {

/// Student's t distribution with ν degrees of freedom, which need not be a whole number.
///
/// The two-sided tail probability is
///
///     P(|T| ≥ |t|) = I_x(ν/2, 1/2),   x = ν / (ν + t²),
///
/// with I the regularised incomplete beta function.
class StudentDistribution {
 public:
  /// @param degreesOfFreedom  finite and at least 1, as those of Welch's test always are.
  /// @throws std::invalid_argument  for other degrees of freedom.
  explicit StudentDistribution(double degreesOfFreedom);

  /// P(|T| ≥ |t|). Below 1e-300 the result loses digits and finally is 0: use log10TwoSidedP()
  /// there.
  double twoSidedP(double t) const;

  /// log₁₀ P(|T| ≥ |t|) to full precision, also near p = 1 and where p is too small for a double.
  double log10TwoSidedP(double t) const;

  /// The t that |T| exceeds with a probability of @p p in (0, 1].
  /// @throws std::invalid_argument  for another p.
  double twoSidedQuantile(double p) const;

 private:
  double degreesOfFreedom_;
};

/// The confidence interval: estimate ± quantile of t × standard error. std::nullopt if a value is
/// missing or an end is beyond a double.
/// @throws std::invalid_argument  for a level that is not between 0 and 1.
std::optional<Interval> studentInterval(
    const std::optional<double>& estimate,
    const std::optional<double>& standardError,
    const std::optional<double>& degreesOfFreedom,
    double level);

/// P(T ≤ t) of the noncentral t distribution: T is a normal variable with mean δ and variance 1,
/// divided by √(χ²/ν) of an independent χ² variable with ν degrees of freedom.
///
/// Computed by Boost.Math's series for small δ, and for |δ| > 100 by
///
///     P = P(S > (δ + c)/t) + ∫ f(s) Φ(t s − δ) ds over s from (δ − c)/t to (δ + c)/t,
///
/// where f is the density of S = √(χ²/ν) and Φ(−c) is negligible. The absolute error is about
/// 1e-14.
///
/// @throws std::invalid_argument  for ν that is not finite and at least 1, or for t or δ that is
///     not finite.
double noncentralTProbability(double t, double degreesOfFreedom, double noncentrality);

/// The confidence interval of the noncentrality δ for an observed t (Steiger & Fouladi 1997). At
/// its lower end P(T ≥ t | δ) = (1 − level) / 2, at its upper end P(T ≤ t | δ) = (1 − level) / 2.
///
/// @throws std::invalid_argument  for ν that is not finite and at least 1, for t that is not
///     finite, or for a level that is not between 0 and 1.
Interval noncentralityInterval(double t, double degreesOfFreedom, double level);

/// The F distribution with ν₁ and ν₂ degrees of freedom, which need not be whole numbers.
///
///     P(F ≥ f) = I_x(ν₂/2, ν₁/2),   x = ν₂ / (ν₂ + ν₁ f)
///
/// with I the regularised incomplete beta function.
class FisherDistribution {
 public:
  /// @throws std::invalid_argument  for degrees of freedom that are not finite and above 0.
  FisherDistribution(double degreesOfFreedom1, double degreesOfFreedom2);

  /// P(F ≥ f) for f ≥ 0. Below 1e-300 the result loses digits and finally is 0: use log10UpperP()
  /// there.
  /// @throws std::invalid_argument  for an f that is infinite, negative or no number.
  double upperP(double f) const;

  /// log₁₀ P(F ≥ f) to full precision, also near p = 1 and where p is too small for a double.
  /// @throws std::invalid_argument  for an f that is infinite, negative or no number.
  double log10UpperP(double f) const;

  /// The f that F exceeds with a probability of @p p in (0, 1); infinity beyond a double.
  /// @throws std::invalid_argument  for another p.
  double upperQuantile(double p) const;

 private:
  double degreesOfFreedom1_;
  double degreesOfFreedom2_;
};

}  // namespace analysis

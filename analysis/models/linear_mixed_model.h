#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/data/factor.h"
#include "analysis/data/reason.h"
#include "analysis/models/fixed_effects.h"
#include "analysis/numerics/interval.h"

namespace analysis {

/// A coefficient, a contrast or a mean, held against zero by a t of its own degrees of freedom.
struct TEstimate {
  std::string name;
  double estimate = 0.0;
  double standardError = 0.0;
  std::optional<double> degreesOfFreedom;  ///< Satterthwaite; rarely a whole number
  std::optional<double> t;                 ///< estimate / standard error
  std::optional<double> p;                 ///< two-sided, not yet corrected
  std::optional<double> log10P;            ///< holds also where p is too small for a double
  Reason reason;                           ///< why something above is missing
};

/// How much the levels of a random intercept vary.
struct VarianceComponent {
  std::string name;
  std::size_t levels = 0;
  double variance = 0.0;
  double standardDeviation = 0.0;
  /// Estimated as zero: the answers vary no more between the levels than they would by chance.
  bool isSingular = false;
};

/// A linear mixed model that has been fitted.
struct LinearMixedFit {
  std::size_t answers = 0;
  std::vector<TEstimate> fixedEffects;  ///< one for each column of the design
  std::vector<VarianceComponent> components;
  double residualVariance = 0.0;
  double logLikelihood = 0.0;  ///< restricted
  int iterations = 0;

  std::vector<double> covariance;  ///< of the p fixed effects, p × p, row by row
  /// ∂covariance / ∂variance, for each component and then for the residuals.
  std::vector<std::vector<double>> covarianceDerivatives;
  /// Of the variance estimates in that order, row by row; empty where it is not defined.
  std::vector<double> varianceCovariance;
};

struct LinearMixedResult {
  std::optional<LinearMixedFit> fit;
  Reason reason;  ///< why there is no fit
};

/// Fits y = fixed effects + random intercepts + residual by restricted maximum likelihood
/// (Bates et al. 2015), the intercepts nested or crossed; for the published study
///
///     score ~ method + round + (1 | participant) + (1 | participant:method)
///
/// The relative variances are found by Newton's method, bounded below by zero, from several
/// starts. Degrees of freedom: Satterthwaite's ν = 2 (cᵀΦc)² / (gᵀ A g), with Φ the covariance of
/// the fixed effects, g the gradient of cᵀΦc in the variances, and A twice the inverse Hessian of
/// the restricted deviance in them (Kuznetsova, Brockhoff & Christensen 2017, J. Stat. Softw.
/// 82(13), section 2.1). A variance estimated as zero counts as known.
///
/// Nothing is fitted, and the reason says why, where the model is not defined: too few answers, a
/// factor of one level, effects that cannot be told apart, answers that do not vary.
///
/// @throws std::invalid_argument  if y has another number of answers or a value that is not finite.
LinearMixedResult fitLinearMixedModel(
    std::span<const double> y, const FixedEffects& fixed, std::span<const Factor> random);

/// The sum of the fixed effects times @p weights.
/// @throws std::invalid_argument  for another number of weights.
TEstimate contrast(const LinearMixedFit& fit, std::string name, std::span<const double> weights);

/// The estimated marginal mean of each level of a factor; see FixedEffects::marginalMean().
/// @param fixed  the design that the model was fitted with.
std::vector<TEstimate> marginalMeans(
    const LinearMixedFit& fit, const FixedEffects& fixed, std::string_view factor);

/// Each level minus each later one: "interpolation - fem".
std::vector<TEstimate> pairwiseDifferences(
    const LinearMixedFit& fit, const FixedEffects& fixed, std::string_view factor);

/// Where the true value lies, with a confidence of @p level, for instance 0.95; nothing where the
/// degrees of freedom are not defined.
/// @throws std::invalid_argument  for a level that is not between 0 and 1.
std::optional<Interval> confidenceInterval(const TEstimate& estimate, double level);

}  // namespace analysis

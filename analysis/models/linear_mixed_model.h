#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/data/factor.h"
#include "analysis/data/reason.h"
#include "analysis/models/estimates.h"
#include "analysis/models/fixed_effects.h"

namespace analysis {

/// The variance of a random intercept between its levels.
struct VarianceComponent {
  std::string name;
  std::size_t levels = 0;
  double variance = 0.0;
  double standardDeviation = 0.0;
  /// Whether the variance is estimated as zero: the answers vary no more between the levels than
  /// expected by chance.
  bool isSingular = false;
};

/// A fitted linear mixed model.
struct LinearMixedFit {
  std::size_t answers = 0;
  std::vector<TEstimate> fixedEffects;  ///< one for each column of the design
  std::vector<VarianceComponent> components;
  double residualVariance = 0.0;
  double logLikelihood = 0.0;  ///< logarithm of the restricted likelihood
  int iterations = 0;

  std::vector<double> covariance;  ///< of the p fixed effects, p × p, row by row
  /// ∂covariance / ∂variance, for each component and then for the residuals.
  std::vector<std::vector<double>> covarianceDerivatives;
  /// Covariance matrix of the variance estimates in the order of covarianceDerivatives, row by row;
  /// empty if it is not defined.
  std::vector<double> varianceCovariance;
};

struct LinearMixedResult {
  std::optional<LinearMixedFit> fit;
  Reason reason;  ///< why there is no fit
};

/// Fits y = fixed effects + random intercepts + residual by restricted maximum likelihood (Bates et
/// al. 2015), with nested or crossed random intercepts. The model of the published study is
///
///     score ~ method + round + (1 | participant) + (1 | participant:method)
///
/// Newton's method finds the relative variances (see RestrictedDeviance), bounded below by zero,
/// from two starting points. Degrees of freedom of a contrast c: Satterthwaite's
///
///     ν = 2 (cᵀΦc)² / (gᵀ A g),
///
/// with Φ the covariance of the fixed effects, g the gradient of cᵀΦc in the variances, and A twice
/// the inverse Hessian of the restricted deviance in them (Kuznetsova, Brockhoff & Christensen
/// 2017, J. Stat. Softw. 82(13), section 2.1). A variance estimated as zero is treated as known.
///
/// There is no fit, and `reason` says why, if the model is not defined: too few answers, a factor
/// with one level, confounded effects, or answers that do not vary.
///
/// @throws std::invalid_argument  if y has another number of answers or a value that is not finite.
LinearMixedResult fitLinearMixedModel(
    std::span<const double> y, const FixedEffects& fixed, std::span<const Factor> random);

/// The sum of the fixed effects times @p weights.
/// @throws std::invalid_argument  for another number of weights.
TEstimate contrast(const LinearMixedFit& fit, std::string name, std::span<const double> weights);

}  // namespace analysis

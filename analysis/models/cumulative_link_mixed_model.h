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
#include "analysis/models/linear_mixed_model.h"

namespace analysis {

/// A cumulative link mixed model that has been fitted.
struct CumulativeLinkFit {
  std::size_t answers = 0;
  std::vector<int> levels;                 ///< of the answers, those that were given, ascending
  std::vector<WaldEstimate> thresholds;    ///< θ between neighbouring levels: "1|2"
  std::vector<WaldEstimate> fixedEffects;  ///< one per column of the design after the intercept
  std::vector<VarianceComponent> components;
  double logLikelihood = 0.0;
  int iterations = 0;
  /// Of θ, β and the standard deviations of the components, in this order; row by row.
  std::vector<double> covariance;

  std::size_t parameters() const {
    return thresholds.size() + fixedEffects.size() + components.size();
  }
};

struct CumulativeLinkResult {
  std::optional<CumulativeLinkFit> fit;
  Reason reason;  ///< why there is no fit
};

/// Fits an ordinal answer by maximum likelihood,
///
///     logit P(Y ≤ c) = θ_c − (xᵀβ + random intercepts),
///
/// the intercepts nested or crossed, their integral by Laplace's approximation; none at all gives
/// the cumulative link model, the proportional odds of McCullagh 1980. A positive β makes higher
/// answers likelier. The intercept of @p fixed is left out: the thresholds are in its place.
/// Standard errors come from the Hessian of the marginal log likelihood in θ, β and the standard
/// deviations.
///
/// Levels that no answer has have no threshold. Nothing is fitted, and the reason says why, where
/// the model is not defined (as for fitLinearMixedModel()), where the answers separate completely
/// (all answers of a method are the highest: its effect is infinite), or where no maximum is found
/// within 200 steps.
///
/// @throws std::invalid_argument  if y has another number of answers.
CumulativeLinkResult fitCumulativeLinkMixedModel(
    std::span<const int> y, const FixedEffects& fixed, std::span<const Factor> random);

/// The sum of the fixed effects times @p weights, one for each column of the design; the weight of
/// the intercept must be zero, since only differences have a meaning here.
/// @throws std::invalid_argument  for other weights.
WaldEstimate contrast(
    const CumulativeLinkFit& fit, std::string name, std::span<const double> weights);

}  // namespace analysis

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

/// A fitted cumulative link mixed model.
struct CumulativeLinkFit {
  std::size_t answers = 0;
  std::vector<int> levels;               ///< the distinct answers that were given, ascending
  std::vector<WaldEstimate> thresholds;  ///< θ between neighbouring levels: "1|2"
  /// One per column of the design matrix except the intercept.
  std::vector<WaldEstimate> fixedEffects;
  std::vector<VarianceComponent> components;
  double logLikelihood = 0.0;
  int iterations = 0;
  /// Covariance matrix of θ, β and the standard deviations of the components, in this order; row by
  /// row.
  std::vector<double> covariance;

  std::size_t parameters() const {
    return thresholds.size() + fixedEffects.size() + components.size();
  }
};

struct CumulativeLinkResult {
  std::optional<CumulativeLinkFit> fit;
  Reason reason;  ///< why there is no fit
};

/// Fits a cumulative link mixed model of ordinal answers by maximum likelihood,
///
///     logit P(Y ≤ c) = θ_c − (xᵀβ + random intercepts),
///
/// with nested or crossed random intercepts, which are integrated out by Laplace's approximation.
/// Without random intercepts, this is the proportional odds model of McCullagh 1980. A positive β
/// makes higher answers more probable. The intercept of @p fixed is ignored: the thresholds replace
/// it. Standard errors come from the Hessian of the marginal log likelihood in θ, β and the
/// standard deviations.
///
/// Points of the scale that were never chosen get no threshold. There is no fit, and `reason` says
/// why, if the model is not defined (as for fitLinearMixedModel()), if the answers separate
/// completely (all answers to a method are the highest, so that its effect is infinite), or if no
/// maximum is found within 200 steps.
///
/// @throws std::invalid_argument  if y has another number of answers.
CumulativeLinkResult fitCumulativeLinkMixedModel(
    std::span<const int> y, const FixedEffects& fixed, std::span<const Factor> random);

/// The sum of the fixed effects times @p weights, one for each column of the design matrix. The
/// weight of the intercept must be zero, because the model has none.
/// @throws std::invalid_argument  for another number of weights, or an intercept's weight that is
///     not zero.
WaldEstimate contrast(
    const CumulativeLinkFit& fit, std::string name, std::span<const double> weights);

}  // namespace analysis

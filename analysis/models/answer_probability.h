#pragma once

#include <optional>
#include <span>
#include <vector>

#include "analysis/models/cumulative_link_mixed_model.h"
#include "analysis/models/estimates.h"
#include "analysis/numerics/interval.h"

namespace analysis {

/// The probability of an answer at or above some level, by an ordinal model.
struct AnswerProbability {
  double probability = 0.0;
  WaldEstimate logit;  ///< logit of the probability with its standard error; oddsRatio is the odds,
                       ///< z and p are meaningless
};

/// P(Y ≥ level) in the population: the marginal probability, averaged over the distribution of the
/// random intercepts. It estimates a proportion of answers. (The probability for one typical
/// participant, with intercepts of zero, is further from one half.)
///
///     P = 1/R Σ_r ∫ F(x_rᵀβ − θ + σ u) φ(u) du,   F(a) = 1 / (1 + e^{−a}),   σ² = Σ_k σ_k²,
///
/// with θ the threshold below the level, and x_r the @p designs, which have equal weights (as
/// emmeans weights the levels of other factors). The standard error of logit P is computed by the
/// delta method from the covariance of θ, β and all σ_k, so that the interval stays between 0 and
/// 1.
///
/// @param level  may be an answer that was not given: if no answer is 4, "4 or more" is "5 or
///     more".
/// @param designs  rows of the design matrix, as FixedEffects::combinations() returns them.
/// @return std::nullopt if all answers or none are below the level: the model then has no threshold
///     below the level.
/// @throws std::invalid_argument  if @p designs is empty, or a row has not one number per column of
///     the fit.
std::optional<AnswerProbability> answerProbability(
    const CumulativeLinkFit& fit, int level, std::span<const std::vector<double>> designs);

/// The confidence interval of the probability: Wald's interval of its logit, transformed back.
/// @throws std::invalid_argument  for a level that is not between 0 and 1.
Interval probabilityInterval(const AnswerProbability& probability, double level);

}  // namespace analysis

#pragma once

#include <optional>
#include <span>
#include <vector>

#include "analysis/models/cumulative_link_mixed_model.h"
#include "analysis/models/estimates.h"
#include "analysis/numerics/interval.h"

namespace analysis {

/// How likely a high answer is, by an ordinal model.
struct AnswerProbability {
  double probability = 0.0;
  WaldEstimate logit;  ///< of the probability; its odds ratio is the odds, its z and p mean nothing
};

/// P(Y ≥ level) in the population: the marginal probability, over all whom the random intercepts
/// stand for. It estimates a proportion of answers. (The probability for one typical participant,
/// with intercepts of zero, is further from one half.)
///
///     P = 1/R Σ_r ∫ F(x_rᵀβ − θ + σ u) φ(u) du,   F(a) = 1 / (1 + e^{−a}),   σ² = Σ_k σ_k²,
///
/// with θ the threshold below the level, and x_r the @p designs, which have equal weights (as
/// emmeans weights the levels of other factors). The standard error of logit P is by the delta
/// method, from the covariance of θ, β and all σ_k; so the interval stays between 0 and 1.
///
/// @param level  an answer between the given ones counts as well: where there is no answer of 4,
/// from 4
///     on is from 5 on.
/// @param designs  columns of the design, as FixedEffects::combinations() gives them.
/// @return std::nullopt where all answers are below the level, or none is: no threshold is there.
/// @throws std::invalid_argument  for no designs, or columns that are not those of the fit.
std::optional<AnswerProbability> answerProbability(
    const CumulativeLinkFit& fit, int level, std::span<const std::vector<double>> designs);

/// The interval of the probability: the ends of Wald's interval of its logit, turned back.
/// @throws std::invalid_argument  for a level that is not between 0 and 1.
Interval probabilityInterval(const AnswerProbability& probability, double level);

}  // namespace analysis

#pragma once

#include <span>

#include "analysis/data/factor.h"
#include "analysis/data/reason.h"
#include "analysis/models/fixed_effects.h"

namespace analysis {

/// Why a model with these fixed effects and random intercepts is not defined for these answers:
/// too few of them, a factor of one level, columns that say the same, random intercepts that
/// cannot be told apart from each other or from the single answers. Empty where it is defined.
///
/// @throws std::invalid_argument  if a factor has another number of answers.
Reason whyNotDefined(const FixedEffects& fixed, std::span<const Factor> random);

}  // namespace analysis

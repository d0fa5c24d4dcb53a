#pragma once

#include <optional>
#include <vector>

#include "questionnaires/answer.h"

namespace questionnaires {

/// What @p score comes to with @p answers: (aggregate of the keyed answers + offset) · factor.
///
/// Nothing where too few of its items were answered: a mean needs as many as the score says, a sum
/// needs all, since a missing one would count as zero. Points, sliders and numbers count; other
/// kinds of items do not, and neither does an answer that objection() refuses. Where an item was
/// answered more than once, the last answer counts.
std::optional<double> scored(
    const Instrument& instrument, const Score& score, const std::vector<Answer>& answers);

}  // namespace questionnaires

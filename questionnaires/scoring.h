#pragma once

#include <optional>
#include <vector>

#include "questionnaires/answer.h"

namespace questionnaires {

/// What @p score comes to with @p answers: (aggregate of the keyed answers + offset) · factor.
/// Nothing where too few of its items were answered. Points, sliders and numbers count; other
/// kinds of items do not.
std::optional<double> scored(
    const Instrument& instrument, const Score& score, const std::vector<Answer>& answers);

}  // namespace questionnaires

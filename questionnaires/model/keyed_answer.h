#pragma once

#include <optional>
#include <vector>

#include "questionnaires/model/answer.h"

namespace questionnaires {

/// The answer to @p item as a number, as it was given: the last one where there are several.
/// Nothing where there is none, where it was taken back, where objection() refuses it, and where
/// answers to the item are no numbers.
std::optional<double> answerAsNumber(const Item& item, const std::vector<Answer>& answers);

/// @p number as it counts for @p item: low + high - x where the key is -1. A number item has no
/// key and is left alone.
double keyedNumber(const Item& item, double number);

}  // namespace questionnaires

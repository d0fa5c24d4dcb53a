#pragma once

#include <array>
#include <string_view>

#include "questionnaires/json/document.h"
#include "questionnaires/model/instrument.h"

namespace questionnaires {

/// The words for the types of items, in files and exports.
inline constexpr std::array kItemTypes{
    Choice<ItemType>{"likert", ItemType::Likert},
    Choice<ItemType>{"semantic_differential", ItemType::SemanticDifferential},
    Choice<ItemType>{"slider", ItemType::Slider},
    Choice<ItemType>{"single_choice", ItemType::SingleChoice},
    Choice<ItemType>{"multiple_choice", ItemType::MultipleChoice},
    Choice<ItemType>{"number", ItemType::Number},
    Choice<ItemType>{"short_text", ItemType::ShortText},
    Choice<ItemType>{"long_text", ItemType::LongText},
    Choice<ItemType>{"pairwise_choice", ItemType::PairwiseChoice},
};

std::string_view nameOf(ItemType type) noexcept;

}  // namespace questionnaires

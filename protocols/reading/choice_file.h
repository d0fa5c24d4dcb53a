#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "questionnaires/json/document.h"

namespace protocols {

/// What the word behind @p key stands for; nothing, and a problem, where it is none of @p choices:
/// for words that decide what else is read.
template <typename Choices>
auto readChoice(const questionnaires::Node& node, std::string_view key, const Choices& choices) {
  const auto value = node.choice(key, choices);
  const auto written = node.member(key);
  const bool isKnown = written && written->isText() &&
                       std::any_of(choices.begin(), choices.end(), [&](const auto& choice) {
                         return choice.name == written->asText();
                       });
  return isKnown ? std::optional(value) : std::nullopt;
}

}  // namespace protocols

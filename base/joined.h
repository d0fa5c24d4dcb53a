#pragma once

#include <functional>
#include <ranges>
#include <string>
#include <string_view>

namespace base {

/// The texts of @p all, or of each element what @p textOf makes of it, with @p separator between
/// them; none before the first text that is not empty.
template <std::ranges::input_range Range, typename TextOf = std::identity>
std::string joined(const Range& all, std::string_view separator, const TextOf& textOf = {}) {
  std::string text;
  for (const auto& one : all) {
    if (!text.empty()) text += separator;
    text += std::invoke(textOf, one);
  }
  return text;
}

}  // namespace base

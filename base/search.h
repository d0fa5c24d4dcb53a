#pragma once

#include <algorithm>
#include <cstddef>
#include <ranges>
#include <string_view>

namespace base {

/// Whether an element of @p all equals @p one.
template <std::ranges::input_range Range, typename Value>
constexpr bool contains(const Range& all, const Value& one) {
  return std::ranges::find(all, one) != std::ranges::end(all);
}

/// The first element of @p all whose member `id` is @p id; nullptr if there is none.
template <std::ranges::contiguous_range Range>
constexpr auto* withId(const Range& all, std::string_view id) noexcept {
  const auto found = std::ranges::find_if(all, [&](const auto& one) { return one.id == id; });
  return found == std::ranges::end(all) ? nullptr : &*found;
}

/// The smallest number of edits (insert, delete, replace, swap of neighbours) from one word to the
/// other.
std::size_t editDistance(std::string_view a, std::string_view b);

}  // namespace base

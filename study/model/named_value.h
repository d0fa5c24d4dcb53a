#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace study {

/// The enumerator that is named @p name; std::nullopt for an unknown name. @p names has the name of
/// every enumerator, in their order.
template <typename Value, std::size_t kCount>
constexpr std::optional<Value> valueNamed(
    const std::array<std::string_view, kCount>& names, std::string_view name) noexcept {
  for (std::size_t i = 0; i < kCount; ++i) {
    if (names[i] == name) return static_cast<Value>(i);
  }
  return std::nullopt;
}

}  // namespace study

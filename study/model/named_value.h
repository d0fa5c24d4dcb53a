#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace study {

/// The value of an enum whose names are in @p names in its order; std::nullopt for an unknown name.
template <typename Value, std::size_t kCount>
constexpr std::optional<Value> valueNamed(
    const std::array<std::string_view, kCount>& names, std::string_view name) noexcept {
  for (std::size_t i = 0; i < kCount; ++i) {
    if (names[i] == name) return static_cast<Value>(i);
  }
  return std::nullopt;
}

}  // namespace study

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/message.h"

namespace study::storage {

/// Values in JSON, as columns store them. Numbers are read back exactly.

/// [{"code": "trial.late", "arguments": [30, 4000]}]; an empty text for an empty list.
std::string asJson(const std::vector<base::Message>& messages);

/// @param text  written by asJson(), with codes of study::kMessages. An unknown code, which a later
///     release wrote, becomes a verbatim message.
std::vector<base::Message> messagesIn(std::string_view text);

/// {"item": "1.1", "point": 4}
std::string asJson(const base::NamedArguments& values);

/// std::nullopt if @p text is not such an object.
std::optional<base::NamedArguments> valuesIn(std::string_view text);

/// The value named @p name; std::nullopt if there is none of the type @p Value. A whole number
/// is a double as well, because JSON may have one for 3.0.
template <typename Value>
std::optional<Value> storedValue(const base::NamedArguments& values, std::string_view name) {
  for (const auto& [known, stored] : values) {
    if (known != name) continue;
    if (const auto* value = std::get_if<Value>(&stored)) return *value;
    if constexpr (std::same_as<Value, double>) {
      if (const auto* whole = std::get_if<std::int64_t>(&stored))
        return static_cast<double>(*whole);
    }
  }
  return std::nullopt;
}

/// The text named @p name; empty if there is none.
inline std::string storedText(const base::NamedArguments& values, std::string_view name) {
  return storedValue<std::string>(values, name).value_or("");
}

}  // namespace study::storage

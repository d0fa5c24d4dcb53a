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

}  // namespace study::storage

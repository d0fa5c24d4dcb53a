#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/message.h"

namespace study::storage {

/// Facts as a column holds them, in JSON. Numbers read back exactly.

/// [{"code": "trial.late", "arguments": [30, 4000]}]; an empty text for no message.
std::string asJson(const std::vector<base::Message>& messages);

/// @param text  by asJson(), of messages of study::kMessages. A code that is not known, of a later
/// release, becomes a message of its own words.
std::vector<base::Message> messagesIn(std::string_view text);

/// {"item": "1.1", "point": 4}
std::string asJson(const base::NamedArguments& values);

/// Nothing where @p text is no such object.
std::optional<base::NamedArguments> valuesIn(std::string_view text);

}  // namespace study::storage

#pragma once

#include <optional>
#include <string_view>

#include "protocols/model/protocol.h"
#include "questionnaires/json/problem.h"

namespace protocols {

/// A protocol as JSON says it (docs/protocol-format.md), and everything that is wrong with the way
/// it is written; nothing where there are errors. What it refers to is not looked at: see
/// loadProtocol().
std::optional<Protocol> readProtocol(std::string_view json, questionnaires::Problems& problems);

/// The same as far as it goes: what was not understood is empty, and a problem. Nothing only where
/// @p json is no JSON object.
std::optional<Protocol> readDraft(std::string_view json, questionnaires::Problems& problems);

}  // namespace protocols

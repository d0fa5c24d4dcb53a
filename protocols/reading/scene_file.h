#pragma once

#include <optional>

#include "protocols/model/protocol.h"
#include "questionnaires/json/document.h"

namespace protocols {

/// Reads the model and its parameters of a condition (docs/protocol-format.md, "Scenes") into
/// @p condition; problems go where the node's go.
void readScene(const questionnaires::Node& scene, Condition& condition);

}  // namespace protocols

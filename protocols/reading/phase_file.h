#pragma once

#include "protocols/model/protocol.h"
#include "questionnaires/json/document.h"

namespace protocols {

/// Reads one phase (docs/protocol-format.md, "Phases"); problems go where the node's go. One whose
/// type is not understood has no id.
Phase readPhase(const questionnaires::Node& node);

}  // namespace protocols

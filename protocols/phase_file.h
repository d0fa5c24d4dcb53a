#pragma once

#include "protocols/protocol.h"
#include "questionnaires/document.h"

namespace protocols {

/// Reads one phase (docs/protocol-format.md, "phases"); problems go where the node's go.
Phase readPhase(const questionnaires::Node& node);

}  // namespace protocols

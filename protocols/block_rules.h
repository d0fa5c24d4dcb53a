#pragma once

#include "protocols/loaded_protocol.h"
#include "questionnaires/problem.h"

namespace protocols {

/// What is wrong or unwise about a protocol's blocks, their orders, their questionnaires, and the
/// preferences asked about them.
void checkBlocks(const LoadedProtocol& loaded, questionnaires::Problems& problems);

/// What is wrong or unwise about its analysis plan and the truth of its simulation.
void checkAnalysis(const LoadedProtocol& loaded, questionnaires::Problems& problems);

}  // namespace protocols

#pragma once

#include "protocols/model/loaded_protocol.h"
#include "questionnaires/json/problem.h"

namespace protocols {

/// What is unwise about the blocks of a sound protocol: their orders, and the statements that are
/// asked after their conditions.
void adviseOnBlocks(const LoadedProtocol& loaded, questionnaires::Problems& problems);

/// What is unwise about the comparisons that are planned, or about planning none.
void adviseOnAnalysis(const Protocol& protocol, questionnaires::Problems& problems);

}  // namespace protocols

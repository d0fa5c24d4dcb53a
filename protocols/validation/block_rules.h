#pragma once

#include "protocols/reading/draft.h"
#include "questionnaires/json/problem.h"

namespace protocols {

/// What is wrong about a protocol's blocks, their orders, their questionnaires, and the preferences
/// asked about them.
void checkBlocks(const Draft& draft, questionnaires::Problems& problems);

}  // namespace protocols

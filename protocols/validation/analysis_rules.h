#pragma once

#include "protocols/reading/draft.h"
#include "questionnaires/json/problem.h"

namespace protocols {

/// What is wrong about a protocol's analysis plan and the truth of its simulation.
void checkAnalysis(const Draft& draft, questionnaires::Problems& problems);

}  // namespace protocols

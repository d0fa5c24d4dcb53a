#pragma once

#include <functional>
#include <string>

#include "questionnaires/json/problem.h"

namespace tests {

/// Whether a file is accepted, with everything that was found in it.
using Reader = std::function<bool(const std::string& file, questionnaires::Problems& problems)>;

/// Says about each file that @p argv names, in a line of JSON, what @p isAccepted says: for
/// tests/support/schema_verdicts.mjs, which compares it with a schema.
void printVerdicts(int argc, char** argv, const Reader& isAccepted);

}  // namespace tests

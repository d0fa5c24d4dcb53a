#pragma once

#include <functional>
#include <string>

#include "questionnaires/json/problem.h"

namespace tests {

/// Whether a file is accepted, with all problems that were found in it.
using Reader = std::function<bool(const std::string& file, questionnaires::Problems& problems)>;

/// Prints for each file of @p argv a line of JSON with the result of @p isAccepted, for
/// tests/support/schema_verdicts.mjs, which compares it with a schema.
void printVerdicts(int argc, char** argv, const Reader& isAccepted);

}  // namespace tests

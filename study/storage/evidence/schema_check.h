#pragma once

#include "study/storage/database.h"
#include "study/storage/evidence/findings.h"

namespace study::storage {

/// Compares the tables, indexes and triggers of a file with those that this program makes in the
/// file's format. SQLite's integrity check does not look at them: a trigger could change what is
/// written, or one that protects rows be gone.
Findings checkSchema(const Database& database, const Schema& schema);

}  // namespace study::storage

#pragma once

#include "study/storage/database.h"
#include "study/storage/evidence/findings.h"

namespace study::storage {

/// Compares the tables, indexes and triggers of a file with those that this program creates for the
/// file's format. SQLite's integrity check does not: an added trigger could change rows that are
/// written, and a trigger that protects rows could be missing.
Findings checkSchema(const Database& database, const Schema& schema);

}  // namespace study::storage

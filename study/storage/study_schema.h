#pragma once

#include "study/storage/database.h"

namespace study::storage {

/// study.db: the protocols, sessions, answers and the audit trail.
const Schema& studySchema();

/// traces.db: the samples of all trials, one per tick.
const Schema& traceSchema();

/// identity.db: answers that name a person. Never exported.
const Schema& identitySchema();

}  // namespace study::storage

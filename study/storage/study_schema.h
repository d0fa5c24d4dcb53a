#pragma once

#include "study/storage/database.h"

namespace study::storage {

/// study.db: the protocol as frozen, sessions, answers, audit.
const Schema& studySchema();

/// traces.db: what was felt, a thousand times a second.
const Schema& traceSchema();

/// identity.db: whatever names a person. Never exported.
const Schema& identitySchema();

}  // namespace study::storage

#pragma once

#include "study/model/ids.h"
#include "study/storage/database.h"
#include "study/storage/hasher.h"

namespace study::storage {

/// The hash of everything that the tables hold about a session: its participant, steps, visits,
/// answers, trials, cuts. It changes with every bit of these.
Hash contentHash(const Database& database, SessionId session);

/// The hash of what the tables hold about the study itself: its head and its protocols.
Hash contentHash(const Database& database);

}  // namespace study::storage

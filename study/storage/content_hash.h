#pragma once

#include "study/model/ids.h"
#include "study/storage/database.h"
#include "study/storage/hasher.h"

namespace study::storage {

/// Of everything that the tables say about a session: its participant, steps, visits, answers,
/// trials, cuts. Another one as soon as a bit of that is.
Hash contentHash(const Database& database, SessionId session);

/// Of what the tables say about the study itself: its head and its protocols.
Hash contentHash(const Database& database);

}  // namespace study::storage

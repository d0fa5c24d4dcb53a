#pragma once

#include "study/model/ids.h"
#include "study/storage/database.h"
#include "study/storage/hasher.h"
#include "study/storage/keys/sealing_key.h"

namespace study::storage {

/// The hash of everything that the tables hold about a session: its participant, steps, visits,
/// answers, trials, cuts. It changes with every bit of these.
/// @param key  the participant's; a hash with it tells nothing of the answers once the key is gone.
///     nullptr: without.
Hash contentHash(const Database& database, SessionId session, const SealingKey* key = nullptr);

/// The hash of what the tables hold about the study itself: its head, its protocols, and who was
/// erased.
Hash contentHash(const Database& database);

}  // namespace study::storage

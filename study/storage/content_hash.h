#pragma once

#include "study/model/ids.h"
#include "study/storage/database.h"
#include "study/storage/hasher.h"
#include "study/storage/keys/sealing_key.h"

namespace study::storage {

/// The hash of all rows of a session: its participant, steps, visits, answers, trials, cuts. It
/// changes with every bit of these.
/// @param key  the participant's content key, for a keyed hash: it reveals nothing about the
///     answers once the key is destroyed. nullptr: a hash without a key.
Hash contentHash(const Database& database, SessionId session, const SealingKey* key = nullptr);

/// The hash of the rows of the study itself: its own row, its protocols, erasures and the key that
/// a passphrase wraps.
Hash contentHash(const Database& database);

}  // namespace study::storage

#pragma once

#include "study/model/ids.h"
#include "study/storage/database.h"
#include "study/storage/hasher.h"
#include "study/storage/keys/sealing_key.h"

namespace study::storage {

/// The hash of all rows of a session: its participant, steps, visits, answers, trials and cuts. It
/// changes with every bit of them.
/// @param key  the participant's content key, for a keyed hash, which reveals nothing about the
///     answers after the key is destroyed; nullptr: a hash without a key.
Hash contentHash(const Database& database, SessionId session, const SealingKey* key = nullptr);

/// The hash of the rows of the study itself: of the tables of the study, its protocols, erasures,
/// and the key that is wrapped with a passphrase.
Hash contentHash(const Database& database);

}  // namespace study::storage

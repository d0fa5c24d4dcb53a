#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "study/model/ids.h"
#include "study/storage/keys/sealing_key.h"

namespace study::storage {

// What tells which condition was felt is sealed with the key of the study (docs/decisions/0049).

/// Which condition an alternative is. All conditions have the same size when they are sealed, so
/// that it does not tell them apart.
std::vector<std::byte> sealedCondition(
    const SealingKey& key, SessionId session, int step, std::string_view condition);

/// @param key  nullptr: it is not here
/// @throws StorageError  if it was sealed with another key, or for another step, or was changed; or
///     if there is no key, with what to do.
std::string openedCondition(
    const SealingKey* key, SessionId session, int step, const std::vector<std::byte>& sealed);

/// What was measured in a trial (columns and values in JSON), sealed in the same way. Its size does
/// not tell how much was measured, up to about 20 cuts.
std::vector<std::byte> sealedMeasurements(
    const SealingKey& key, const VisitKey& trial, std::string_view text);

/// As openedCondition().
std::string openedMeasurements(
    const SealingKey* key, const VisitKey& trial, const std::vector<std::byte>& sealed);

/// What to do where the key of a study is missing.
/// @param study  its folder, as somebody would type it
std::string adviceOnMissingKey(const std::string& study, bool hasPassphrase);

}  // namespace study::storage

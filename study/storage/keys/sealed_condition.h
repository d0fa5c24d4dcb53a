#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "study/model/ids.h"
#include "study/storage/keys/sealing_key.h"

namespace study::storage {

// Data that reveal the rendered condition are sealed with the study's key (docs/decisions/0049).

/// Seals the condition of a step. All sealed conditions have the same size, so that the size
/// reveals nothing; only an id of 64 characters, the longest allowed, takes more.
std::vector<std::byte> sealCondition(
    const SealingKey& key, SessionId session, int step, std::string_view condition);

/// @throws StorageError  if the condition was sealed with another key or for another step, or was
///     changed.
std::string openCondition(
    const SealingKey& key, SessionId session, int step, const std::vector<std::byte>& sealed);

/// Seals the measurements of a trial (JSON of columns and values). The sealed size is the same for
/// up to about 20 cuts.
std::vector<std::byte> sealMeasurements(
    const SealingKey& key, const VisitKey& trial, std::string_view text);

/// As openCondition().
std::string openMeasurements(
    const SealingKey& key, const VisitKey& trial, const std::vector<std::byte>& sealed);

/// Advice for the operator on how to get the missing key of a study.
/// @param study  the study's folder, as typed in a command
std::string adviceOnMissingKey(const std::string& study, bool hasPassphrase);

}  // namespace study::storage

#pragma once

#include <filesystem>

#include "study/storage/database.h"
#include "study/storage/keys/sealed_condition.h"

namespace study::storage {

/// The study's key. @param database  a file of the study
/// @throws StorageError  if it is not available; the error describes how to get it.
inline const SealingKey& requireKey(const Database& database) {
  if (const auto* key = database.key()) return *key;
  const auto folder = std::filesystem::path(database.path()).parent_path();
  throw StorageError(adviceOnMissingKey(folder.string(), false));
}

}  // namespace study::storage

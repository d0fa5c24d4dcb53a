#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "study/storage/blinding_secret.h"
#include "study/storage/database.h"
#include "study/storage/keys/wrapped_key.h"

namespace study::storage {

/// Stores the key of a study in this station's list, outside of the study's folder
/// (docs/decisions/0049). The list is on the disk on return. Does nothing if the list has the key.
/// @param folder  the study's folder, a note for people who read the list
/// @return  false if the list had the key already
/// @throws StorageError  if the station's own folder cannot be used.
bool storeStudyKey(const BlindingSecret& key, const std::filesystem::path& folder);

/// Holds a key in memory until this program ends. findStudyKey() then finds it when a window opens
/// the study again.
void cacheStudyKey(const BlindingSecret& key);

/// Holds the key of names, which a passphrase opened, in memory until this program ends.
/// cachedNamesKey() returns it for @p wrapped.
void cacheNamesKey(const WrappedKey& wrapped, const SealingKey::Bytes& key);
std::optional<SealingKey> cachedNamesKey(const WrappedKey& wrapped);

/// For tests: clears all keys held in memory, as a restart does.
void clearCachedKeys();

/// The study's key with that commitment; std::nullopt if neither this program holds it nor this
/// station has stored it.
/// @throws StorageError  if the station's own folder cannot be used.
std::optional<BlindingSecret> findStudyKey(const std::string& commitment);

/// Deletes the key of a study from this station's list. @return  whether the list had it
/// @throws StorageError
bool dropKey(const std::string& commitment);

/// Writes a key to a new file that only its owner can read, for use at another station.
/// @throws StorageError
void writeKeyFile(const std::string& path, const BlindingSecret& key, const std::string& title);

/// @throws UserError  if the file is no key file, or cannot be read.
BlindingSecret readKeyFile(const std::string& path);

/// Stores a study's key, wrapped with the passphrase, in study.db.
void storeWrapped(Database& study, const WrappedKey& key);
std::optional<WrappedKey> wrappedKeyIn(const Database& study);

}  // namespace study::storage

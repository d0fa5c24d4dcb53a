#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "study/storage/blinding_secret.h"
#include "study/storage/database.h"
#include "study/storage/keys/wrapped_key.h"

namespace study::storage {

/// Keeps the key of a study with this station, outside of the study's folder
/// (docs/decisions/0049). It is on the disk on return. Does nothing if it is kept already.
/// @param folder  where the study is, for people who look
/// @return  whether it was not kept before
/// @throws StorageError  if the station's own folder cannot be used.
bool keepKey(const BlindingSecret& key, const std::filesystem::path& folder);

/// Holds a key in the memory of this program, until it ends: keptKey() finds it, because windows
/// open a study more than once.
void holdKey(const BlindingSecret& key);

/// The same for the key that a passphrase opened, by what it is wrapped in: for names.
void holdOpened(const WrappedKey& wrapped, const SealingKey::Bytes& key);
std::optional<SealingKey> heldKey(const WrappedKey& wrapped);

/// For tests: what this program holds, as if it began again.
void forgetHeldKeys();

/// The key of the study that committed to it, if this program holds it or this station keeps it.
/// @throws StorageError  if the station's own folder cannot be used.
std::optional<BlindingSecret> keptKey(const std::string& commitment);

/// Takes the key of a study from this station. @return  whether it was there
/// @throws StorageError
bool dropKey(const std::string& commitment);

/// Writes a key to a new file that its owner alone can read, to be handed over.
/// @throws StorageError
void writeKeyFile(const std::string& path, const BlindingSecret& key, const std::string& title);

/// @throws UserError  if it is no such file, or cannot be read.
BlindingSecret readKeyFile(const std::string& path);

/// What a study's passphrase opens, in study.db.
void storeWrapped(Database& study, const WrappedKey& key);
std::optional<WrappedKey> wrappedKeyIn(const Database& study);

}  // namespace study::storage

#pragma once

#include <string>

#include "study/session/study.h"

namespace study {

/// Writes the key of a study to a new file, for another account or as a backup. The reason is
/// appended to the audit trail before the file is written.
/// @throws UserError  without a reason, or if the conditions of this study are not sealed
/// @throws storage::StorageError  if the key is not available, or the file cannot be written
void exportKey(Study& study, const std::string& file, const std::string& reason);

/// Adds the key in @p file to this station's list, where all programs of this account find it.
/// @throws UserError  if it is the key of another study, or if the study's conditions are not
///     sealed
void importKey(Study& study, const std::string& file);

/// Adds the key that unlock() has opened with a passphrase to this station's list.
void storeOpenedKey(Study& study);

/// @throws UserError  if the passphrase is shorter than 12 characters
void requireLongPassphrase(const std::string& passphrase);

/// Sets the passphrase that opens the study's key, in this study and in later copies of it. Older
/// copies keep their passphrase.
/// @throws UserError  without a reason, or if the passphrase is shorter than 12 characters
void setPassphrase(
    Study& study,
    const std::string& passphrase,
    const std::string& reason,
    const storage::PassphraseCost& cost = {});

/// Seals the names in identity.db, including existing and unsealed ones, with a key that @p
/// passphrase opens (docs/decisions/0062). A later call changes the passphrase; older copies of the
/// study are not affected.
/// @throws UserError  without a reason, if the passphrase is shorter than 12 characters, or if
///     names are locked
/// @throws storage::StorageError  (Damaged) if unsealed names of an older release were tampered
///     with
void setPassphraseOfNames(
    Study& study,
    const std::string& passphrase,
    const std::string& reason,
    const storage::PassphraseCost& cost = {});

/// Deletes the key from this station's list. Programs of this account then need the passphrase or
/// the exported key.
/// @throws UserError  without a reason, or if the key was never exported and there is no
///     passphrase: the conditions would be lost permanently.
void dropKey(Study& study, const std::string& reason);

/// Whether this account has the only copy of the key: it was never exported, and no passphrase
/// opens it.
bool hasOnlyCopyOfKey(Study& study);

/// One line on where the study's key is: "sealed; this account has the key". Empty in studies
/// without a secret or without blinding.
std::string keyStatusText(Study& study);

}  // namespace study

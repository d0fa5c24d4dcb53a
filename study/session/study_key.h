#pragma once

#include <string>

#include "study/session/study.h"

namespace study {

/// Writes the key of a study to a new file, to be handed over to another account or kept apart. The
/// audit trail has the reason before there is a file.
/// @throws UserError  without a reason, or if the conditions of this study are not sealed
/// @throws storage::StorageError  if the key is not here, or the file cannot be written
void exportKey(Study& study, const std::string& file, const std::string& reason);

/// Keeps the key in @p file with this station, from where every program of this account takes it.
/// @throws UserError  if it is the key of another study, or if nothing is sealed
void importKey(Study& study, const std::string& file);

/// The same with a key that a passphrase has opened already.
void keepOpenedKey(Study& study);

/// From now on, @p passphrase opens the key, in this study and in copies that are made of it.
/// An older copy of the file may still need the older passphrase.
/// @throws UserError  without a reason, or if the passphrase is shorter than 12 characters
void setPassphrase(
    Study& study,
    const std::string& passphrase,
    const std::string& reason,
    const storage::PassphraseCost& cost = {});

/// From now on, names in identity.db are sealed with a key that @p passphrase opens, also those
/// that are there, and those that an older release wrote in the open (docs/decisions/0062). A later
/// call changes the passphrase; copies that were made before keep what they have.
/// @throws UserError  without a reason, if the passphrase is shorter than 12 characters, or if
/// names
///     are locked
/// @throws storage::StorageError  (Damaged) if an older release wrote names, and some were changed
void setPassphraseOfNames(
    Study& study,
    const std::string& passphrase,
    const std::string& reason,
    const storage::PassphraseCost& cost = {});

/// Takes the key from this station: its programs then ask for the passphrase, or go on no more.
/// @throws UserError  without a reason, or if the key was never exported and there is no
/// passphrase:
///     nobody could ever say which condition an alternative was.
void dropKey(Study& study, const std::string& reason);

/// Whether this account has a key of which no copy was ever made.
bool hasOnlyCopyOfKey(Study& study);

/// Where the key of the study is, in a line for people: "sealed; this account has the key". Empty
/// if there is nothing to seal.
std::string sealInWords(Study& study);

}  // namespace study

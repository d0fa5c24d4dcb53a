#pragma once

#include <string>

#include "study/session/study.h"

namespace study::app {

/// The question for a new passphrase that encrypts the names of participants.
inline constexpr const char* kNewPassphraseOfNames =
    "New passphrase of names (write it down at a safe place: without it nobody ever reads them)";

/// Reads a passphrase from the terminal without showing it, or a line of standard input if that is
/// not a terminal. @throws UserError  if nothing was typed
std::string askPassphrase(const std::string& question);

/// Asks twice. @throws UserError  if the two passphrases differ
std::string askNewPassphrase(const std::string& question);

/// If this account does not have the study's key and the key is protected by a passphrase, asks for
/// it up to three times.
/// @throws UserError  if it was wrong three times
void askForKeyIfLocked(Study& study);

/// Asks in the same way for the passphrase of the participants' names. If @p isOptional, an empty
/// line leaves the names locked.
void askForNamesIfLocked(Study& study, bool isOptional = false);

}  // namespace study::app

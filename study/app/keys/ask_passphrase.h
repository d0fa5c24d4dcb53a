#pragma once

#include <string>

#include "study/session/study.h"

namespace study::app {

/// The question for a new passphrase that encrypts the names of participants.
inline constexpr const char* kAskNewNamesPassphrase =
    "New passphrase for the names (write it down and keep it safe: without it, the names are lost)";

/// Reads a passphrase from the terminal without echo, or a line of standard input if that is no
/// terminal. @throws UserError  if nothing was typed
std::string askPassphrase(const std::string& question);

/// Asks for a new passphrase twice. @throws UserError  if the two differ
std::string askNewPassphrase(const std::string& question);

/// If this account lacks the study's key, and a passphrase opens it, asks for the passphrase up to
/// three times.
/// @throws UserError  if the passphrase was wrong three times
void askForKeyIfLocked(Study& study);

/// If the participants' names are locked, asks for their passphrase up to three times. If
/// @p isOptional, an empty line leaves the names locked.
void askForNamesIfLocked(Study& study, bool isOptional = false);

}  // namespace study::app

#pragma once

#include <string>

#include "study/session/study.h"

namespace study::app {

/// What is asked where names are put behind a passphrase.
inline constexpr const char* kNewPassphraseOfNames =
    "New passphrase of names (write it down at a safe place: without it nobody ever reads them)";

/// Asks in the terminal, without showing what is typed. Where there is no terminal, a line of the
/// standard input is read. @throws UserError  if nothing was typed
std::string askPassphrase(const std::string& question);

/// The same, twice. @throws UserError  if the second was another one
std::string askNewPassphrase(const std::string& question);

/// Asks for the passphrase of a study if its key is behind one and not here; up to three times.
/// @throws UserError  if none was right
void unlockIfAsked(Study& study);

/// The same for names. An empty line goes on without, if @p isOptional.
void unlockNamesIfAsked(Study& study, bool isOptional = false);

}  // namespace study::app

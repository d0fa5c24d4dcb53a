#pragma once

#include <string>

#include "study/session/study.h"

namespace study::app {

/// Asks in the terminal, without showing what is typed. Where there is no terminal, a line of the
/// standard input is read. @throws UserError  if nothing was typed
std::string askPassphrase(const std::string& question);

/// Asks for the passphrase of a study if its key is behind one and not here; up to three times.
/// @throws UserError  if none was right
void unlockIfAsked(Study& study);

}  // namespace study::app

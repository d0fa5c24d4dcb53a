#pragma once

#include <string>

#include "study/model/run_mode.h"
#include "study/session/study.h"

namespace CLI {
class App;
}

namespace study::app {

/// Adds --run-mode to @p command.
void addRunModeOption(CLI::App& command, std::string& name);

/// Adds --run-mode for a new session, live or pilot, and --pilot for short.
void addRunModeOfSession(CLI::App& command, std::string& name);

/// Adds --reason, for results that name conditions (study/session/unblinding.h).
void addReasonOption(CLI::App& command, std::string& reason);

/// The run mode named by @p name, or live if it is empty.
/// @throws UserError  in words, if there are no sessions of that mode; names the modes with
///     sessions.
RunMode chosenRunMode(Study& study, const std::string& name);

}  // namespace study::app

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

/// Adds --run-mode for a session that somebody takes part in, live or pilot, and --pilot for short.
void addRunModeOfSession(CLI::App& command, std::string& name);

/// Adds --reason, for what names conditions beside results (study/session/unblinding.h).
void addReasonOption(CLI::App& command, std::string& reason);

/// The run mode that @p name says, or live where it says nothing.
/// @throws UserError  in words, where that leaves no session: which ones there are.
RunMode chosenRunMode(Study& study, const std::string& name);

}  // namespace study::app

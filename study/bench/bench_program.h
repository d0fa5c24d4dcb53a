#pragma once

#include <memory>

#include "study/app/commands.h"

namespace study::bench {

using app::Action;

// Each function adds its command to palpate-bench. Parsing sets @p action to the action of the
// command that was called, which returns the exit status: 1 if an error or a count exceeds its
// bound.
void addAccuracyCommand(CLI::App& program, Action& action);
void addStabilityCommand(CLI::App& program, Action& action);
void addServoCommand(CLI::App& program, Action& action);
void addDevicesCommand(CLI::App& program, Action& action);
void addStatsCommand(CLI::App& program, Action& action);
void addWindowsCommand(CLI::App& program, Action& action);  // in builds with windows
void addCollectCommand(CLI::App& program, Action& action);  // in builds with libpq

/// The command line of palpate-bench. Parsing sets @p action to the action of the called command.
/// @param action  must outlive the program.
std::unique_ptr<CLI::App> makeBenchProgram(app::Action& action);

}  // namespace study::bench

#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace study::app {

/// What the call on the command line chose to do. Returns the exit status: 0, or 1 where the world
/// says no (a protocol with errors, a study that does not verify).
using Action = std::function<int()>;

// One line a noun: each adds its commands to the program; the one that was called sets the action.
void addInstrumentCommands(CLI::App& program, Action& action);
void addProtocolCommands(CLI::App& program, Action& action);
void addStudyCommands(CLI::App& program, Action& action);
void addConsentCommand(CLI::App& noun, Action& action);  // of the noun "study"
void addStatsCommands(CLI::App& program, Action& action);
void addReportCommand(CLI::App& program, Action& action);
void addExportCommand(CLI::App& program, Action& action);
void addRecordingCommands(CLI::App& program, Action& action);
void addSceneCommands(CLI::App& program, Action& action);
void addMaterialCommands(CLI::App& program, Action& action);
void addPackingCommands(CLI::App& program, Action& action);
void addBenchCommand(CLI::App& program, Action& action);
void addDeviceCommands(CLI::App& program, Action& action);
void addDemoCommand(CLI::App& program, Action& action);
void addPlanCommand(CLI::App& program, Action& action);

/// Adds to a noun instead of to the program.
void addCheckTableCommand(CLI::App& stats, Action& action);
void addTestCommand(CLI::App& stats, Action& action);

}  // namespace study::app

#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace study::app {

/// The action of the command that was called. Returns the exit status: 0, or 1 for a negative
/// result (a protocol with errors, a study that fails verification).
using Action = std::function<int()>;

// Each function adds its commands to the program. Parsing sets @p action to the action of the
// command that was called.
void addInstrumentCommands(CLI::App& program, Action& action);
void addProtocolCommands(CLI::App& program, Action& action);
void addStudyCommands(CLI::App& program, Action& action);
void addStatsCommands(CLI::App& program, Action& action);
void addReportCommand(CLI::App& program, Action& action);
void addExportCommand(CLI::App& program, Action& action);
void addRecordingCommands(CLI::App& program, Action& action);
void addSceneCommands(CLI::App& program, Action& action);
void addMaterialCommands(CLI::App& program, Action& action);
void addPackingCommands(CLI::App& program, Action& action);
void addBenchCommand(CLI::App& program, Action& action);
void addCollectCommand(CLI::App& program, Action& action);
void addDeviceCommands(CLI::App& program, Action& action);
void addDemoCommand(CLI::App& program, Action& action);
void addPlanCommand(CLI::App& program, Action& action);

// These add subcommands to the command that their first parameter is named after.
void addConsentCommand(CLI::App& study, Action& action);
void addErasureCommands(CLI::App& study, Action& action);
void addPersonCommands(CLI::App& study, Action& action);
void addEvidenceCommands(CLI::App& study, Action& action);
void addKeyCommands(CLI::App& study, Action& action);
void addStudyTextsCommand(CLI::App& study, Action& action);
void addProtocolTextsCommand(CLI::App& protocol, Action& action);
void addCalibrateCommand(CLI::App& recording, Action& action);
void addCheckTableCommand(CLI::App& stats, Action& action);
void addTestCommand(CLI::App& stats, Action& action);

}  // namespace study::app

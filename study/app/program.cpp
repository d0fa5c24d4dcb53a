#include "study/app/program.h"

#include <CLI/CLI.hpp>

#include "study/app/command_options.h"
#include "study/app/command_reference.h"
#include "study/app/commands.h"
#include "study/session/study.h"

namespace study::app {

std::unique_ptr<CLI::App> makeProgram(Action& action) {
  auto program = std::make_unique<CLI::App>(
      "Face-validity studies of haptic surgical simulators: from the protocol to the "
      "statistics.\nHelp on a command: palpate COMMAND --help. The program with windows: "
      "palpate-studio.",
      "palpate");
  program->set_version_flag("--version", "palpate " + std::string(appVersion()));
  program->require_subcommand(1);
  setHelpFormat(*program);
  addDemoCommand(*program, action);
  addProtocolCommands(*program, action);
  addInstrumentCommands(*program, action);
  addPlanCommand(*program, action);
  addStudyCommands(*program, action);
  addStatsCommands(*program, action);
  addReportCommand(*program, action);
  addExportCommand(*program, action);
  addRecordingCommands(*program, action);
  addMaterialCommands(*program, action);
  addPackingCommands(*program, action);
  addSceneCommands(*program, action);
  addDeviceCommands(*program, action);
  addCollectCommand(*program, action);
  addBenchCommand(*program, action);
  refuseNegativeSeeds(*program);
  return program;
}

}  // namespace study::app

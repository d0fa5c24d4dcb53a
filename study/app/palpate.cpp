// palpate: everything that can be done at all, without windows.
#include <cstdio>
#include <exception>
#include <string>

#include <CLI/CLI.hpp>

#include "study/app/commands.h"
#include "study/study.h"

int main(int argc, char** argv) {
  CLI::App program(
      "Face-validity studies of haptic surgical simulators: write a protocol, run sessions, get "
      "the "
      "table.\nEvery command explains itself: palpate COMMAND --help. The windows: palpate-studio.",
      "palpate");
  program.set_version_flag("--version", "palpate " + std::string(study::appVersion()));
  program.require_subcommand(1);
  program.get_formatter()->column_width(34);

  study::app::Action action;
  study::app::addDemoCommand(program, action);
  study::app::addProtocolCommands(program, action);
  study::app::addStudyCommands(program, action);
  study::app::addStatsCommands(program, action);
  study::app::addReportCommand(program, action);
  study::app::addExportCommand(program, action);
  study::app::addRecordingCommands(program, action);
  study::app::addSceneCommands(program, action);

  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    constexpr int kTheCallIsWrong = 2;
    return program.exit(error) == 0 ? 0 : kTheCallIsWrong;
  }
  try {
    return action ? action() : 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "palpate: %s\n", error.what());
    return 1;
  }
}

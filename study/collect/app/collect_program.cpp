#include "study/collect/app/collect_program.h"

#include <algorithm>

#include <CLI/CLI.hpp>

#include "study/app/command_options.h"
#include "study/app/command_reference.h"
#include "study/app/commands.h"
#include "study/model/user_error.h"
#include "study/session/study.h"

namespace study::collect {

std::unique_ptr<CLI::App> makeCollectProgram(Action& action) {
  auto program = std::make_unique<CLI::App>(
      "One study at many sites, collected in PostgreSQL: each station, a computer that "
      "runs\nsessions, keeps its own folder and sends what is new.\nHow it fits together: "
      "docs/collecting.md. Try it on this computer "
      "alone: "
      "palpate collect demo.",
      "palpate collect");
  program->set_version_flag("--version", "palpate " + std::string(appVersion()));
  program->require_subcommand(1);
  app::setHelpFormat(*program);
  addDemoCommand(*program, action);
  addServerCommands(*program, action);
  addStationCommands(*program, action);
  addPullCommands(*program, action);
  app::refuseNegativeSeeds(*program);
  return program;
}

int runPalpate(std::vector<std::string> words) {
  const auto command = words.front();
  std::ranges::reverse(words);  // CLI11 expects them in reverse order
  CLI::App program;
  app::Action run;
  app::addStatsCommands(program, run);
  app::addReportCommand(program, run);
  try {
    program.parse(words);
  } catch (const CLI::ParseError& error) {
    throw UserError(
        std::string(error.what()) + " ('palpate " + command + " --help' has all options.)");
  }
  return run();
}

}  // namespace study::collect

#include "study/collect/app/collect_program.h"

#include <CLI/CLI.hpp>

#include "study/session/study.h"

namespace study::collect {

std::unique_ptr<CLI::App> makeCollectProgram(Action& action) {
  auto program = std::make_unique<CLI::App>(
      "One study at many sites, collected in PostgreSQL: each station keeps its own folder and "
      "sends what is new.\nHow it fits together: docs/collecting.md. Try it on this computer "
      "alone: "
      "palpate collect demo.",
      "palpate collect");
  program->set_version_flag("--version", "palpate " + std::string(appVersion()));
  program->require_subcommand(1);
  program->get_formatter()->column_width(34);
  addDemoCommand(*program, action);
  addServerCommands(*program, action);
  addStationCommands(*program, action);
  addPullCommands(*program, action);
  return program;
}

}  // namespace study::collect

#include "study/bench/bench_program.h"

#include <CLI/CLI.hpp>

#include "study/app/command_reference.h"
#include "study/session/study.h"

namespace study::bench {

std::unique_ptr<CLI::App> makeBenchProgram(app::Action& action) {
  auto program = std::make_unique<CLI::App>(
      "Benchmarks of Palpate: how exact, stable, fast and punctual it is on this computer.\nErrors "
      "and counts have limits. If one is exceeded, the program reports failure (exit status 1). "
      "Times have no limit.\ndocs/benchmarks.md explains what each measures.",
      "palpate-bench");
  program->set_version_flag("--version", "palpate-bench " + std::string(appVersion()));
  program->require_subcommand(1);
  app::setHelpFormat(*program);
  addAccuracyCommand(*program, action);
  addStabilityCommand(*program, action);
  addServoCommand(*program, action);
  addDevicesCommand(*program, action);
  addStatsCommand(*program, action);
#ifdef PALPATE_HAS_WINDOWS
  addWindowsCommand(*program, action);
#endif
#ifdef PALPATE_HAS_COLLECT
  addCollectCommand(*program, action);
#endif
  return program;
}

}  // namespace study::bench

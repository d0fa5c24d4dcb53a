#include <CLI/CLI.hpp>

#include "study/app/commands.h"
#include "study/app/sibling_program.h"

namespace study::app {

void addBenchCommand(CLI::App& program, Action& action) {
  auto* command = program.add_subcommand(
      "bench", "Measure errors, stability, speed and timing: starts palpate-bench");
  command->prefix_command();  // all further arguments go to the other program
  command->set_help_flag();   // --help is passed to the other program, too
  command->callback([&action, command] {
    action = [words = command->remaining()]() -> int { replaceProcessBy("palpate-bench", words); };
  });
}

}  // namespace study::app

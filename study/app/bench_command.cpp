#include <CLI/CLI.hpp>

#include "study/app/commands.h"
#include "study/app/sibling_program.h"

namespace study::app {

void addBenchCommand(CLI::App& program, Action& action) {
  auto* noun = program.add_subcommand(
      "bench", "Measure errors, stability, speed and timing: starts palpate-bench");
  noun->prefix_command();  // all further arguments go to the other program
  noun->set_help_flag();   // --help is passed to the other program, too
  noun->callback([&action, noun] {
    action = [words = noun->remaining()]() -> int { handOver("palpate-bench", words); };
  });
}

}  // namespace study::app

#include <CLI/CLI.hpp>

#include "study/app/commands.h"
#include "study/app/sibling_program.h"

namespace study::app {

void addBenchCommand(CLI::App& program, Action& action) {
  auto* noun = program.add_subcommand(
      "bench",
      "Measure how exact, stable, fast and punctual Palpate is on this computer: hands over to "
      "palpate-bench, and 'palpate bench --help' lists what it measures");
  noun->prefix_command();  // all that follows is the other program's
  noun->set_help_flag();   // also --help
  noun->callback([&action, noun] {
    action = [words = noun->remaining()]() -> int { handOver("palpate-bench", words); };
  });
}

}  // namespace study::app

// Commands that start another program of Palpate.
#include <filesystem>
#include <string>
#include <system_error>

#include <CLI/CLI.hpp>

#include "study/app/commands.h"
#include "study/app/sibling_program.h"
#include "study/model/user_error.h"

namespace study::app {
namespace {

/// Adds a command without options: all further arguments go to @p sibling.
/// @param whyAbsent  the error if the program is not there; empty: that of replaceProcessBy()
void addSiblingCommand(
    CLI::App& program,
    Action& action,
    const char* name,
    const char* help,
    const std::string& sibling,
    const std::string& whyAbsent = {}) {
  auto* command = program.add_subcommand(name, help);
  command->prefix_command();
  command->set_help_flag();  // --help is passed to the other program, too
  command->callback([&action, command, sibling, whyAbsent] {
    action = [words = command->remaining(), sibling, whyAbsent]() -> int {
      std::error_code error;
      const bool isThere = std::filesystem::exists(siblingProgram(sibling), error);
      if (!isThere && !whyAbsent.empty()) throw UserError(whyAbsent);
      replaceProcessBy(sibling, words);
    };
  });
}

}  // namespace

void addBenchCommand(CLI::App& program, Action& action) {
  addSiblingCommand(
      program,
      action,
      "bench",
      "Measure errors, stability, speed and timing: starts palpate-bench",
      "palpate-bench");
}

void addCollectCommand(CLI::App& program, Action& action) {
  addSiblingCommand(
      program,
      action,
      "collect",
      "One study at many sites, collected in PostgreSQL: starts palpate-collect",
      "palpate-collect",
      "This palpate was built without PostgreSQL's client library, so that it cannot collect "
      "from several sites: './setup --collect' installs it; then build again.");
}

}  // namespace study::app

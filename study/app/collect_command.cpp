#include <filesystem>

#include <CLI/CLI.hpp>

#include "study/app/commands.h"
#include "study/app/sibling_program.h"
#include "study/model/user_error.h"

namespace study::app {
namespace {

constexpr const char* kProgram = "palpate-collect";

[[noreturn]] void collect(const std::vector<std::string>& words) {
  std::error_code error;
  if (!std::filesystem::exists(siblingProgram(kProgram), error)) {
    throw UserError(
        "This palpate was built without PostgreSQL's client library, so that it cannot collect "
        "from several sites: './setup --collect' installs it; then build again.");
  }
  replaceProcessBy(kProgram, words);
}

}  // namespace

void addCollectCommand(CLI::App& program, Action& action) {
  auto* command = program.add_subcommand(
      "collect", "One study at many sites, collected in PostgreSQL: starts palpate-collect");
  command->prefix_command();  // all further arguments go to the other program
  command->set_help_flag();   // --help is passed to the other program, too
  command->callback(
      [&action, command] { action = [words = command->remaining()]() -> int { collect(words); }; });
}

}  // namespace study::app

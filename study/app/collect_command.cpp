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
  handOver(kProgram, words);
}

}  // namespace

void addCollectCommand(CLI::App& program, Action& action) {
  auto* noun = program.add_subcommand(
      "collect", "One study at many sites, collected in PostgreSQL: starts palpate-collect");
  noun->prefix_command();  // all further arguments go to the other program
  noun->set_help_flag();   // --help is passed to the other program, too
  noun->callback(
      [&action, noun] { action = [words = noun->remaining()]() -> int { collect(words); }; });
}

}  // namespace study::app

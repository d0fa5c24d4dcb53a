// palpate: everything that can be done at all, without windows.
#include <cstdio>
#include <exception>
#include <string>

#include <CLI/CLI.hpp>

#include "study/app/program.h"

namespace {

constexpr int kTheWorldSaidNo = 1;
constexpr int kTheCallIsWrong = 2;

/// The command that was called, as far as it is one: "palpate study status".
const CLI::App& commandCalled(const CLI::App& program, std::string& name) {
  const CLI::App* command = &program;
  name = program.get_name();
  while (!command->get_subcommands().empty()) {
    command = command->get_subcommands().front();
    name += " " + command->get_name();
  }
  return *command;
}

/// What is wrong with a call, in words.
std::string whatIsWrong(const CLI::App& program, const CLI::ParseError& error) {
  std::string name;
  const auto& command = commandCalled(program, name);
  const std::string explains = "'" + name + " --help' explains it.\n";
  const auto unknown = program.remaining(true);
  if (unknown.empty()) {
    return "palpate: " + std::string(error.what()) + ". " + explains;
  }
  std::string known;
  for (const auto* verb : command.get_subcommands({})) {
    known += (known.empty() ? "" : ", ") + verb->get_name();
  }
  return "palpate: '" + unknown.front() + "' means nothing to '" + name + "'. " +
         (known.empty() ? "" : "There are: " + known + ". ") + explains;
}

/// Whether everything that was printed has been written: a table on a full disk is half a table.
bool isPrinted() {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return true;
  std::fputs(
      "palpate: what was to be printed could not be written. Free some space, or print "
      "elsewhere.\n",
      stderr);
  return false;
}

}  // namespace

int main(int argc, char** argv) {
  study::app::Action action;
  const auto described = study::app::makeProgram(action);
  CLI::App& program = *described;
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return program.exit(error);  // help, version
    std::fputs(whatIsWrong(program, error).c_str(), stderr);
    return kTheCallIsWrong;
  }
  try {
    const int status = action ? action() : 0;
    return isPrinted() ? status : kTheWorldSaidNo;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "palpate: %s\n", error.what());
    return kTheWorldSaidNo;
  }
}

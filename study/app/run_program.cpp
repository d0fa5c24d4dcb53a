#include "study/app/run_program.h"

#include <cstdio>
#include <exception>
#include <string>

#include <CLI/CLI.hpp>

#include "base/joined.h"
#include "study/app/printing/visible_output.h"
#include "study/model/new_file.h"

namespace study::app {
namespace {

constexpr int kFailed = 1;
constexpr int kWrongCall = 2;

/// The innermost command that was recognised in the call; its full name is written to @p name:
/// "palpate study status".
const CLI::App& commandCalled(const CLI::App& program, std::string& name) {
  const CLI::App* command = &program;
  name = program.get_name();
  while (!command->get_subcommands().empty()) {
    command = command->get_subcommands().front();
    name += " " + command->get_name();
  }
  return *command;
}

/// A message on a mistake in the call.
std::string describeMistake(const CLI::App& program, const CLI::ParseError& error) {
  std::string name;
  const auto& command = commandCalled(program, name);
  const std::string explains = "'" + name + " --help' explains it.\n";
  auto known = base::joined(command.get_subcommands({}), ", ", &CLI::App::get_name);
  if (!known.empty()) known = "There are: " + known + ". ";
  const auto unknown = program.remaining(true);
  if (unknown.empty()) {
    return program.get_name() + ": " + error.what() + ". " + known + explains;
  }
  return program.get_name() + ": '" + unknown.front() + "' means nothing to '" + name + "'. " +
         known + explains;
}

/// Whether all output was written. If not, prints an error, so that a table that was cut off by a
/// full disk is not taken for complete.
bool isOutputWritten(const CLI::App& program) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return true;
  std::fprintf(
      stderr,
      "%s: what was to be printed could not be written. Free some space, or print elsewhere.\n",
      program.get_name().c_str());
  return false;
}

}  // namespace

int runProgram(CLI::App& program, const Action& action, int argc, char** argv) {
  setPrivateUmask();
  forbidCoreFiles();
  escapeControlCharactersInOutput();
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return program.exit(error);  // --help or --version
    std::fputs(describeMistake(program, error).c_str(), stderr);
    return kWrongCall;
  }
  try {
    const int status = action ? action() : 0;
    return isOutputWritten(program) ? status : kFailed;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", program.get_name().c_str(), error.what());
    return kFailed;
  }
}

}  // namespace study::app

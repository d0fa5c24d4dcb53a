#include "study/app/run_mode_option.h"

#include <map>

#include <CLI/CLI.hpp>

#include "study/model/user_error.h"
#include "study/words/counted.h"

namespace study::app {

void addRunModeOption(CLI::App& command, std::string& name) {
  command.add_option("--run-mode", name, "Which sessions count (default: live)")
      ->check(CLI::IsMember({"live", "pilot", "simulated"}));
}

void addRunModeOfSession(CLI::App& command, std::string& name) {
  auto* mode =
      command
          .add_option(
              "--run-mode",
              name,
              "What the session is for; a pilot takes no place from a participant (default: "
              "live)")
          ->check(CLI::IsMember({"live", "pilot"}));
  command
      .add_flag_callback(
          "--pilot", [&name] { name = "pilot"; }, "The same as --run-mode pilot")
      ->excludes(mode);
}

void addReasonOption(CLI::App& command, std::string& reason) {
  command.add_option(
      "--reason",
      reason,
      "Why conditions of live or pilot sessions are named (unblinding); goes into the audit trail");
}

RunMode chosenRunMode(Study& study, const std::string& name) {
  const RunMode mode = runModeNamed(name).value_or(RunMode::Live);
  std::map<RunMode, int> counts;
  for (const auto& row : study.sessions().all()) ++counts[row.runMode];
  if (counts[mode] > 0 || !name.empty()) return mode;
  std::string others;
  for (const auto other : {RunMode::Pilot, RunMode::Simulated}) {
    if (counts[other] == 0) continue;
    const std::string what(nameOf(other));
    others += " " +
              words::counted(
                  static_cast<std::uint64_t>(counts[other]),
                  what + " session is",
                  what + " sessions are") +
              " there: add --run-mode " + what + ".";
  }
  throw UserError("No participant has taken part in " + study.folder().string() + " yet." + others);
}

}  // namespace study::app

#include "study/app/command_options.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <map>
#include <string_view>

#include "base/joined.h"
#include "protocols/load_protocol.h"
#include "study/model/user_error.h"
#include "study/words/counted.h"

namespace study::app {

CLI::App& addCommandGroup(CLI::App& program, const char* name, const char* help) {
  auto& noun = *program.add_subcommand(name, help);
  noun.require_subcommand(1);
  return noun;
}

void addStudyFolder(CLI::App& command, std::string& folder) {
  command.add_option("FOLDER", folder, "Folder of the study")->required();
}

CLI::Option& addProtocolFile(CLI::App& command, std::string& file, const char* name) {
  return *command
              .add_option(
                  name, file, "Protocol file (.json), or a name from 'palpate protocol list'")
              ->required();
}

protocols::LoadedProtocol loadValidProtocol(const std::string& file) {
  questionnaires::Problems problems;
  auto loaded = protocols::loadProtocolFile(file, problems);
  if (!loaded) {
    throw UserError(file + " cannot be used yet:\n" + questionnaires::describe(problems.all()));
  }
  return std::move(*loaded);
}

std::optional<protocols::LoadedProtocol> loadOrPrintProblems(const std::string& file) {
  questionnaires::Problems problems;
  auto loaded = protocols::loadProtocolFile(file, problems);
  if (!loaded) std::fputs(questionnaires::describe(problems.all()).c_str(), stderr);
  return loaded;
}

void addRunModeOption(CLI::App& command, std::string& name) {
  command
      .add_option(
          "--run-mode",
          name,
          "Run mode of the sessions to include; others are left out (default: live)")
      ->check(CLI::IsMember({"live", "pilot", "simulated"}));
}

void addRunModeOfSession(CLI::App& command, std::string& name) {
  auto* mode =
      command
          .add_option(
              "--run-mode",
              name,
              "Run mode of the session (default: live); a pilot uses up none of the planned "
              "orders")
          ->check(CLI::IsMember({"live", "pilot"}));
  command
      .add_flag_callback(
          "--pilot", [&name] { name = "pilot"; }, "Short form of --run-mode pilot")
      ->excludes(mode);
}

void addReasonOption(CLI::App& command, std::string& reason) {
  command.add_option(
      "--reason",
      reason,
      "Reason for naming the conditions of live or pilot sessions (unblinding); recorded in the "
      "audit trail");
}

CLI::Option* addAuditedReason(CLI::App& command, std::string& reason) {
  return command.add_option(
      "--reason", reason, "Reason for doing so; it is recorded in the audit trail");
}

void addReasonOfAmendment(CLI::App& command, std::string& reason) {
  command.add_option(
      "--reason", reason, "Reason for the change; required once a participant has begun");
}

void addReportFolder(CLI::App& command, std::string& folder, const std::string& contents) {
  command
      .add_option(
          "--report",
          folder,
          "Folder for " + contents + " and an HTML page; no file is overwritten")
      ->type_name("FOLDER");
}

void addWordingOption(CLI::App& command, std::string& wording) {
  command
      .add_option(
          "--wording",
          wording,
          "Style of numbers in sentences: apa (p = .021 [0.41, 2.42]), vancouver (P = 0.021, 0.41 "
          "to 2.42)")
      ->check(CLI::IsMember({"apa", "vancouver"}))
      ->capture_default_str();
}

void printNeedOfServer(const Study& study) {
  if (study.station().isNone()) return;
  fmt::print(
      "This is one station of several: what is recorded with this version is refused by the server "
      "until it has the version, too. The administrator of the server adds it there: palpate study "
      "protocol "
      "{} --out FILE, palpate collect init --protocol FILE.\n",
      asShellWord(study.folder().string()));
}

std::string asShellWord(const std::string& word) {
  const auto isPlain = [](unsigned char c) {
    return std::isalnum(c) != 0 || c >= 0x80 ||
           std::string_view("/._-+=:,@%").find(c) != std::string_view::npos;
  };
  if (!word.empty() && std::ranges::all_of(word, isPlain)) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

void refuseNegativeSeeds(CLI::App& program) {
  for (auto* command : program.get_subcommands({})) refuseNegativeSeeds(*command);
  auto* seed = program.get_option_no_throw("--seed");
  if (seed == nullptr) return;
  seed->check([](const std::string& text) {
    return text.starts_with('-') ? text + " is no seed: a whole number from 0 on" : std::string();
  });
}

CLI::Validator fileEndingIn(const std::vector<std::string>& endings) {
  return CLI::Validator(
      [endings](const std::string& path) -> std::string {
        const auto ending = std::filesystem::path(path).extension().string();
        if (std::ranges::find(endings, ending) != endings.end()) return "";
        return "'" + path + "' does not end in " + base::joined(endings, " or ");
      },
      "FILE");
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

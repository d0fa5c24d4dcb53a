#pragma once

#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "protocols/model/loaded_protocol.h"
#include "study/app/commands.h"
#include "study/model/run_mode.h"
#include "study/session/study.h"

namespace study::app {

/// A command and the struct that its options are written to. The struct lives as long as the
/// command.
template <typename Options>
struct AddedCommand {
  CLI::App* command;
  Options& options;
};

/// Adds a subcommand to @p above. When it is called, @p action is set to call @p perform with the
/// parsed options.
template <typename Parameter>
auto addCommand(
    CLI::App& above,
    Action& action,
    const std::string& name,
    const std::string& help,
    int (*perform)(Parameter)) {
  using Options = std::remove_cvref_t<Parameter>;
  auto options = std::make_shared<Options>();
  auto* command = above.add_subcommand(name, help);
  command->callback(
      [&action, options, perform] { action = [options, perform] { return perform(*options); }; });
  return AddedCommand<Options>{command, *options};
}

/// Adds a command without an action, for subcommands.
CLI::App& addCommandGroup(CLI::App& program, const char* name, const char* help);

/// Adds the argument FOLDER, the folder of a study.
void addStudyFolder(CLI::App& command, std::string& folder);

/// Adds the argument FILE, or @p name: a protocol file, or the id of a protocol in the library.
CLI::Option& addProtocolFile(CLI::App& command, std::string& file, const char* name = "FILE");

/// The protocol in a file or in the library. @throws UserError  with all problems of the file.
protocols::LoadedProtocol loadValidProtocol(const std::string& file);

/// The protocol in a file or in the library; std::nullopt after printing all problems of the file.
std::optional<protocols::LoadedProtocol> loadOrPrintProblems(const std::string& file);

/// Adds --run-mode to @p command.
void addRunModeOption(CLI::App& command, std::string& name);

/// Adds --run-mode for a new session (live or pilot), and --pilot as its short form.
void addRunModeOfSession(CLI::App& command, std::string& name);

/// Adds --reason, the reason for showing results that name conditions (study/session/unblinding.h).
void addReasonOption(CLI::App& command, std::string& reason);

/// Adds --reason, the reason for an action; it is recorded in the audit trail.
CLI::Option* addAuditedReason(CLI::App& command, std::string& reason);

/// Adds --reason, the reason for amending the protocol.
void addReasonOfAmendment(CLI::App& command, std::string& reason);

/// Adds --report, the folder for @p contents ("tables, figures") and a page.
void addReportFolder(CLI::App& command, std::string& folder, const std::string& contents);

/// Adds --wording, the style in which sentences report numbers.
void addWordingOption(CLI::App& command, std::string& wording);

/// A word of a command, as a shell reads it: in quotation marks if it has other characters than
/// letters, digits and a few signs.
std::string asShellWord(const std::string& word);

/// After an amendment at one of several stations: prints that the server needs the version, too.
void printNeedOfServer(const Study& study);

/// Makes every option --seed of @p program and its commands refuse negative numbers, which would be
/// read as large ones.
void refuseNegativeSeeds(CLI::App& program);

/// A validator for finite numbers from @p least to @p most. CLI::Range accepts "nan", which is
/// neither below nor above a bound.
inline CLI::Validator finiteRange(double least, double most) {
  const CLI::Range range(least, most);
  return CLI::Validator(
      [range, least, most](std::string& text) {
        const bool isNumber = text.find_first_of("nN") == std::string::npos;  // "nan" and "inf"
                                                                              // contain an n
        if (!isNumber) return text + " is no number";
        return range(text).empty() ? std::string()
                                   : fmt::format("{} lies outside {:g} to {:g}", text, least, most);
      },
      range.get_description());
}

/// A validator for names of files that end in one of @p endings, from which the content follows.
CLI::Validator fileEndingIn(const std::vector<std::string>& endings);

/// The run mode named by @p name, or live if it is empty.
/// @throws UserError  if there are no sessions of that mode; the message names the modes with
///     sessions.
RunMode chosenRunMode(Study& study, const std::string& name);

}  // namespace study::app

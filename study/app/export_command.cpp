#include <map>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "study/app/command_options.h"
#include "study/app/keys/ask_passphrase.h"
#include "study/export/condition_codes.h"
#include "study/export/export.h"
#include "study/export/named_people.h"
#include "study/export/public_tables.h"
#include "study/session/unblinding.h"
#include "study/words/counted.h"

namespace study::app {
namespace {

struct ExportArguments {
  std::string folder;
  std::string format = "csv";
  std::string out;
  std::string runMode;
  bool traces = false;
  bool exact = false;
  bool texts = false;
  bool unblind = false;
  std::string folderOfCodes;
  std::string reason;
  bool isForPublic = false;
  std::size_t smallestClass = kSmallestPublicClassSize;
};

const std::map<std::string, ExportFormat> kFormats{
    {"csv", ExportFormat::Csv},
    {"json", ExportFormat::Json},
    {"psych-ds", ExportFormat::PsychDs},
    {"bids", ExportFormat::Bids},
    {"r", ExportFormat::R},
    {"python", ExportFormat::Python}};

/// Prints a summary of an export.
void printExport(
    Study& study,
    const ExportArguments& options,
    const ExportOptions& exportOptions,
    const WrittenExport& written) {
  const auto sessions = written.sessions;
  const std::string what = std::string(nameOf(*exportOptions.runMode)) + " session";
  fmt::print(
      "Export saved: {} ({}, {}).\n",
      options.out,
      sessions == 0 ? "no " + what + "s" : words::counted(sessions, what),
      blindingInWords(study, exportOptions));
  if (sessions == 0) fmt::print("Its tables are empty.\n");
  if (sessions > 0 && exportOptions.runMode == RunMode::Simulated) {
    fmt::print("Nobody took part: these answers say nothing about any method.\n");
  }
  if (!written.isNoted) fmt::print("{}\n", kCopyNotNoted);
}

RunMode runModeIn(const ExportArguments& options) {
  const auto access = options.unblind || options.isForPublic ? storage::Database::Access::ReadWrite
                                                             : storage::Database::Access::ReadOnly;
  auto study = Study::open(options.folder, access);
  return chosenRunMode(study, options.runMode);
}

int exportAs(const ExportArguments& options) {
  ExportOptions exportOptions{
      .format = kFormats.at(options.format),
      .runMode = runModeIn(options),
      .isBlinded = !options.unblind,
      .hasTraces = options.traces,
      .isExact = options.exact,
      .hasTexts = options.texts};
  if (!options.folderOfCodes.empty()) exportOptions.codes = codeSetOf(options.folderOfCodes);
  if (options.isForPublic) exportOptions.publicClassSize = options.smallestClass;
  auto study = openForExport(options.folder, exportOptions);
  askForKeyIfLocked(study);
  if (!options.isForPublic && exportOptions.runMode != RunMode::Simulated) {
    askForNamesIfLocked(study, true);
    fmt::print("{}", identifiabilityInWords(study, exportOptions));
  }
  if (options.isForPublic) fmt::print("{}", describe(publicRelease(study, exportOptions)));
  printExport(
      study,
      options,
      exportOptions,
      exportStudy(study, options.out, exportOptions, options.reason));
  return 0;
}

}  // namespace

void addExportCommand(CLI::App& program, Action& action) {
  auto [command, options] = addCommand(
      program,
      action,
      "export",
      "Export a study's data: tidy tables, one row per answer, blinded by default",
      exportAs);
  addStudyFolder(*command, options.folder);
  command->add_option("--out", options.out, "New folder")->type_name("FOLDER")->required();
  command
      ->add_option(
          "--format",
          options.format,
          "Format: csv, json (one document), psych-ds, bids, or r and python (tables with scripts)")
      ->check(CLI::IsMember({"csv", "json", "psych-ds", "bids", "r", "python"}))
      ->capture_default_str();
  addRunModeOption(*command, options.runMode);
  auto* traces = command->add_flag(
      "--traces",
      options.traces,
      "Include the recorded samples of every trial (gzip); needs --unblind");
  auto* exact = command->add_flag(
      "--exact", options.exact, "Keep exact dates, times, ages and other numbers about people");
  auto* texts =
      command->add_flag("--texts", options.texts, "Include what participants and operators wrote");
  auto* unblind = command->add_flag(
      "--unblind",
      options.unblind,
      "Name the condition of each alternative (recorded in the audit trail)");
  auto* reason = command->add_option(
      "--reason", options.reason, "Reason for unblinding; recorded in the audit trail");
  unblind->needs(reason);
  auto* codes =
      command
          ->add_option(
              "--codes-of",
              options.folderOfCodes,
              "Reuse the condition codes of the earlier export in this folder (default: new codes)")
          ->type_name("FOLDER");
  auto* isForPublic = command->add_flag(
      "--public",
      options.isForPublic,
      "Data to publish: ages etc. as ranges, no free text, no times, new ids, no group smaller "
      "than --k (k-anonymous)");
  isForPublic->excludes(exact)->excludes(texts)->excludes(codes)->excludes(traces);
  command
      ->add_option(
          "--k",
          options.smallestClass,
          "At least this many participants share each published combination of age range, sex and "
          "the like; 5 or more")
      ->needs(isForPublic)
      ->check(CLI::Range(kSmallestPublicClassSize, std::size_t{100'000}))
      ->capture_default_str();
}

}  // namespace study::app

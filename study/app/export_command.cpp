#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "study/app/commands.h"
#include "study/app/run_mode_option.h"
#include "study/export.h"

namespace study::app {
namespace {

struct ExportArguments {
  std::string folder;
  std::string format = "csv";
  std::string out;
  std::string runMode;
  bool unblind = false;
  std::string reason;
};

int exportAs(const ExportArguments& options) {
  SystemClock clock;
  const auto access =
      options.unblind ? storage::Database::Access::ReadWrite : storage::Database::Access::ReadOnly;
  auto study = Study::open(options.folder, clock, access);
  const ExportOptions how{
      .format = options.format == "json" ? ExportFormat::Json : ExportFormat::Csv,
      .runMode = runModeNamed(options.runMode),
      .isBlinded = !options.unblind};
  exportStudy(study, options.out, how, options.reason);
  fmt::print(
      "{} holds the data{}.\n", options.out, options.unblind ? ", NOT blinded" : ", blinded");
  return 0;
}

}  // namespace

void addExportCommand(CLI::App& program, Action& action) {
  auto options = std::make_shared<ExportArguments>();
  auto* command = program.add_subcommand(
      "export", "Data for others: tidy tables, one row per answer, blinded unless asked otherwise");
  command->add_option("DIR", options->folder, "The study's folder")->required();
  command->add_option("--out", options->out, "Folder to make; nothing is overwritten")->required();
  command->add_option("--format", options->format, "Tables as text, or one JSON document")
      ->check(CLI::IsMember({"csv", "json"}))
      ->capture_default_str();
  addRunModeOption(*command, options->runMode);
  auto* unblind = command->add_flag(
      "--unblind",
      options->unblind,
      "Say which rendering an alternative was; goes into the audit trail");
  auto* reason = command->add_option("--reason", options->reason, "Why it is unblinded");
  unblind->needs(reason);
  command->callback([&action, options] { action = [options] { return exportAs(*options); }; });
}

}  // namespace study::app

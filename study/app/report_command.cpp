#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "study/app/commands.h"
#include "study/app/run_mode_option.h"
#include "study/app/write_report.h"

namespace study::app {
namespace {

struct ReportArguments {
  std::vector<std::string> folders;
  std::string out;
  std::string runMode;
};

int report(const ReportArguments& options) {
  SystemClock clock;
  std::vector<report::ReportSection> sections;
  for (const auto& folder : options.folders) {
    auto study = Study::open(folder, clock, storage::Database::Access::ReadOnly);
    sections.push_back(report::gather(study, chosenRunMode(study, options.runMode)));
  }
  writeReport(sections, options.out);
  fmt::print("{} holds the report.\n", options.out);
  return 0;
}

}  // namespace

void addReportCommand(CLI::App& program, Action& action) {
  auto options = std::make_shared<ReportArguments>();
  auto* command = program.add_subcommand(
      "report",
      "A results section: tables, figures, what was felt; one page that needs nothing else");
  command->add_option("DIR", options->folders, "Folders of one or more studies")->required();
  command->add_option("--out", options->out, "The page to write (.html); nothing is overwritten")
      ->required();
  addRunModeOption(*command, options->runMode);
  command->callback([&action, options] { action = [options] { return app::report(*options); }; });
}

}  // namespace study::app

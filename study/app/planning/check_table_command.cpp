#include <cstdio>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "analysis/published/published_table.h"
#include "questionnaires/json/document.h"
#include "study/app/command_options.h"
#include "study/app/planning/published_report.h"

namespace study::app {
namespace {

struct CheckTableArguments {
  std::string groups;
  std::string comparisons;
  std::vector<std::uint64_t> sizes;
  std::vector<int> scale;
  int parts = 1;
  bool json = false;
};

PublishedTableOptions tableOptionsOf(const CheckTableArguments& options) {
  PublishedTableOptions tableOptions;
  if (!options.sizes.empty()) {
    tableOptions.fewest = options.sizes[0];
    tableOptions.most = options.sizes[1];
    if (options.sizes[0] > options.sizes[1]) {
      throw base::UserError("--sizes go from the fewest to the most, for instance --sizes 24 36");
    }
  }
  if (!options.scale.empty()) {
    tableOptions.scale = {
        .lowest = options.scale[0], .highest = options.scale[1], .parts = options.parts};
    const int points = (options.scale[1] - options.scale[0]) * options.parts + 1;
    if (points < 2 || points > analysis::AnswerLattice::kMostPoints) {
      throw base::UserError(
          "--scale goes from the lowest point to the highest, for instance --scale 1 5, and has "
          "at most 101 points");
    }
  }
  return tableOptions;
}

int checkTable(const CheckTableArguments& options) {
  const auto groups = questionnaires::readTextFile(options.groups);
  const auto comparisons = questionnaires::readTextFile(options.comparisons);
  try {
    const auto table = analysis::readPublishedTable(groups, comparisons);
    const auto report = checkPublishedTable(table, tableOptionsOf(options));
    std::fputs(
        (options.json ? publishedReportAsJson(report) : publishedReportAsText(report)).c_str(),
        stdout);
  } catch (const base::UserError& error) {
    throw base::UserError(
        options.groups + " and " + options.comparisons + " cannot be checked:\n" + error.what());
  }
  return 0;
}

}  // namespace

void addCheckTableCommand(CLI::App& stats, Action& action) {
  auto [command, options] = addCommand(
      stats,
      action,
      "check-table",
      "Check whether the p values of a published table agree with its means, variances and sizes",
      checkTable);
  command
      ->add_option(
          "GROUPS", options.groups, "A CSV file: group, n (may be missing), mean, variance or sd")
      ->required();
  command->add_option("COMPARISONS", options.comparisons, "A CSV file: group1, group2, p")
      ->required();
  command->add_option("--sizes", options.sizes, "Sizes to try for every group (default: column n)")
      ->type_name("SMALLEST LARGEST")
      ->expected(2)
      ->check(CLI::Range(2, 1000));
  auto* scale =
      command->add_option("--scale", options.scale, "Ends of the answer scale, such as 1 5")
          ->type_name("LOWEST HIGHEST")
          ->expected(2)
          ->check(CLI::Range(-1000, 1000));
  command
      ->add_option(
          "--parts",
          options.parts,
          "Number of steps per point of the scale: 2 if an answer is the mean of two statements")
      ->check(CLI::Range(1, 20))
      ->needs(scale)
      ->capture_default_str();
  command->add_flag("--json", options.json, "Print JSON with full precision");
}

}  // namespace study::app

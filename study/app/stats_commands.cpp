#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <thread>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "analysis/data/error.h"
#include "analysis/data/grouped_values.h"
#include "analysis/tests/welch.h"
#include "questionnaires/json/document.h"
#include "study/app/commands.h"
#include "study/app/finite_range.h"
#include "study/app/json_file.h"
#include "study/app/run_mode_option.h"
#include "study/results/pooled_answers.h"
#include "study/results/results_text.h"
#include "study/session/unblinding.h"
#include "study/words/counted.h"

namespace study::app {
namespace {

struct TestOptions {
  std::string file;
  std::string group;
  std::string value;
  double level = 0.95;
  bool json = false;
};

std::string orMissing(const std::optional<double>& value) {
  return value ? fmt::format("{:.10g}", *value) : "–";
}

analysis::GroupedValues groupsOf(const TestOptions& options) {
  const auto text = questionnaires::readTextFile(options.file);
  try {
    return analysis::readGroupedValues(text, options.group, options.value);
  } catch (const analysis::Error& error) {
    throw analysis::Error(options.file + " cannot be tested:\n" + error.what());
  }
}

int welch(const TestOptions& options) {
  const auto groups = groupsOf(options);
  const auto result = analysis::welchTTest(groups.group1.values, groups.group2.values);
  if (options.json) {
    std::fputs(welchAsJson(groups, result, options.level).c_str(), stdout);
    return 0;
  }
  const auto interval = analysis::confidenceInterval(result, options.level);
  fmt::print("Welch's t-test, {} − {}\n\n", groups.group1.name, groups.group2.name);
  fmt::print("{:<12} {:>8} {:>16} {:>16}\n", "group", "n", "mean", "variance");
  fmt::print(
      "{:<12} {:>8} {:>16} {:>16}\n",
      groups.group1.name,
      result.n1,
      orMissing(result.mean1),
      orMissing(result.variance1));
  fmt::print(
      "{:<12} {:>8} {:>16} {:>16}\n\n",
      groups.group2.name,
      result.n2,
      orMissing(result.mean2),
      orMissing(result.variance2));
  if (groups.missing > 0)
    fmt::print(
        "{} left out, without a group or a value.\n",
        words::counted(groups.missing, "row was", "rows were"));
  fmt::print(
      "difference {}, t = {}, df = {}, p = {}\n",
      orMissing(result.difference),
      orMissing(result.t),
      orMissing(result.degreesOfFreedom),
      orMissing(result.p));
  if (interval) {
    fmt::print(
        "{:g} % confidence interval of the difference: {:.10g} to {:.10g}\n",
        100.0 * options.level,
        interval->low,
        interval->high);
  }
  if (!result.reason.empty()) fmt::print("{}\n", base::describe(result.reason));
  return 0;
}

struct RunOptions {
  std::string folder;
  std::string profile = "as-published";
  std::string runMode;
  std::string reason;
  bool json = false;
  bool isWatched = false;
};

/// The pooled tables, and again whenever something has happened; until somebody interrupts it.
[[noreturn]] void watch(Study& study, RunMode mode) {
  constexpr std::chrono::milliseconds kBetweenLooks{500};
  PooledAnswers pooled(study, mode);
  while (true) {
    fmt::print(
        "{}\nINTERIM, {}: whoever stops because of what is seen here, or goes on until p is small, "
        "has no p.\n\n",
        resultsAsText(study, pooledResults(study, pooled), Profile::AsPublished),
        asUtc(study.clock().now().wall));
    std::fflush(stdout);
    while (!pooled.refresh()) std::this_thread::sleep_for(kBetweenLooks);
  }
}

int run(const RunOptions& options) {
  SystemClock clock;
  auto study = Study::open(options.folder, clock, accessToNote(options.reason));
  const auto mode = chosenRunMode(study, options.runMode);
  noteUnblinding(study, mode, "results", options.reason);
  if (options.isWatched) watch(study, mode);
  const auto results = computeResults(study, mode);
  const auto profile =
      options.profile == "recommended" ? Profile::Recommended : Profile::AsPublished;
  std::fputs(
      (options.json ? resultsAsJson(study, results) : resultsAsText(study, results, profile))
          .c_str(),
      stdout);
  return 0;
}

}  // namespace

void addStatsCommands(CLI::App& program, Action& action) {
  auto* noun = program.add_subcommand("stats", "Tables of a study; tests of any table");
  noun->require_subcommand(1);

  auto running = std::make_shared<RunOptions>();
  auto* run = noun->add_subcommand(
      "run", "The tables of a study: means and variances, declared comparisons, preferences");
  run->add_option("DIR", running->folder, "The study's folder")->required();
  run->add_option(
         "--profile",
         running->profile,
         "as-published: pooled answers, as the punch paper did; recommended: within people")
      ->check(CLI::IsMember({"as-published", "recommended"}))
      ->capture_default_str();
  addRunModeOption(*run, running->runMode);
  addReasonOption(*run, running->reason);
  auto* json = run->add_flag("--json", running->json, "For programs, full precision");
  run->add_flag(
         "--watch",
         running->isWatched,
         "Pooled answers only, again whenever somebody has answered; ends with Ctrl-C")
      ->excludes(json);
  run->callback([&action, running] { action = [running] { return app::run(*running); }; });

  auto testing = std::make_shared<TestOptions>();
  auto* test = noun->add_subcommand("test", "A test of any table of your own");
  test->require_subcommand(1);
  auto* welch = test->add_subcommand("welch", "Do two groups differ in their mean? Welch's t-test");
  welch->add_option("FILE", testing->file, "A CSV file with a header line")->required();
  welch->add_option("--group", testing->group, "Column that names the group; two groups")
      ->required();
  welch->add_option("--value", testing->value, "Column of numbers")->required();
  welch->add_option("--level", testing->level, "Of the confidence interval")
      ->check(finiteRange(1e-9, 1.0 - 1e-9))
      ->capture_default_str();
  welch->add_flag("--json", testing->json, "For programs, full precision");
  welch->callback([&action, testing] { action = [testing] { return app::welch(*testing); }; });

  addCheckTableCommand(*noun, action);
}

}  // namespace study::app

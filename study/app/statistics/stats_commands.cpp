#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <string_view>
#include <thread>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "study/app/command_options.h"
#include "study/app/json_file.h"
#include "study/app/keys/ask_passphrase.h"
#include "study/results/pooled_results.h"
#include "study/results/results_text.h"
#include "study/session/unblinding.h"

namespace study::app {
namespace {

struct RunArguments {
  std::string folder;
  std::string profile = "declared";
  std::string wording = "apa";
  std::string runMode;
  std::string reason;
  bool json = false;
  bool isWatched = false;
};

Profile profileNamed(std::string_view name) {
  if (name == "as-published") return Profile::AsPublished;
  return name == "recommended" ? Profile::Recommended : Profile::Declared;
}

/// Prints the tables now and after each new event, until the program is interrupted.
[[noreturn]] void watch(Study& study, RunMode mode, Profile profile, Wording wording) {
  constexpr std::chrono::milliseconds kWatchPeriod{500};
  const auto& families = study.protocol().protocol.analysis.families;
  const bool isAllPooled =
      std::ranges::all_of(families, [&](const auto& family) { return isPooled(profile, family); });
  while (true) {
    // read before the results are computed, so that later events are not missed
    const auto lastEvent = study.events().last();
    fmt::print(
        "{}\nINTERIM, {}: if you stop the study because of these tables, or go on until p is "
        "small, its p values are invalid.\n\n",
        resultsAsText(
            study,
            isAllPooled ? pooledResults(study, mode) : computeResults(study, mode),
            profile,
            wording),
        asUtc(study.clock().now().wall));
    std::fflush(stdout);
    while (study.events().last() == lastEvent) std::this_thread::sleep_for(kWatchPeriod);
  }
}

int run(const RunArguments& options) {
  auto study = Study::open(options.folder, accessForUnblinding(options.reason));
  askForKeyIfLocked(study);
  const auto mode = chosenRunMode(study, options.runMode);
  recordUnblinding(study, mode, EventKind::UnblindedResults, options.reason);
  const auto profile = profileNamed(options.profile);
  const auto wording = wordingNamed(options.wording);
  if (options.isWatched) watch(study, mode, profile, wording);
  const auto results = computeResults(study, mode);
  const auto text = options.json ? resultsAsJson(study, results)
                                 : resultsAsText(study, results, profile, wording);
  std::fputs(text.c_str(), stdout);
  return 0;
}

}  // namespace

void addStatsCommands(CLI::App& program, Action& action) {
  auto& parentCommand =
      addCommandGroup(program, "stats", "Statistics of a study; statistical tests on any table");

  auto [run, running] = addCommand(
      parentCommand,
      action,
      "run",
      "Print the tables of a study: means and variances, declared comparisons, preferences",
      app::run);
  addStudyFolder(*run, running.folder);
  run->add_option(
         "--profile",
         running.profile,
         "Analysis: declared (in the protocol), as-published (all answers pooled), recommended "
         "(within participants)")
      ->check(CLI::IsMember({"declared", "as-published", "recommended"}))
      ->capture_default_str();
  addWordingOption(*run, running.wording);
  addRunModeOption(*run, running.runMode);
  addReasonOption(*run, running.reason);
  auto* json = run->add_flag("--json", running.json, "Print JSON with full precision");
  run->add_flag(
         "--watch",
         running.isWatched,
         "Print the tables again after every answer; ends with Ctrl-C")
      ->excludes(json);

  addTestCommand(parentCommand, action);
  addCheckTableCommand(parentCommand, action);
}

}  // namespace study::app

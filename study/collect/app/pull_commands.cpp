// What whoever evaluates the study does: get all of it, or see whether all is as it was sent.
#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "study/app/commands.h"
#include "study/collect/app/collect_program.h"
#include "study/collect/app/options.h"
#include "study/collect/exchange/pull.h"
#include "study/model/new_file.h"
#include "study/model/user_error.h"
#include "study/words/counted.h"

namespace study::collect {
namespace {

struct PullArguments {
  std::string server;
  std::string study;
  std::string folder;
  std::string reason;
};

int pullStudy(const PullArguments& given) {
  SystemClock clock;
  Connection server(given.server);
  const auto pulled =
      pull(server, {.study = given.study, .folder = given.folder, .reason = given.reason}, clock);
  fmt::print(
      "{} has {} of {}, {} events, {:.1f} MB of samples{}.\n",
      given.folder,
      words::counted(pulled.sessions, "session"),
      words::counted(pulled.stations, "station"),
      pulled.events,
      static_cast<double>(pulled.traceBytes) / 1e6,
      pulled.erased == 0
          ? ""
          : "; " + words::counted(pulled.erased, "session was", "sessions were") + " erased");
  for (const auto& session : pulled.incomplete) {
    fmt::print("not complete, and left out: {}. Its station has to push again.\n", session);
  }
  fmt::print(
      "Next: palpate study verify {0}, palpate report {0} --out report.html\n", given.folder);
  return 0;
}

/// Pulls, and runs 'palpate stats run' on what came; nothing of it stays on this computer.
/// @param words  the options of 'stats run'
int statsOfAll(const PullArguments& given, std::vector<std::string> words) {
  const TemporaryFolder folder;
  const Account account(folder / "account");
  const auto study = folder / "study";
  SystemClock clock;
  {
    Connection server(given.server);
    const auto pulled =
        pull(server, {.study = given.study, .folder = study, .reason = given.reason}, clock);
    for (const auto& session : pulled.incomplete) {
      fmt::print(stderr, "not complete, and left out: {}\n", session);
    }
  }
  words.insert(words.begin(), {"stats", "run", study.string(), "--reason", given.reason});
  std::reverse(words.begin(), words.end());  // as CLI11 takes them
  CLI::App program("palpate collect stats");
  app::Action run;
  app::addStatsCommands(program, run);
  try {
    program.parse(words);
  } catch (const CLI::ParseError& error) {
    throw UserError(
        std::string(error.what()) + " ('palpate stats run --help' has all further options.)");
  }
  return run();
}

int checkStudy(const PullArguments& given) {
  Connection server(given.server);
  bool isSound = true;
  for (const auto& station : check(server, given.study, given.reason)) {
    fmt::print(
        "{}  {}: {} events, {}\n",
        station.problems.empty() ? "PASS" : "FAIL",
        station.station,
        station.events,
        words::counted(station.sessions, "session"));
    for (const auto& problem : station.problems) fmt::print("      {}\n", problem);
    isSound = isSound && station.problems.empty();
  }
  return isSound ? 0 : 1;
}

}  // namespace

void addPullCommands(CLI::App& program, Action& action) {
  const auto given = std::make_shared<PullArguments>();
  auto* out = program.add_subcommand("pull", "Make one ordinary study of all that has arrived");
  addServerOption(*out, given->server);
  out->add_option(
      "--study", given->study, "Name of the study on the server (default: the only one)");
  out->add_option("--out", given->folder, "New folder of the study")->required();
  out->add_option("--reason", given->reason, "Why; the map of conditions is pulled, too")
      ->required();
  out->callback([&action, given] { action = [given] { return pullStudy(*given); }; });

  auto* stats = program.add_subcommand(
      "stats", "Statistics of all that has arrived; further options are those of 'stats run'");
  addServerOption(*stats, given->server);
  stats->add_option(
      "--study", given->study, "Name of the study on the server (default: the only one)");
  stats->add_option("--reason", given->reason, "Why; it is kept as for 'pull'")->required();
  stats->allow_extras();
  stats->callback([&action, given, stats] {
    action = [given, words = stats->remaining()] { return statsOfAll(*given, words); };
  });

  auto* look = program.add_subcommand(
      "check", "Compute all audit trails on the server again, with signatures and hashes");
  addServerOption(*look, given->server);
  look->add_option(
      "--study", given->study, "Name of the study on the server (default: the only one)");
  look->add_option("--reason", given->reason, "Why; it is kept as for 'pull'")->required();
  look->callback([&action, given] { action = [given] { return checkStudy(*given); }; });
}

}  // namespace study::collect

// Commands for the analyst: get the whole study, or check that the server has what stations sent.
#include <algorithm>
#include <filesystem>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "study/app/command_options.h"
#include "study/collect/app/collect_program.h"
#include "study/collect/app/options.h"
#include "study/collect/exchange/pull.h"
#include "study/model/new_file.h"
#include "study/words/counted.h"

namespace study::collect {
namespace {

struct PullArguments {
  std::string server;
  std::string study;
  std::string folder;
  std::string reason;
  const CLI::App* stats = nullptr;  ///< has the options of 'palpate stats run'
};

/// Prints what was left out, and why. @return  whether all data are as the stations signed them
bool printProblems(const PullResult& pulled) {
  for (const auto& station : pulled.stations) {
    for (const auto& session : station.incomplete) {
      fmt::print(
          stderr,
          "{}: {} is not complete, and left out. The station has to push again.\n",
          station.label,
          session);
    }
    for (const auto& problem : station.problems) {
      fmt::print(stderr, "{}: {}\n", station.label, problem);
    }
  }
  for (const auto& problem : pulled.problems) fmt::print(stderr, "{}\n", problem);
  if (!pulled.isSound()) {
    fmt::print(
        stderr,
        "The server has data that no station signed. docs/collecting.md, \"What happens when\", "
        "says what to do.\n");
  }
  return pulled.isSound();
}

int pullStudy(const PullArguments& arguments) {
  SystemClock clock;
  auto server = connectionTo(arguments.server);
  const auto pulled = pull(
      server,
      {.study = arguments.study, .folder = arguments.folder, .reason = arguments.reason},
      clock);
  std::int64_t events = 0;
  std::uint64_t traceBytes = 0;
  std::size_t erased = 0;
  for (const auto& station : pulled.stations) {
    events += station.events;
    traceBytes += station.traceBytes;
    erased += station.erased;
  }
  fmt::print(
      "{} has {} of {}, {}, {:.1f} MB of samples{}.\n",
      arguments.folder,
      words::counted(pulled.sessions(), "session"),
      words::counted(pulled.stations.size(), "station"),
      words::counted(static_cast<std::uint64_t>(events), "event"),
      static_cast<double>(traceBytes) / 1e6,
      erased == 0 ? "" : "; " + words::counted(erased, "session was", "sessions were") + " erased");
  const bool isSound = printProblems(pulled);
  fmt::print(
      "Next: palpate study verify {0}, palpate report {0} --out report.html\n", arguments.folder);
  return isSound ? 0 : 1;
}

/// A study that is pulled for one command, into a temporary folder.
class TemporaryPull {
 public:
  explicit TemporaryPull(const PullArguments& arguments) : account_(folder_ / "account") {
    SystemClock clock;
    auto server = connectionTo(arguments.server);
    pulled_ = pull(
        server, {.study = arguments.study, .folder = study(), .reason = arguments.reason}, clock);
  }

  std::filesystem::path study() const { return folder_ / "study"; }
  const PullResult& pulled() const noexcept { return pulled_; }

 private:
  TemporaryFolder folder_;
  StationFolderOverride account_;
  PullResult pulled_;
};

int statsOfAll(const PullArguments& arguments) {
  const TemporaryPull all(arguments);
  auto words = arguments.stats->remaining();
  const bool isSound = printProblems(all.pulled());
  words.insert(words.begin(), {"stats", "run", all.study().string(), "--reason", arguments.reason});
  const int status = runPalpate(std::move(words));
  return isSound ? status : std::max(status, 1);
}

int checkStudy(const PullArguments& arguments) {
  const TemporaryPull all(arguments);
  for (const auto& station : all.pulled().stations) {
    fmt::print(
        "{}  {}: {}, {}\n",
        station.problems.empty() ? "PASS" : "FAIL",
        station.label,
        words::counted(static_cast<std::uint64_t>(station.events), "event"),
        words::counted(station.sessions, "session"));
  }
  return printProblems(all.pulled()) ? 0 : 1;
}

void addSource(CLI::App& command, PullArguments& arguments) {
  addServerOption(command, arguments.server);
  command.add_option(
      "--study", arguments.study, "Name of the study on the server (default: the only one)");
}

void addReasonForReading(CLI::App& command, PullArguments& arguments) {
  command
      .add_option(
          "--reason",
          arguments.reason,
          "Reason for reading data that reveal the conditions (unblinding); the server records it")
      ->required();
}

}  // namespace

void addPullCommands(CLI::App& program, Action& action) {
  auto [out, pulling] = app::addCommand(
      program,
      action,
      "pull",
      "Create one study folder on this computer from all data on the server",
      pullStudy);
  addSource(*out, pulling);
  out->add_option("--out", pulling.folder, "New folder of the study")
      ->type_name("FOLDER")
      ->required();
  out->add_option(
         "--reason",
         pulling.reason,
         "Reason for a copy that reveals the conditions (unblinds); kept in its audit trail and on "
         "the server")
      ->required();

  auto [stats, asking] = app::addCommand(
      program,
      action,
      "stats",
      "Print statistics of all data on the server; further options are those of 'palpate stats "
      "run'",
      statsOfAll);
  asking.stats = stats;
  addSource(*stats, asking);
  addReasonForReading(*stats, asking);
  stats->allow_extras();

  auto [look, checking] = app::addCommand(
      program,
      action,
      "check",
      "Pull into a temporary folder and compare all data with what the stations signed",
      checkStudy);
  addSource(*look, checking);
  addReasonForReading(*look, checking);
}

}  // namespace study::collect

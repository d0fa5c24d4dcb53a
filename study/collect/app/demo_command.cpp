// A demonstration on this computer alone: a private server, four stations, simulated participants.
#include <array>
#include <filesystem>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "study/app/command_options.h"
#include "study/cohort/simulated_participant.h"
#include "study/collect/app/collect_program.h"
#include "study/collect/app/options.h"
#include "study/collect/exchange/administration.h"
#include "study/collect/exchange/enrolment.h"
#include "study/collect/exchange/pull.h"
#include "study/collect/exchange/push.h"
#include "study/collect/server/private_server.h"
#include "study/collect/server/schema.h"
#include "study/model/new_file.h"
#include "study/model/user_error.h"

namespace study::collect {
namespace {

namespace fs = std::filesystem;

struct DemoArguments {
  std::string out = "palpate-sites";
  int participants = 4;
};

constexpr const char* kProtocol = "punch-counterbalanced";
constexpr const char* kStudy = "demo";
constexpr std::uint64_t kSeed = 20221212;

struct DemoStation {
  const char* site;
  const char* label;
};
constexpr std::array kStations{
    DemoStation{"oslo", "oslo"},
    DemoStation{"oslo", "oslo-2"},
    DemoStation{"bergen", "bergen"},
    DemoStation{"tromso", "tromso"}};

/// The work of one site: enrolment, simulated participants, push.
void runStation(
    const PrivateServer& postgres, const DemoStation& at, const DemoArguments& arguments) {
  const fs::path out(arguments.out);
  const fs::path folder = out / at.label;
  const StationFolderOverride account(out / "accounts" / at.label);
  const auto station = storage::StationStore::openOrCreate(storage::StationStore::defaultFolder());
  Connection owner(postgres.server());
  const auto enrolled = enrolStation(
      owner, {.study = kStudy, .site = at.site, .label = at.label, .key = station.publicKey()});
  const auto file = out / (std::string(at.label) + ".enrol");
  writeNewFile(file.string(), enrolled.file);
  SimulatedClock clock;
  join(file, folder, clock);
  {
    auto study = Study::open(folder, clock);
    simulateCohorts(
        study,
        clock,
        arguments.participants,
        kSeed + static_cast<std::uint64_t>(&at - kStations.data()),
        [](const auto&) {});
    study.transact([&] { study.signTrail("simulated"); });
  }
  Outbox outbox(folder, clock);
  Connection server(postgres.server(), enrolled.role);
  const auto pushed = push(outbox, server);
  fmt::print(
      "{}: {} sessions, {} events and {:.1f} MB of samples sent.\n",
      at.label,
      pushed.sessions.arrived,
      pushed.lastEvent,
      static_cast<double>(pushed.traceBytes) / 1e6);
}

/// In the folder that was made for it.
int demonstrate(const DemoArguments& arguments) {
  const fs::path out(arguments.out);
  fmt::print("A private PostgreSQL server is started, which only this account can reach …\n");
  const PrivateServer postgres;
  {
    Connection owner(postgres.server());
    installSchema(owner);
    addStudyOrVersion(owner, kStudy, app::loadValidProtocol(kProtocol), kSeed);
  }
  for (const auto& station : kStations) runStation(postgres, station, arguments);
  const StationFolderOverride account(out / "accounts" / "analyst");
  SystemClock clock;
  Connection server(postgres.server());
  const auto all = out / "all";
  const auto pulled = pull(server, {.folder = all, .reason = "the demonstration"}, clock);
  const bool isSound = pulled.isSound();
  fmt::print(
      "{} has {} sessions of {} stations, and is {}. The server stops with this command.\n",
      all.string(),
      pulled.sessions(),
      pulled.stations.size(),
      isSound ? "sound" : "NOT sound: palpate study verify says why");
  const auto report = out / "report.html";
  runPalpate({"report", all.string(), "--run-mode", "simulated", "--out", report.string()});
  fmt::print(
      "It compares the sites. Next: palpate stats run {} --run-mode simulated\n", all.string());
  return isSound ? 0 : 1;
}

int demo(const DemoArguments& arguments) {
  const fs::path out(arguments.out);
  std::error_code error;
  if (fs::exists(out, error) || !fs::create_directories(out / "accounts", error)) {
    throw UserError(arguments.out + " is there already, or cannot be made. Choose another --out.");
  }
  try {
    return demonstrate(arguments);
  } catch (...) {
    fs::remove_all(out, error);
    throw;
  }
}

}  // namespace

void addDemoCommand(CLI::App& program, Action& action) {
  auto [noun, arguments] = app::addCommand(
      program,
      action,
      "demo",
      "Try it on this computer: four stations, simulated participants, and a private server",
      collect::demo);
  noun->add_option("--out", arguments.out, "New folder (default: palpate-sites)")
      ->type_name("FOLDER");
  noun->add_option(
          "--participants",
          arguments.participants,
          "Number of simulated participants of each station (default: 4)")
      ->check(CLI::Range(1, 1000));
}

}  // namespace study::collect

// Commands for the operator of a station: enrol, push, and see what has arrived.
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "study/app/command_options.h"
#include "study/collect/app/collect_program.h"
#include "study/collect/app/options.h"
#include "study/collect/exchange/bundle.h"
#include "study/collect/exchange/enrolment.h"
#include "study/collect/exchange/outbox.h"
#include "study/collect/exchange/push.h"
#include "study/collect/server/registry.h"
#include "study/collect/server/schema.h"
#include "study/words/counted.h"

namespace study::collect {
namespace {

struct StationArguments {
  std::string server;
  std::string study;
  std::string folder;
  std::string enrolment;
  std::string out;
  std::string mark;
  std::int64_t afterEvent = -1;  ///< last event that is left out; -1: the last one of the last push
};

int printKey(const StationArguments& /*none*/) {
  const auto station = storage::StationStore::openOrCreate(storage::StationStore::defaultFolder());
  fmt::print("{}\n", station.publicKey());
  return 0;
}

int joinStudy(const StationArguments& arguments) {
  SystemClock clock;
  const auto enrolment = join(arguments.enrolment, arguments.folder, clock, arguments.mark);
  fmt::print(
      "{} is ready: \"{}\", station '{}' of the site '{}'. Codes of participants begin with "
      "{}_.\nSessions need no network. Afterwards: palpate collect push {}\n",
      arguments.folder,
      enrolment.title,
      enrolment.station.label,
      enrolment.station.site,
      enrolment.station.label,
      arguments.folder);
  if (arguments.mark.empty()) {
    fmt::print(
        "The study's mark is {}. Ask the study's administrator whether that is theirs, before "
        "anybody "
        "takes part: anybody can write a file for this computer.\n",
        enrolment.mark);
  }
  return 0;
}

std::string arrivedInWords(const Arrivals& sessions) {
  const auto all = static_cast<std::uint64_t>(sessions.all);
  const auto waiting = sessions.all - sessions.arrived;
  std::string words =
      fmt::format("{} here, {} arrived", words::counted(all, "session"), sessions.arrived);
  if (waiting > 0) words += fmt::format(", {} waiting", waiting);
  if (!sessions.waitingSince.empty()) words += " since " + sessions.waitingSince;
  return words;
}

/// Warns if what is recorded in this folder is not signed, so that no pull takes it.
void warnOfOlderCopy(Outbox& outbox, const std::string& folder) {
  const auto missing = outbox.missingHeads();
  if (missing == 0) return;
  fmt::print(
      stderr,
      "{} is an older copy: this station has signed {} of it that {} not there. New sessions in it "
      "are not signed, and 'pull' leaves them out. Put the newest copy back. If there is none: "
      "palpate study restored {} --reason \"…\", then push.\n",
      folder,
      words::counted(missing, "state"),
      missing == 1 ? "is" : "are",
      app::asShellWord(folder));
}

bool isOtherTrail(const ServerAnswer& refusal) {
  return refusal.refused == "fork" || refusal.refused == "older_copy";
}

int bundleStudy(const StationArguments& arguments) {
  SystemClock clock;
  Outbox outbox(arguments.folder, clock);
  warnOfOlderCopy(outbox, arguments.folder);
  const auto station = storage::StationStore::openOrCreate(storage::StationStore::defaultFolder());
  const auto after = arguments.afterEvent >= 0
                         ? arguments.afterEvent
                         : lastPush(outbox.study(), outbox.station().uuid).lastEvent;
  const auto bundle = writeBundle(
      outbox, station, serverSettingsOf(arguments.folder).bundleKey, after, arguments.out);
  fmt::print(
      "{} has {}, {:.1f} MB, sealed for the server's administrator. There: palpate "
      "collect "
      "ingest {}\n",
      arguments.out,
      bundle.first == bundle.last ? fmt::format("event {}", bundle.last)
                                  : fmt::format("events {} to {}", bundle.first, bundle.last),
      static_cast<double>(bundle.bytes) / 1e6,
      arguments.out);
  return 0;
}

Connection connectionFor(const StationArguments& arguments) {
  const auto home = serverSettingsOf(arguments.folder);
  return Connection(arguments.server.empty() ? home.server : arguments.server, home.role);
}

PushResult pushOutbox(const StationArguments& arguments, Outbox& outbox) {
  auto server = connectionFor(arguments);
  return push(outbox, server);
}

/// Notes the result, success or not, for the desk, which has no connection of its own.
int pushStudy(const StationArguments& arguments) {
  SystemClock clock;
  Outbox outbox(arguments.folder, clock);
  warnOfOlderCopy(outbox, arguments.folder);
  const auto note = [&](std::int64_t lastEventOnServer, std::string_view problem) {
    recordPush(
        outbox.study(),
        outbox.station().uuid,
        {.utc = asUtc(clock.now().wall),
         .lastEvent = lastEventOnServer,
         .problem = std::string(problem)});
  };
  const auto noteProblem = [&](std::string_view problem) {
    note(lastPush(outbox.study(), outbox.station().uuid).lastEvent, problem);
  };
  PushResult sent;
  try {
    sent = pushOutbox(arguments, outbox);
  } catch (const ServerError& error) {
    noteProblem(nameOf(error.kind()));
    throw;
  } catch (const PushRefused& error) {
    noteProblem(error.name());
    throw;
  }
  note(sent.lastEvent, {});
  fmt::print(
      "{}\n{}\n",
      sent.lastEvent == sent.before
          ? std::string("The server has everything already.")
          : fmt::format(
                "{} sent, {:.1f} MB of samples.",
                words::counted(
                    static_cast<std::uint64_t>(sent.lastEvent - sent.before), "new event"),
                static_cast<double>(sent.traceBytes) / 1e6),
      arrivedInWords(sent.sessions));
  for (const auto& receipt : sent.erased) {
    recordErasureReceipt(outbox.study(), outbox.station().uuid, receipt);
    fmt::print("{}\n", wordsFor(receipt));
  }
  return 0;
}

/// Prints what is known without a network, and what the server says if it can be reached.
int statusOfStation(const StationArguments& arguments) {
  SystemClock clock;
  Outbox outbox(arguments.folder, clock);
  warnOfOlderCopy(outbox, arguments.folder);
  const auto noted = lastPush(outbox.study(), outbox.station().uuid);
  auto lastEventOnServer = noted.lastEvent;
  std::string reason;
  ServerAnswer refusal{.refused = noted.problem};
  try {
    auto server = connectionFor(arguments);
    requireSchema(server);
    const auto answer = ingest(server, outbox.lastEventQuery());
    refusal = answer.refused.empty() ? disagreementWith(answer, outbox) : answer;
    if (answer.refused.empty()) lastEventOnServer = answer.lastEvent;
  } catch (const ServerError& error) {
    reason = error.what();
  }
  const bool isRefused = isRefusal(refusal.refused);
  const auto sessions = outbox.arrivalsBy(lastEventOnServer);
  // Where the server has another trail, its number of events says nothing of the sessions here.
  fmt::print(
      "{}\n",
      isOtherTrail(refusal) ? words::counted(static_cast<std::uint64_t>(sessions.all), "session") +
                                  " here; which of them arrived is not known"
                            : arrivedInWords(sessions));
  if (isRefused) reason += (reason.empty() ? "" : "\n") + wordsFor(refusal);
  for (const auto& receipt : receiptsOf(outbox.study(), outbox.station().uuid)) {
    fmt::print("{}\n", wordsFor(receipt));
  }
  if (reason.empty()) return 0;
  fmt::print(
      "as of {}: {}\n", noted.utc.empty() ? "never, nothing was sent yet" : noted.utc, reason);
  return 1;
}

/// Prints the newest incidents, if this role may see them.
void printIncidents(Connection& server) {
  constexpr int kMost = 20;
  std::vector<Incident> incidents;
  try {
    incidents = incidentsOf(server, kMost);
  } catch (const ServerError& error) {
    if (error.kind() != ServerError::Kind::Denied) throw;
  }
  if (incidents.empty()) return;
  fmt::print("\nRefused, the newest first ({} at most; all are in palpate.incident):\n", kMost);
  for (const auto& incident : incidents) {
    fmt::print(
        "{}  {:<20} {:<20} {}: {}\n",
        incident.at,
        incident.role,
        incident.station.empty() ? "-" : incident.station,
        incident.what,
        incident.detail);
  }
}

int statusOfServer(const StationArguments& arguments) {
  auto server = connectionTo(
      arguments.server,
      " For the sessions of a station name the folder of its study: palpate collect status "
      "FOLDER.");
  requireSchema(server);
  const auto stations = stationsOf(server, arguments.study);
  fmt::print(
      "{:<20} {:<20} {:>8} {:>10} {:>9}  {}\n",
      "site",
      "station",
      "sessions",
      "events",
      "incidents",
      "last contact");
  for (const auto& station : stations) {
    fmt::print(
        "{:<20} {:<20} {:>8} {:>10} {:>9}  {}{}\n",
        station.site,
        station.station,
        station.sessions,
        station.events,
        station.incidents,
        station.lastContact.empty() ? "never" : station.lastContact,
        station.isSetAside  ? ", set aside"
        : station.isRevoked ? ", revoked"
                            : "");
  }
  printIncidents(server);
  return 0;
}

int status(const StationArguments& arguments) {
  return arguments.folder.empty() ? statusOfServer(arguments) : statusOfStation(arguments);
}

}  // namespace

void addStationCommands(CLI::App& program, Action& action) {
  app::addCommand(
      program, action, "key", "Print the public key of this computer, for its enrolment", printKey);

  auto [join, joining] = app::addCommand(
      program,
      action,
      "join",
      "Create the study's folder on this computer from an enrolment file",
      joinStudy);
  join->add_option("ENROLMENT", joining.enrolment, "File from 'palpate collect init --station'")
      ->required();
  join->add_option("FOLDER", joining.folder, "New folder of the study")->required();
  join->add_option(
      "--mark",
      joining.mark,
      "Fingerprint (mark) of the study, as its administrator tells it to you; joining fails if it "
      "differs");

  auto [push, pushing] = app::addCommand(
      program,
      action,
      "push",
      "Send the sessions and events that the server does not have yet",
      pushStudy);
  push->add_option("FOLDER", pushing.folder, "Folder of the study")->required();
  addServerOption(*push, pushing.server)
      ->description("PostgreSQL server, as for init (default: the one in the enrolment)");

  auto [bundle, bundling] = app::addCommand(
      program,
      action,
      "bundle",
      "Without a network: write what the server lacks to a file for 'palpate collect ingest'",
      bundleStudy);
  bundle->add_option("FOLDER", bundling.folder, "Folder of the study")->required();
  bundle->add_option("--out", bundling.out, "New file for the data")->type_name("FILE")->required();
  bundle->add_option(
      "--after",
      bundling.afterEvent,
      "Number of the last event that the server has (default: as of the last push, or 0)");

  auto [status, asking] = app::addCommand(
      program,
      action,
      "status",
      "Show how many sessions have arrived at the server: of one station, or of all",
      collect::status);
  status->add_option("FOLDER", asking.folder, "Folder of the study (default: all on the server)");
  status->add_option(
      "--study", asking.study, "Without FOLDER: name of the study on the server (default: all)");
  addServerOption(*status, asking.server)
      ->description(
          "PostgreSQL server, as for init (default: with FOLDER that of the enrolment, else the "
          "variables PGHOST, PGDATABASE, …)");
}

}  // namespace study::collect

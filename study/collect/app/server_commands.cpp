// Commands for the server's administrator: set up a study, take in bundles, revoke stations.
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "study/app/command_options.h"
#include "study/collect/app/collect_program.h"
#include "study/collect/app/options.h"
#include "study/collect/exchange/administration.h"
#include "study/collect/server/registry.h"
#include "study/collect/server/schema.h"
#include "study/model/new_file.h"
#include "study/model/user_error.h"
#include "study/words/counted.h"

namespace study::collect {
namespace {

struct ServerArguments {
  std::string server;
  std::string study;
  std::string protocol;
  std::string station;
  std::string participant;
  std::string site;
  std::string name;
  std::string key;
  std::string address;
  std::string reason;
  std::string file;
  std::optional<std::uint64_t> seed;
  int days = 30;
};

int addStudyOrProtocol(Connection& server, const ServerArguments& arguments) {
  const auto protocol = app::loadValidProtocol(arguments.protocol);
  switch (addStudyOrVersion(server, arguments.study, protocol, arguments.seed)) {
    case AddedToServer::Study:
      fmt::print(
          "'{}' is on the server: \"{}\".\nNext: on each station 'palpate collect key', and here "
          "palpate collect init --study {} --station FILE --site SITE --key KEY\n",
          arguments.study,
          protocol.protocol.study.title,
          arguments.study);
      break;
    case AddedToServer::Version:
      fmt::print(
          "{} is a version of the protocol of '{}' now. Stations take it over with 'palpate study "
          "amend'; new stations begin with it.\n",
          arguments.protocol,
          arguments.study);
      break;
    case AddedToServer::Nothing:
      fmt::print(
          "'{}' has this version of {} already. Nothing is to be done at the stations.\n",
          arguments.study,
          arguments.protocol);
      break;
  }
  return 0;
}

int addOneStation(Connection& server, const ServerArguments& arguments) {
  if (std::filesystem::exists(arguments.station)) {
    throw UserError(
        arguments.station + " is there already. Choose another name for the enrolment.");
  }
  const auto station = enrolStation(
      server,
      {.study = arguments.study,
       .site = arguments.site,
       .label = arguments.name,
       .key = arguments.key,
       .address = arguments.address,
       .days = arguments.days});
  writeNewFile(arguments.station, station.file);
  fmt::print(
      "{} makes one computer the station '{}' of '{}'; it can be used once, until {}.\nThe server "
      "knows it as the role {}. How it proves that (certificate or password): "
      "docs/collecting.md.\nNext, on that computer: palpate collect join {} FOLDER\nThe mark of "
      "the study, to be "
      "compared there on the telephone: {}\n",
      arguments.station,
      station.label,
      station.study,
      station.expiresUtc.substr(0, 10),
      station.role,
      arguments.station,
      station.mark);
  return 0;
}

int init(const ServerArguments& arguments) {
  const bool isOfSchemaAlone =
      arguments.protocol.empty() && arguments.station.empty() && arguments.study.empty();
  if (!isOfSchemaAlone && arguments.protocol.empty() == arguments.station.empty()) {
    throw UserError(
        "Say what to make: a study (--protocol FILE --study NAME) or a station of it (--station "
        "FILE --site SITE --key KEY).");
  }
  auto server = connectionTo(arguments.server);
  const int before = installSchema(server);
  if (before == 0) fmt::print("The server is ready: schema palpate, version {}.\n", newestSchema());
  if (before > 0 && before < newestSchema()) {
    fmt::print("The schema palpate is brought from version {} to {}.\n", before, newestSchema());
  }
  if (const auto advice = closeDatabase(server)) fmt::print("{}\n", *advice);
  if (const auto problem = logPrivacyProblem(server)) fmt::print("{}\n", *problem);
  if (isOfSchemaAlone) {
    if (before == newestSchema()) fmt::print("The schema palpate has version {}.\n", before);
    return 0;
  }
  return arguments.station.empty() ? addStudyOrProtocol(server, arguments)
                                   : addOneStation(server, arguments);
}

/// The role of those who administer studies on the server.
constexpr std::string_view kOwner = "palpate_owner";

int revoke(const ServerArguments& arguments) {
  auto server = connectionTo(arguments.server);
  withRole(server, kOwner, [&] {
    requireSchema(server);
    revokeStation(
        server, findStudy(server, arguments.study).uuid, arguments.station, arguments.reason);
  });
  fmt::print("Nothing is taken from '{}' any more. What arrived stays.\n", arguments.station);
  return 0;
}

int setAside(const ServerArguments& arguments) {
  auto server = connectionTo(arguments.server);
  const bool wasRevoked = withRole(server, kOwner, [&] {
    requireSchema(server);
    return setAsideStation(
        server, findStudy(server, arguments.study).uuid, arguments.station, arguments.reason);
  });
  fmt::print(
      "What was here of '{}' is set aside, and pulled no more. On the station: palpate collect "
      "push "
      "FOLDER, or palpate collect bundle FOLDER --after 0 --out FILE, sends all of it again.\n",
      arguments.station);
  if (wasRevoked) {
    fmt::print(
        "'{0}' was revoked, and is admitted again. If it is not to send anything: palpate collect "
        "revoke --station {0} --reason \"…\".\n",
        arguments.station);
  }
  return 0;
}

int eraseFromServer(const ServerArguments& arguments) {
  auto server = connectionTo(arguments.server);
  const auto receipts = withRole(server, kOwner, [&] {
    requireSchema(server);
    return eraseParticipant(
        server,
        findStudy(server, arguments.study).uuid,
        arguments.station,
        arguments.participant,
        arguments.reason);
  });
  for (const auto& receipt : receipts) fmt::print("{}\n", wordsFor(receipt));
  fmt::print(
      "Folders that were pulled before, and backups, still have the participant: palpate study "
      "erase FOLDER --participant {} --reason \"…\", in each.\n",
      arguments.participant);
  return 0;
}

int ingestFile(const ServerArguments& arguments) {
  auto server = connectionTo(arguments.server);
  const auto ingested = withRole(server, kOwner, [&] {
    requireSchema(server);
    return ingestBundle(server, arguments.file);
  });
  const auto added = static_cast<std::uint64_t>(ingested.lastEvent - ingested.before);
  fmt::print(
      "{} The server has all events of '{}' up to {}.\n",
      added == 0 ? "Nothing in it is new." : words::counted(added, "new event") + ".",
      ingested.station,
      ingested.lastEvent);
  for (const auto& receipt : ingested.erased) fmt::print("{}\n", wordsFor(receipt));
  return 0;
}

void addStudyAndStation(CLI::App& command, ServerArguments& arguments) {
  addServerOption(command, arguments.server);
  command.add_option(
      "--study", arguments.study, "Name of the study on the server (default: the only one)");
  command.add_option("--station", arguments.station, "Name of the station")->required();
}

}  // namespace

void addServerCommands(CLI::App& program, Action& action) {
  auto [make, arguments] = app::addCommand(
      program,
      action,
      "init",
      "Prepare or update the server's database, create a study there, or enrol a station",
      init);
  addServerOption(*make, arguments.server);
  make->add_option(
      "--study",
      arguments.study,
      "Name of the study on the server (for a station, default: the only one)");
  make->add_option(
          "--protocol",
          arguments.protocol,
          "Protocol file (.json), or a name from 'palpate protocol list'; for an existing study, "
          "its new version")
      ->type_name("FILE");
  make->add_option(
      "--seed",
      arguments.seed,
      "Seed of the condition orders of all stations (default: the protocol's, otherwise random)");
  auto* station = make->add_option(
                          "--station",
                          arguments.station,
                          "Enrol a station: write its enrolment to this new file")
                      ->type_name("FILE");
  make->add_option("--site", arguments.site, "Name of the site where the station is: \"oslo\"")
      ->needs(station);
  make->add_option(
          "--name", arguments.name, "Name of the station (default: that of its site): \"oslo-2\"")
      ->needs(station);
  make->add_option(
          "--key",
          arguments.key,
          "Public key of the station, as 'palpate collect key' prints it there")
      ->needs(station);
  make->add_option(
          "--address",
          arguments.address,
          "How the station reaches the server, as for --server (default: the same)")
      ->needs(station)
      ->type_name("WHERE");
  make->add_option(
          "--days", arguments.days, "Number of days for which the enrolment is valid (default: 30)")
      ->needs(station)
      ->check(CLI::Range(1, 365));

  auto [in, taking] = app::addCommand(
      program,
      action,
      "ingest",
      "Import a file from 'palpate collect bundle' into the server",
      ingestFile);
  addServerOption(*in, taking.server);
  in->add_option("FILE", taking.file, "File from 'palpate collect bundle'")->required();

  auto [out, revoking] = app::addCommand(
      program,
      action,
      "revoke",
      "Revoke a station's access: the server takes no more data from it",
      revoke);
  addStudyAndStation(*out, revoking);
  out->add_option(
         "--reason", revoking.reason, "Reason for revoking; the station shows it at its next push")
      ->required();

  auto [aside, setting] = app::addCommand(
      program,
      action,
      "set-aside",
      "Rename a station's data on the server, so that it can send all again; a revoked one is "
      "admitted",
      setAside);
  addStudyAndStation(*aside, setting);
  aside->add_option("--reason", setting.reason, "Reason for doing so; it is kept on the server")
      ->required();

  auto [gone, erasing] = app::addCommand(
      program,
      action,
      "erase",
      "Erase a participant of a lost station from the server; the station must be revoked",
      eraseFromServer);
  addStudyAndStation(*gone, erasing);
  gone->add_option("--participant", erasing.participant, "Participant code")
      ->type_name("CODE")
      ->required();
  gone->add_option("--reason", erasing.reason, "Reason, without a name; it is kept on the server")
      ->required();
}

}  // namespace study::collect

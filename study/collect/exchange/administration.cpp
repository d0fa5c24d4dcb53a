#include "study/collect/exchange/administration.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <span>

#include <fmt/format.h>

#include "base/joined.h"
#include "study/collect/exchange/bundle.h"
#include "study/collect/exchange/enrolment.h"
#include "study/collect/exchange/protocol_files.h"
#include "study/collect/exchange/push.h"
#include "study/collect/exchange/server_reader.h"
#include "study/collect/exchange/station_trail.h"
#include "study/export/public_people.h"
#include "study/model/user_error.h"
#include "study/session/study.h"
#include "study/storage/hasher.h"
#include "study/storage/protocol_repository.h"

namespace study::collect {
namespace {

constexpr std::size_t kLongestName = 31;
constexpr std::size_t kUuidDigits = 32;

/// Names of stations begin codes of participants; names of sites and stations end names of roles.
void requireName(const std::string& name, const std::string& what) {
  const bool isSound =
      !name.empty() && name.size() <= kLongestName &&
      std::islower(static_cast<unsigned char>(name.front())) != 0 &&
      name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == std::string::npos;
  if (isSound) return;
  throw UserError(
      "'" + name + "' cannot be the name of " + what +
      ": use lower-case letters, digits and '-', beginning with a letter, " +
      std::to_string(kLongestName) + " at most.");
}

ProtocolOnServer protocolOnServerOf(const protocols::LoadedProtocol& protocol) {
  return {
      .sha256 = storage::sha256(protocol.text, protocol.files),
      .text = protocol.text,
      .files = filesAsText(protocol.files)};
}

std::vector<std::byte> bytesOf(const storage::BlindingSecret& secret) {
  const auto bytes = std::as_bytes(std::span(secret.bytes()));
  return {bytes.begin(), bytes.end()};
}

storage::BlindingSecret secretOf(const StudyOnServer& study) {
  const auto bytes = storage::fixedBytes<storage::BlindingSecret::Bytes>(study.secret);
  if (!bytes) throw UserError("The study's secret is damaged.");
  return storage::BlindingSecret(*bytes);
}

/// The background questions whose answers analysts see, in bands as in an export
/// (docs/decisions/0048).
std::vector<BackgroundItem> backgroundOf(const protocols::LoadedProtocol& loaded) {
  std::vector<BackgroundItem> items;
  for (const auto& question : backgroundQuestionsOf(loaded)) {
    items.push_back(
        {.phase = question.phase,
         .item = question.item->id,
         .width = question.hierarchy.bandWidth(),
         .isWhole = question.hierarchy.isWhole()});
  }
  return items;
}

/// 128 random bits.
std::string drawnUuid() {
  return storage::BlindingSecret::drawn().commitment().substr(0, kUuidDigits);
}

/// Runs @p action in one transaction of the server.
template <typename Action>
void inTransaction(Connection& server, const Action& action) {
  server.execute("BEGIN");
  try {
    action();
  } catch (...) {
    server.execute("ROLLBACK");
    throw;
  }
  server.execute("COMMIT");
}

/// The first disagreement between the data of a bundle and the audit trail of its station;
/// std::nullopt: none.
std::optional<std::string> problemIn(ServerReader& reader, const BundleHeader& bundle) {
  const auto stations = reader.stations();
  const auto station = std::ranges::find_if(
      stations, [&](const auto& row) { return row.station.uuid == bundle.station; });
  if (station == stations.end()) return "its station is not of this study";
  StationTrail trail(
      reader.origin(), *station, reader.events(*station), reader.keys(*station), bundle.last);
  if (!trail.problems().empty()) return trail.problems().front();
  std::optional<std::string> found;
  reader.forEachSession(*station, [&](const SessionOnServer& session) {
    if (found || session.lastEvent < bundle.first) return;
    const auto problems = trail.problemsOf(
        session.number,
        session.lastEvent,
        sessionTablesIn(session.facts),
        reader.chunks(*station, session.number));
    if (problems.empty()) return;
    found = "session " + std::to_string(session.number) + ": " + problems.front();
  });
  return found;
}

}  // namespace

AddedToServer addStudyOrVersion(
    Connection& server,
    const std::string& name,
    const protocols::LoadedProtocol& protocol,
    std::optional<std::uint64_t> seed) {
  requireName(name, "a study");
  const auto sent = protocolOnServerOf(protocol);
  if (!server.query("SELECT 1 FROM palpate.study WHERE name = $1", {name}).isEmpty()) {
    const auto uuid = findStudy(server, name).uuid;
    const auto present = protocolsOf(server, uuid).back();
    const auto id = protocolOf(present.text, filesIn(present.files)).protocol.study.id;
    if (id != protocol.protocol.study.id) {
      throw UserError(fmt::format(
          "The study '{}' has the protocol '{}', and this is '{}': not another version of it. "
          "Choose another name for another study (--study), or give the version the id '{}'.",
          name,
          id,
          protocol.protocol.study.id,
          id));
    }
    inTransaction(server, [&] {
      addProtocol(server, uuid, sent);
      server.query(
          "UPDATE palpate.study SET title = $2 WHERE uuid = $1",
          {uuid, protocol.protocol.study.title});
      replaceBackground(server, uuid, backgroundOf(protocol));
    });
    return present.sha256 == sent.sha256 ? AddedToServer::Nothing : AddedToServer::Version;
  }
  const auto drawn = seed ? *seed : protocol.protocol.seed.value_or(randomSeed());
  const auto secret = storage::BlindingSecret::drawn();
  const StudyOnServer study{
      .uuid = secret.studyUuid(drawn, sent.sha256),
      .name = name,
      .title = protocol.protocol.study.title,
      .seed = std::to_string(drawn),
      .secret = bytesOf(secret)};
  inTransaction(server, [&] {
    addStudy(server, study);
    addProtocol(server, study.uuid, sent);
    replaceBackground(server, study.uuid, backgroundOf(protocol));
  });
  return AddedToServer::Study;
}

std::optional<std::string> closeDatabase(Connection& server) {
  const auto database = server.query("SELECT quote_ident(current_database())").text(0, 0);
  std::string left;
  const auto takeAway = [&](const std::string& isOpen, const std::string& revoke) {
    const auto isStillOpen = [&] { return server.query("SELECT " + isOpen).text(0, 0) == "t"; };
    if (!isStillOpen()) return;
    server.execute(revoke);  // a warning, and no error, where this account may not
    if (isStillOpen()) left += " " + revoke + ";";
  };
  takeAway(
      "has_database_privilege('public', current_database(), 'TEMPORARY')",
      "REVOKE TEMPORARY ON DATABASE " + database + " FROM PUBLIC");
  for (const std::string& name : std::vector<std::string>{
           "lo_creat(integer)", "lo_create(oid)", "lo_from_bytea(oid, bytea)"}) {
    takeAway(
        "has_function_privilege('public', '" + name + "', 'EXECUTE')",
        "REVOKE EXECUTE ON FUNCTION " + name + " FROM PUBLIC");
  }
  if (left.empty()) return std::nullopt;
  return "Every role of this database can fill the server's disk. A superuser ends that in the "
         "database " +
         database + ":" + left;
}

std::optional<std::string> logPrivacyProblem(Connection& server) {
  const auto shown = [&](const char* setting) {
    return server.query("SELECT current_setting($1)", {setting}).text(0, 0);
  };
  const bool logsStatements = shown("log_statement") == "all" || shown("log_statement") == "mod" ||
                              shown("log_min_duration_statement") != "-1" ||
                              shown("log_min_duration_sample") != "-1" ||
                              shown("log_transaction_sample_rate") != "0";
  if (logsStatements && shown("log_parameter_max_length") != "0") {
    return "This server logs statements with what stations send, content keys among it. In "
           "postgresql.conf: log_parameter_max_length = 0.";
  }
  std::vector<std::string> missing;
  const auto prefix = shown("log_line_prefix");
  if (prefix.find("%u") == std::string::npos || prefix.find("%h") == std::string::npos) {
    missing.emplace_back("log_line_prefix = '%m [%p] %q%u@%d %h '");
  }
  const auto connections = shown("log_connections");
  if (connections.empty() || connections == "off") missing.emplace_back("log_connections = on");
  const auto lacksErrors = [&](const char* setting) {
    const auto level = shown(setting);
    return level == "log" || level == "fatal" || level == "panic";
  };
  if (lacksErrors("log_min_messages")) missing.emplace_back("log_min_messages = warning");
  if (lacksErrors("log_min_error_statement")) {
    missing.emplace_back("log_min_error_statement = error");
  }
  if (missing.empty()) return std::nullopt;
  return "The server's log does not say who was denied what, and from which computer. In "
         "postgresql.conf: " +
         base::joined(missing, ", ") + ".";
}

EnrolledStation enrolStation(Connection& server, const EnrolmentRequest& request) {
  requireName(request.site, "a site");
  const auto label = request.label.empty() ? request.site : request.label;
  requireName(label, "a station");
  // throws if it is no key, before anything is written
  storage::StationStore::sealFor("", request.key);
  if (!request.address.empty()) requireAddress(request.address);
  const auto study = findStudy(server, request.study);
  StationEnrolment enrolment{
      .study = study.uuid,
      .title = study.title,
      .seed = std::strtoull(study.seed.c_str(), nullptr, 10),
      .secret = secretOf(study).of(label),
      .station = {.site = request.site, .label = label, .uuid = drawnUuid()},
      .server = request.address.empty() ? server.address() : request.address,
      .bundleKey = bundleKeyOf(secretOf(study))};
  for (const auto& protocol : protocolsOf(server, study.uuid)) {
    enrolment.protocols.push_back({.text = protocol.text, .files = filesIn(protocol.files)});
  }
  EnrolledStation enrolled{
      .study = study.name, .label = label, .mark = keyFingerprintOf(secretOf(study))};
  inTransaction(server, [&] {
    const auto added = addStation(
        server,
        study.uuid,
        {.station = enrolment.station, .key = request.key, .days = request.days});
    enrolled.role = enrolment.role = added.role;
    enrolled.expiresUtc = enrolment.expiresUtc = added.expiresUtc;
    enrolled.file = asText(enrolment, request.key, secretOf(study));
  });
  return enrolled;
}

IngestedBundle ingestBundle(Connection& server, const std::filesystem::path& file) {
  const auto bundle = readBundleHeader(file);
  const auto rows = server.query(
      "SELECT s.key, s.label, d.name, s.have FROM palpate.station AS s JOIN palpate.study AS d "
      "ON d.uuid = s.study WHERE s.study = $1 AND s.uuid = $2",
      {bundle.study, bundle.station});
  if (rows.isEmpty()) {
    throw UserError(file.string() + " is of a station that this server does not know.");
  }
  IngestedBundle taken{
      .station = rows.text(0, 1), .before = rows.number(0, 3), .lastEvent = rows.number(0, 3)};
  const auto study = findStudy(server, rows.text(0, 2));
  ServerReader reader(server, study.name, "a bundle is checked");  // before the transaction
  ServerAnswer answer;
  const auto take = [&](const auto& text, const auto& chunks) {
    answer = ingest(server, text, chunks);
    if (answer.refused == "gap") {
      throw PushRefused(
          answer.refused,
          file.string() + " begins with event " + std::to_string(bundle.first) + " of '" +
              taken.station + "', and the server has only " + std::to_string(answer.lastEvent) +
              ": an earlier bundle is missing. Take it in first, or make one of everything: "
              "palpate collect bundle --after " +
              std::to_string(answer.lastEvent) + ".");
    }
    if (!answer.refused.empty()) throw PushRefused(answer.refused, wordsFor(answer));
    taken.lastEvent = answer.lastEvent;
    taken.erased.insert(taken.erased.end(), answer.erased.begin(), answer.erased.end());
    return true;
  };
  try {
    inTransaction(server, [&] {
      readBundle(file, secretOf(study), rows.text(0, 0), take);
      if (const auto problem = problemIn(reader, bundle)) {
        throw InvalidBundle(
            file.string() + " cannot be taken in: " + *problem +
            ". The study was changed on its station, or its disk is damaged: 'palpate study "
            "verify' says more there.");
      }
    });
  } catch (const InvalidBundle& error) {
    addIncident(server, bundle.station, "bundle", error.what());
    throw;
  } catch (const PushRefused&) {
    addIncident(server, bundle.station, answer.refused, answer.detail);
    throw;
  }
  return taken;
}

std::vector<ErasureReceipt> eraseParticipant(
    Connection& server,
    const std::string& study,
    const std::string& label,
    const std::string& participant,
    const std::string& reason) {
  const auto station = server.query(
      "SELECT uuid, id FROM palpate.station WHERE study = $1 AND label = $2 AND revoked IS NOT "
      "NULL",
      {study, label});
  if (station.isEmpty()) {
    throw UserError(
        "There is no revoked station named '" + label +
        "' in this study. While a station can push, erase there ('palpate study erase', then "
        "'palpate collect push'). Revoke one that is lost first.");
  }
  const std::string theirs = " station = $1::integer AND participant = $2";
  const std::vector<Parameter> of{station.number(0, 1), participant};
  const auto sessions = server.query("SELECT number FROM palpate.session WHERE" + theirs, of);
  if (sessions.isEmpty()) {
    throw UserError(
        "The server has no session of '" + participant + "' of the station '" + label + "'.");
  }
  inTransaction(server, [&] {
    server.query(
        "SELECT palpate.forget(s, x.number, x.participant, x.as_of) FROM palpate.station AS s JOIN "
        "palpate.session AS x ON x.station = s.id WHERE s.id = $1::integer AND x.participant = $2",
        of);
    server.query(
        "DELETE FROM palpate.answer WHERE station = $1::integer AND number IN (SELECT number FROM "
        "palpate.session WHERE" +
            theirs + ")",
        of);
    server.query("DELETE FROM palpate.session WHERE" + theirs, of);
    addIncident(server, station.text(0, 0), "erased", participant + ": " + reason);
  });
  const auto done = server.query(
      "SELECT x.number, to_char(x.erased AT TIME ZONE 'UTC', 'YYYY-MM-DD\"T\"HH24:MI:SS.MS\"Z\"'), "
      "palpate.left_of(s, x.number, x.participant) FROM palpate.tombstone AS x JOIN "
      "palpate.station AS s ON s.id = x.station WHERE s.id = $1::integer AND x.participant = $2 "
      "ORDER BY 1",
      of);
  std::vector<ErasureReceipt> receipts;
  for (int i = 0; i < done.count(); ++i) {
    receipts.push_back(
        {.session = done.number(i, 0),
         .participant = participant,
         .utc = done.text(i, 1),
         .left = done.number(i, 2)});
  }
  return receipts;
}

}  // namespace study::collect

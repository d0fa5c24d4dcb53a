#include "study/collect/server/registry.h"

#include <algorithm>

#include <fmt/format.h>

#include "study/model/user_error.h"

namespace study::collect {
namespace {

constexpr const char* kUtcFormat = R"('YYYY-MM-DD"T"HH24:MI:SS.MS"Z"')";

/// A name in SQL cannot contain '-' without quotation marks.
std::string roleNamed(const std::string& prefix, std::string name) {
  std::ranges::replace(name, '-', '_');
  return prefix + name;
}

void makeRole(Connection& server, const std::string& role, const char* options, const char* group) {
  if (server.query("SELECT 1 FROM pg_roles WHERE rolname = $1", {role}).isEmpty()) {
    server.execute("CREATE ROLE " + server.quotedName(role) + " " + options);
  }
  server.execute("GRANT " + std::string(group) + " TO " + server.quotedName(role));
}

StudyOnServer readStudyRow(const Rows& rows) {
  return {
      .uuid = rows.text(0, 0),
      .name = rows.text(0, 1),
      .title = rows.text(0, 2),
      .seed = rows.text(0, 3),
      .secret = rows.bytes(0, 4)};
}

}  // namespace

void addStudy(Connection& server, const StudyOnServer& study) {
  if (!server.query("SELECT 1 FROM palpate.study WHERE name = $1", {study.name}).isEmpty()) {
    throw UserError(
        "There is a study named '" + study.name + "' on the server. Choose another name.");
  }
  server.query(
      "INSERT INTO palpate.study (uuid, name, title, seed, secret) VALUES ($1, $2, $3, $4, $5)",
      {study.uuid, study.name, study.title, study.seed, Parameter::bytes(study.secret)});
}

void addProtocol(Connection& server, const std::string& study, const ProtocolOnServer& protocol) {
  server.query(
      "INSERT INTO palpate.protocol (study, sha256, text, files) VALUES ($1, $2, $3, $4::json) "
      "ON CONFLICT (study, sha256) DO UPDATE SET added = clock_timestamp()",
      {study, protocol.sha256, protocol.text, protocol.files});
}

void replaceBackground(
    Connection& server, const std::string& study, const std::vector<BackgroundItem>& items) {
  for (const auto& item : items) {
    server.query(
        "INSERT INTO palpate.background_item (study, phase, item, width, whole) "
        "VALUES ($1, $2, $3, $4::double precision, $5::boolean) "
        "ON CONFLICT (study, phase, item) DO UPDATE SET width = excluded.width, whole = "
        "excluded.whole",
        {study,
         item.phase,
         item.item,
         item.width ? Parameter(fmt::format("{}", *item.width)) : Parameter::null(),
         item.isWhole ? "true" : "false"});
  }
}

std::vector<ProtocolOnServer> protocolsOf(Connection& server, const std::string& study) {
  const auto rows = server.query(
      "SELECT sha256, text, files FROM palpate.protocol WHERE study = $1 ORDER BY added, sha256",
      {study});
  if (rows.isEmpty()) throw UserError("The study on the server has no protocol.");
  std::vector<ProtocolOnServer> protocols;
  for (int i = 0; i < rows.count(); ++i) {
    protocols.push_back(
        {.sha256 = rows.text(i, 0), .text = rows.text(i, 1), .files = rows.text(i, 2)});
  }
  return protocols;
}

namespace {

/// The names of the studies in @p rows: "a, b".
std::string namesIn(const Rows& rows) {
  std::string names;
  for (int i = 0; i < rows.count(); ++i) names += (i == 0 ? "" : ", ") + rows.text(i, 1);
  return names;
}

}  // namespace

StudyOnServer findStudy(Connection& server, const std::string& name) {
  const std::string select = "SELECT uuid, name, title, seed, secret FROM palpate.study ";
  const auto rows = name.empty() ? server.query(select + "ORDER BY name")
                                 : server.query(select + "WHERE name = $1", {name});
  if (rows.count() == 1) return readStudyRow(rows);
  if (rows.isEmpty() && !name.empty()) {
    const auto others = server.query(select + "ORDER BY name");
    throw UserError(
        "There is no study named '" + name + "' on this server." +
        (others.isEmpty() ? "" : " There are: " + namesIn(others) + "."));
  }
  throw UserError(
      rows.isEmpty()
          ? "There is no study on this server yet: 'palpate collect init --protocol FILE "
            "--study NAME' makes one."
          : "There are several studies on this server: " + namesIn(rows) +
                ". Say which one: --study NAME.");
}

AddedStation addStation(Connection& server, const std::string& study, const NewStation& added) {
  const auto& station = added.station;
  const auto same = server.query(
      "SELECT 1 FROM palpate.station WHERE study = $1 AND label = $2", {study, station.label});
  if (!same.isEmpty()) {
    throw UserError(
        "There is a station named '" + station.label +
        "' in this study. Choose another name with --name: several stations of a site may be "
        "called " +
        station.site + "-2, " + station.site + "-3.");
  }
  const auto role = roleNamed("station_", station.label);
  makeRole(server, role, "LOGIN", "palpate_station");
  makeRole(server, roleNamed("operator_", station.site), "NOLOGIN", "palpate_operator");
  const auto rows = server.query(
      std::string("INSERT INTO palpate.station (study, uuid, site, label, role, key, expires) "
                  "VALUES ($1, $2, $3, $4, $5, $6, now() + $7::integer * interval '1 day') "
                  "RETURNING to_char(expires AT TIME ZONE 'UTC', ") +
          kUtcFormat + ")",
      {study,
       station.uuid,
       station.site,
       station.label,
       role,
       added.key,
       std::int64_t{added.days}});
  return {.role = role, .expiresUtc = rows.text(0, 0)};
}

void revokeStation(
    Connection& server,
    const std::string& study,
    const std::string& label,
    const std::string& reason) {
  const auto before = server.query(
      std::string("SELECT to_char(revoked AT TIME ZONE 'UTC', ") + kUtcFormat +
          "), revoked_reason FROM palpate.station WHERE study = $1 AND label = $2",
      {study, label});
  if (before.isEmpty()) throw UserError("There is no station named '" + label + "' in this study.");
  const auto revoked = server.query(
      "UPDATE palpate.station SET revoked = now(), revoked_reason = $3, revoked_by = session_user "
      "WHERE study = $1 AND label = $2 AND revoked IS NULL RETURNING id",
      {study, label, reason});
  if (!revoked.isEmpty()) return;
  throw UserError(fmt::format(
      "'{}' was revoked already, on {}: {}. That stays as it is.",
      label,
      before.text(0, 0).substr(0, 10),
      before.text(0, 1)));
}

bool setAsideStation(
    Connection& server,
    const std::string& study,
    const std::string& label,
    const std::string& reason) {
  const auto revoked = server.query(
      "SELECT 1 FROM palpate.station WHERE study = $1 AND label = $2 AND revoked IS NOT NULL",
      {study, label});
  const auto rows = server.query("SELECT palpate.set_aside($1, $2, $3)", {study, label, reason});
  if (rows.text(0, 0) == "t") return !revoked.isEmpty();
  throw UserError("There is no station named '" + label + "' in this study.");
}

std::vector<StationStatus> stationsOf(Connection& server, const std::string& studyName) {
  const auto rows = server.query(
      std::string("SELECT site, station, events, sessions, incidents, to_char(last_contact AT TIME "
                  "ZONE 'UTC', ") +
          kUtcFormat +
          "), revoked IS NOT NULL, set_aside IS NOT NULL FROM palpate.stations WHERE $1 IN ('', "
          "study_name) "
          "ORDER BY study_name, station",
      {studyName});
  std::vector<StationStatus> stations;
  for (int i = 0; i < rows.count(); ++i) {
    stations.push_back(
        {.site = rows.text(i, 0),
         .station = rows.text(i, 1),
         .events = rows.number(i, 2),
         .sessions = rows.number(i, 3),
         .incidents = rows.number(i, 4),
         .lastContact = rows.text(i, 5),
         .isRevoked = rows.text(i, 6) == "t",
         .isSetAside = rows.text(i, 7) == "t"});
  }
  return stations;
}

void addIncident(
    Connection& server,
    const std::string& station,
    const std::string& what,
    const std::string& detail) {
  server.query(
      "INSERT INTO palpate.incident (station, what, detail) "
      "SELECT id, $2, $3 FROM palpate.station WHERE uuid = $1",
      {station, what, detail});
}

std::vector<Incident> incidentsOf(Connection& server, int most) {
  const auto rows = server.query(
      std::string("SELECT to_char(i.at AT TIME ZONE 'UTC', ") + kUtcFormat +
          "), i.role, coalesce(s.label, ''), i.what, i.detail FROM palpate.incident AS i "
          "LEFT JOIN palpate.station AS s ON s.id = i.station ORDER BY i.id DESC LIMIT $1",
      {std::int64_t{most}});
  std::vector<Incident> incidents;
  for (int i = 0; i < rows.count(); ++i) {
    incidents.push_back(
        {.at = rows.text(i, 0),
         .role = rows.text(i, 1),
         .station = rows.text(i, 2),
         .what = rows.text(i, 3),
         .detail = rows.text(i, 4)});
  }
  return incidents;
}

}  // namespace study::collect

#include "study/collect/server/schema.h"

#include <array>
#include <string>

namespace study::collect {
namespace {

/// Group roles, which are granted to roles that can log in.
constexpr std::array kRoles{
    "palpate_owner",      // owns the schema; granted to the account that installs it
    "palpate_station",    // may call ingest
    "palpate_analyst",    // sees points, without conditions
    "palpate_unblinder",  // may pull all of it, with a reason
    "palpate_operator",   // sees which sessions of its own site have arrived
};

void makeRoles(Connection& server) {
  for (const char* role : kRoles) {
    if (!server.query("SELECT 1 FROM pg_roles WHERE rolname = $1", {role}).isEmpty()) continue;
    server.execute("CREATE ROLE " + server.quotedName(role) + " NOLOGIN");
  }
  server.execute("GRANT palpate_owner TO CURRENT_USER");
}

[[noreturn]] void refuse(int installed) {
  const auto here = std::to_string(newestSchema());
  const auto there = std::to_string(installed);
  throw ServerError(
      ServerError::Kind::Release,
      installed == 0 ? "There is no study on this server yet: 'palpate collect init' makes one."
      : installed > newestSchema()
          ? "The server is newer than this program (its schema is " + there +
                ", this program knows " + here + "). Install the release of the server here."
          : "The server is older than this program (its schema is " + there + ", " + here +
                " is needed). Whoever runs the server brings it up to date with 'palpate collect "
                "init'. Nothing is lost until then.");
}

}  // namespace

int newestSchema() {
  return static_cast<int>(schemaSteps().size());
}

int installedSchema(Connection& server) {
  const auto table = server.query("SELECT to_regclass('palpate.schema_step')");
  if (table.isNull(0, 0)) return 0;
  return static_cast<int>(
      server.query("SELECT coalesce(max(step), 0) FROM palpate.schema_step").number(0, 0));
}

void requireSchema(Connection& server) {
  const int installed = installedSchema(server);
  if (installed != newestSchema()) refuse(installed);
}

int installSchema(Connection& server) {
  const int before = installedSchema(server);
  if (before > newestSchema()) refuse(before);
  if (before == newestSchema()) return before;
  server.execute("BEGIN");
  makeRoles(server);
  if (before == 0) {
    server.execute(
        "CREATE SCHEMA palpate AUTHORIZATION palpate_owner;"
        "SET LOCAL ROLE palpate_owner;"
        "CREATE TABLE palpate.schema_step (step integer PRIMARY KEY, installed timestamptz NOT "
        "NULL "
        "DEFAULT now());"
        "GRANT USAGE ON SCHEMA palpate TO palpate_station, palpate_analyst, palpate_unblinder, "
        "palpate_operator;"
        "GRANT SELECT ON palpate.schema_step TO palpate_station, palpate_analyst, "
        "palpate_unblinder, palpate_operator");
  }
  server.execute("SET LOCAL ROLE palpate_owner; SET LOCAL search_path = palpate, pg_temp");
  for (int step = before + 1; step <= newestSchema(); ++step) {
    server.execute(std::string(schemaSteps()[static_cast<std::size_t>(step - 1)].content));
    server.query("INSERT INTO palpate.schema_step (step) VALUES ($1)", {std::int64_t{step}});
  }
  server.execute("COMMIT");
  return before;
}

}  // namespace study::collect

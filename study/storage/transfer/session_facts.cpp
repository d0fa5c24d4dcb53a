#include "study/storage/transfer/session_facts.h"

#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "study/model/run_mode.h"
#include "study/storage/session_repository.h"
#include "study/storage/statement.h"
#include "study/storage/trial_repository.h"

namespace study::storage {
namespace {

/// The columns of a table that do not depend on the file: no row numbers of this file.
struct Table {
  std::string_view name;
  std::string_view columns;
  std::string_view order;  ///< sort key, so that all files return the rows in the same order
};

// The columns of participant and session are listed in the functions below, because they refer to
// other tables. Other functions read and write the tables with sealed columns: allocation, trial,
// cut.
constexpr std::array kTables{
    Table{"step", "step, kind, phase, instrument, item_set, position, label", "step"},
    Table{"visit", "step, attempt, status, began_utc, ended_utc, reason", "step, attempt"},
    Table{
        "answer",
        "step, attempt, item, item_order, kind, point, number, text, first_touch_s, response_s, "
        "changes, language, saved_utc",
        "step, attempt, item"}};

constexpr std::string_view kSessionColumns =
    "number, run_mode, cohort, language, slot, slot_state, state, step, attempt, app_version, "
    "started_utc, ended_utc, end_reason, site, station";

const NamedRow& onlyRow(const SessionTables& facts, const std::string& table) {
  const auto& rows = rowsIn(facts, table);
  if (rows.size() != 1) refuseRows("it has no row of " + table);
  return rows.front();
}

std::string textIn(const NamedRow& row, const std::string& column) {
  const auto found = row.find(column);
  const auto* text = found == row.end() ? nullptr : std::get_if<std::string>(&found->second);
  if (text == nullptr) refuseRows("it has no " + column);
  return *text;
}

std::int64_t participantIn(Database& database, const NamedRow& participant) {
  const auto code = textIn(participant, "code");
  Statement select(database, "SELECT id FROM participant WHERE code = ?");
  select.bindAll(code);
  if (select.step()) return select.number(0);
  insertRows(database, "participant", "code, cohort, run_mode, created_utc", {participant}, {});
  return database.lastInsertedId();
}

std::int64_t protocolIn(const Database& database, const std::string& hash) {
  Statement select(database, "SELECT id FROM protocol WHERE sha256 = ?");
  select.bindAll(hash);
  if (!select.step()) refuseRows("the study has not its protocol " + hash);
  return select.number(0);
}

/// @param key  seals the conditions; nullptr: they are stored unsealed
void addAllocation(
    Database& study, SessionId session, const SessionTables& facts, const SealingKey* key) {
  for (const auto& row : rowsIn(facts, "allocation")) {
    const auto place = row.find("step");
    const auto* step = place == row.end() ? nullptr : std::get_if<std::int64_t>(&place->second);
    if (step == nullptr) refuseRows("a row of allocation has no step");
    addCondition(study, session, *step, textIn(row, "condition"), key);
  }
}

/// @param sessionNumber  number of the session's row; std::nullopt: the next free one
SessionId addRows(
    Database& study,
    const SessionTables& facts,
    std::optional<SessionId> sessionNumber,
    const SealingKey* key,
    const std::set<VisitKey>& openTrials) {
  NamedRow session = onlyRow(facts, "session");
  const auto protocol = protocolIn(study, textIn(session, "protocol"));
  session.erase("protocol");
  const auto participant = participantIn(study, onlyRow(facts, "participant"));
  std::vector<std::pair<std::string, std::int64_t>> keys{
      {"participant_id", participant}, {"protocol_id", protocol}};
  if (sessionNumber) keys.emplace_back("id", static_cast<std::int64_t>(*sessionNumber));
  insertRows(study, "session", kSessionColumns, {session}, keys);
  const SessionId id{study.lastInsertedId()};
  for (const auto& table : kTables) {
    insertRows(
        study,
        table.name,
        table.columns,
        rowsIn(facts, table.name),
        {{"session_id", static_cast<std::int64_t>(id)}});
  }
  const UnsealedTrialRows trials{.trials = rowsIn(facts, "trial"), .cuts = rowsIn(facts, "cut")};
  TrialRepository(study).add(id, trials, key, openTrials);
  addAllocation(study, id, facts, key);
  return id;
}

}  // namespace

const std::vector<NamedRow>& rowsIn(const SessionTables& facts, std::string_view table) {
  const auto rows = facts.find(std::string(table));
  if (rows == facts.end()) refuseRows("it has no rows of " + std::string(table));
  return rows->second;
}

std::string textIn(
    const SessionTables& facts, const std::string& table, const std::string& column) {
  const auto rows = facts.find(table);
  if (rows == facts.end() || rows->second.empty()) return {};
  const auto found = rows->second.front().find(column);
  if (found == rows->second.front().end()) return {};
  const auto* text = std::get_if<std::string>(&found->second);
  return text == nullptr ? std::string() : *text;
}

SessionTables sessionTablesOf(const Database& study, SessionId session) {
  SessionTables facts;
  facts["participant"] = rowsOf(
      study,
      "SELECT p.code, p.cohort, p.run_mode, p.created_utc FROM participant AS p "
      "JOIN session AS s ON s.participant_id = p.id WHERE s.id = ?",
      "code, cohort, run_mode, created_utc",
      session);
  const std::string columns(kSessionColumns);
  facts["session"] = rowsOf(
      study,
      "SELECT " + columns + ", (SELECT sha256 FROM protocol AS p WHERE p.id = protocol_id) " +
          "FROM session WHERE id = ?",
      columns + ", protocol",
      session);
  onlyRow(facts, "session");
  // Conditions are unsealed here, even if they are sealed in this file.
  auto& allocation = facts["allocation"];
  for (const auto& [step, condition] : allocationOf(study, session)) {
    allocation.push_back({{"step", std::int64_t{step}}, {"condition", condition}});
  }
  for (const auto& table : kTables) {
    facts[std::string(table.name)] = rowsOf(
        study,
        "SELECT " + std::string(table.columns) + " FROM " + std::string(table.name) +
            " WHERE session_id = ? ORDER BY " + std::string(table.order),
        table.columns,
        session);
  }
  auto trials = trialsOf(study, session);
  facts["trial"] = std::move(trials.trials);
  facts["cut"] = std::move(trials.cuts);
  return facts;
}

SessionId addSessionTables(Database& study, const SessionTables& facts) {
  const bool isSealed = textIn(onlyRow(facts, "session"), "run_mode") != nameOf(RunMode::Simulated);
  return addRows(study, facts, {}, isSealed ? study.key() : nullptr, {});
}

void addSessionTablesAs(
    Database& study,
    const SessionTables& facts,
    SessionId session,
    const SealingKey* key,
    const std::set<VisitKey>& openTrials) {
  addRows(study, facts, session, key, openTrials);
}

std::vector<LastSessionEvent> lastSessionEvents(const Database& study) {
  Statement select(
      study,
      "SELECT s.id, p.code, e.seq, e.utc, s.run_mode = 'simulated' FROM session AS s "
      "JOIN participant AS p ON p.id = s.participant_id "
      "JOIN event AS e ON e.seq = (SELECT max(seq) FROM event WHERE session_id = s.id) "
      "ORDER BY s.id");
  std::vector<LastSessionEvent> marks;
  while (select.step()) {
    marks.push_back(
        {.session = SessionId{select.number(0)},
         .participant = select.text(1),
         .lastEvent = select.number(2),
         .utc = select.text(3),
         .isSimulated = select.number(4) != 0});
  }
  return marks;
}

}  // namespace study::storage

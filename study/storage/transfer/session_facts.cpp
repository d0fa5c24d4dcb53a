#include "study/storage/transfer/session_facts.h"

#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "study/model/run_mode.h"
#include "study/storage/hasher.h"
#include "study/storage/keys/sealed_condition.h"
#include "study/storage/statement.h"

namespace study::storage {
namespace {

/// The columns of a table that are the same in every file.
struct Table {
  std::string_view name;
  std::string_view columns;
  std::string_view order;  ///< that makes two files give the same rows
};

// Of participant and session the columns are written out below: they refer to other tables.
constexpr std::array kTables{
    Table{"step", "step, kind, phase, instrument, item_set, position, label", "step"},
    Table{"visit", "step, attempt, status, began_utc, ended_utc, reason", "step, attempt"},
    Table{
        "answer",
        "step, attempt, item, item_order, kind, point, number, text, first_touch_s, response_s, "
        "changes, language, saved_utc",
        "step, attempt, item"},
    Table{
        "trial",
        "step, attempt, device, ending, verdict, verdict_reason, force_unit, travel_unit, "
        "duration_s, ticks, nominal_rate_hz, achieved_rate_hz, lateness_p50_us, lateness_p99_us, "
        "lateness_max_us, late_ticks, lost_samples, invalid_ticks, saturated_s, slewed_s, "
        "undefined_s, contact_s, largest_force_n, cuts, trace_samples",
        "step, attempt"},
    Table{
        "cut",
        "step, attempt, number, interception_travel, interception_n, yield_travel, yield_n, "
        "bottom_out_travel, bottom_out_n, opening_travel, opening_n, peak_n",
        "step, attempt, number"}};

constexpr std::string_view kSessionColumns =
    "number, run_mode, cohort, language, slot, slot_state, state, step, attempt, app_version, "
    "started_utc, ended_utc, end_reason, site, station";

std::vector<std::string> namesIn(std::string_view columns) {
  std::vector<std::string> names(1);
  for (const char c : columns) {
    if (c == ',') {
      names.emplace_back();
    } else if (c != ' ') {
      names.back() += c;
    }
  }
  return names;
}

FactValue valueIn(const Statement& row, int column) {
  // The first byte says the type (Statement::exactBytes).
  switch (row.exactBytes(column).front()) {
    case 'i':
      return row.number(column);
    case 'r':
      return row.real(column);
    case 't':
      return row.text(column);
    default:
      return std::monostate();
  }
}

std::vector<FactRow> rowsOf(
    const Database& database, const std::string& sql, std::string_view columns, SessionId session) {
  Statement select(database, sql);
  select.bind(1, static_cast<std::int64_t>(session));
  const auto names = namesIn(columns);
  std::vector<FactRow> rows;
  while (select.step()) {
    FactRow& row = rows.emplace_back();
    for (std::size_t i = 0; i < names.size(); ++i)
      row[names[i]] = valueIn(select, static_cast<int>(i));
  }
  return rows;
}

[[noreturn]] void refuse(const std::string& what) {
  throw StorageError(
      "A session that was collected cannot be kept: " + what +
          ". It was written by a later release, or it is damaged.",
      StorageError::Kind::Damaged);
}

const FactRow& onlyRow(const SessionFacts& facts, const std::string& table) {
  const auto found = facts.find(table);
  if (found == facts.end() || found->second.size() != 1) refuse("it has no row of " + table);
  return found->second.front();
}

std::string textIn(const FactRow& row, const std::string& column) {
  const auto found = row.find(column);
  const auto* text = found == row.end() ? nullptr : std::get_if<std::string>(&found->second);
  if (text == nullptr) refuse("it has no " + column);
  return *text;
}

void bind(Statement& statement, int index, const FactValue& value) {
  if (const auto* number = std::get_if<std::int64_t>(&value)) {
    statement.bind(index, *number);
  } else if (const auto* real = std::get_if<double>(&value)) {
    statement.bind(index, *real);
  } else if (const auto* text = std::get_if<std::string>(&value)) {
    statement.bind(index, std::string_view(*text));
  } else {
    statement.bindNull(index);
  }
}

/// Inserts rows with the columns that this program knows; every one of them has to be there, and no
/// other.
void insert(
    Database& database,
    std::string_view table,
    std::string_view columns,
    const std::vector<FactRow>& rows,
    const std::vector<std::pair<std::string, std::int64_t>>& keys) {
  const auto names = namesIn(columns);
  std::string all;
  std::string marks;
  for (const auto& [name, value] : keys) {
    all += name + ", ";
    marks += "?,";
  }
  for (std::size_t i = 0; i < names.size(); ++i) marks += i == 0 ? "?" : ",?";
  Statement statement(
      database,
      "INSERT INTO " + std::string(table) + " (" + all + std::string(columns) + ") VALUES (" +
          marks + ")");
  for (const auto& row : rows) {
    if (row.size() != names.size()) refuse("a row of " + std::string(table) + " has other columns");
    int index = 1;
    for (const auto& [name, value] : keys) statement.bind(index++, value);
    for (const auto& name : names) {
      const auto found = row.find(name);
      if (found == row.end()) refuse("a row of " + std::string(table) + " has no " + name);
      bind(statement, index++, found->second);
    }
    statement.run();
  }
}

std::int64_t participantIn(Database& database, const FactRow& participant) {
  const auto code = textIn(participant, "code");
  Statement select(database, "SELECT id FROM participant WHERE code = ?");
  select.bind(1, code);
  if (select.step()) return select.number(0);
  insert(database, "participant", "code, cohort, run_mode, created_utc", {participant}, {});
  return database.lastInsertedId();
}

std::int64_t protocolIn(const Database& database, const std::string& hash) {
  Statement select(database, "SELECT id FROM protocol WHERE sha256 = ?");
  select.bind(1, hash);
  if (!select.step()) refuse("the study has not its protocol " + hash);
  return select.number(0);
}

std::vector<std::pair<int, std::string>> openAllocation(const Database& study, SessionId session) {
  Statement select(
      study, "SELECT step, condition, sealed FROM allocation WHERE session_id = ? ORDER BY step");
  select.bind(1, static_cast<std::int64_t>(session));
  std::vector<std::pair<int, std::string>> conditions;
  while (select.step()) {
    const auto step = static_cast<int>(select.number(0));
    const auto sealed = select.blob(2);
    conditions.emplace_back(
        step,
        sealed.empty() ? select.text(1) : openedCondition(study.key(), session, step, sealed));
  }
  return conditions;
}

/// @param key  with which it is sealed here; nullptr: it is not
void addAllocation(
    Database& study, SessionId session, const SessionFacts& facts, const SealingKey* key) {
  const auto rows = facts.find("allocation");
  if (rows == facts.end()) refuse("it has no rows of allocation");
  Statement insert(
      study, "INSERT INTO allocation (session_id, step, condition, sealed) VALUES (?,?,?,?)");
  for (const auto& row : rows->second) {
    const auto place = row.find("step");
    const auto* step = place == row.end() ? nullptr : std::get_if<std::int64_t>(&place->second);
    if (step == nullptr) refuse("a row of allocation has no step");
    const auto condition = textIn(row, "condition");
    insert.bind(1, static_cast<std::int64_t>(session)).bind(2, *step);
    if (key == nullptr) {
      insert.bind(3, std::string_view(condition)).bindNull(4);
    } else {
      const auto sealed = sealedCondition(*key, session, static_cast<int>(*step), condition);
      insert.bind(3, std::string_view("")).bind(4, std::span<const std::byte>(sealed));
    }
    insert.run();
  }
}

/// @param as  the number of its row; std::nullopt: the next one
SessionId addRows(
    Database& study,
    const SessionFacts& facts,
    std::optional<SessionId> as,
    const SealingKey* key) {
  FactRow session = onlyRow(facts, "session");
  const auto protocol = protocolIn(study, textIn(session, "protocol"));
  session.erase("protocol");
  const auto participant = participantIn(study, onlyRow(facts, "participant"));
  std::vector<std::pair<std::string, std::int64_t>> keys{
      {"participant_id", participant}, {"protocol_id", protocol}};
  if (as) keys.emplace_back("id", static_cast<std::int64_t>(*as));
  insert(study, "session", kSessionColumns, {session}, keys);
  const SessionId id{study.lastInsertedId()};
  for (const auto& table : kTables) {
    const auto rows = facts.find(std::string(table.name));
    if (rows == facts.end()) refuse("it has no rows of " + std::string(table.name));
    insert(
        study,
        table.name,
        table.columns,
        rows->second,
        {{"session_id", static_cast<std::int64_t>(id)}});
  }
  addAllocation(study, id, facts, key);
  return id;
}

}  // namespace

std::string textIn(const SessionFacts& facts, const std::string& table, const std::string& column) {
  const auto rows = facts.find(table);
  if (rows == facts.end() || rows->second.empty()) return {};
  const auto found = rows->second.front().find(column);
  if (found == rows->second.front().end()) return {};
  const auto* text = std::get_if<std::string>(&found->second);
  return text == nullptr ? std::string() : *text;
}

SessionFacts factsOf(const Database& study, SessionId session) {
  SessionFacts facts;
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
  // In the open, whatever seals it in this file.
  auto& allocation = facts["allocation"];
  for (const auto& [step, condition] : openAllocation(study, session)) {
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
  return facts;
}

SessionId addFacts(Database& study, const SessionFacts& facts) {
  const bool isSealed = textIn(onlyRow(facts, "session"), "run_mode") != nameOf(RunMode::Simulated);
  return addRows(study, facts, {}, isSealed ? study.key() : nullptr);
}

void addFactsAs(
    Database& study, const SessionFacts& facts, SessionId session, const SealingKey* key) {
  addRows(study, facts, session, key);
}

std::vector<TraceChunk> chunksOf(const Database& traces, const VisitKey& visit) {
  Statement select(
      traces,
      "SELECT number, samples, layout, data, hash FROM chunk "
      "WHERE session_id = ? AND step = ? AND attempt = ? ORDER BY number");
  select.bind(1, visit);
  std::vector<TraceChunk> chunks;
  while (select.step()) {
    chunks.push_back(
        {.step = visit.step,
         .attempt = visit.attempt,
         .number = select.number(0),
         .samples = select.number(1),
         .layout = select.number(2),
         .data = select.blob(3),
         .hash = select.blob(4)});
  }
  return chunks;
}

void addChunk(Database& traces, SessionId session, const TraceChunk& chunk) {
  if (asBytes(hashOf(chunk.data)) != chunk.hash) {
    throw StorageError(
        "A trace that was collected is not what was recorded. 'palpate collect check' says of "
        "which "
        "session.",
        StorageError::Kind::Damaged);
  }
  Statement insert(
      traces,
      "INSERT INTO chunk (session_id, step, attempt, number, samples, layout, data, hash) "
      "VALUES (?,?,?,?,?,?,?,?)");
  insert.bind(1, VisitKey{session, chunk.step, chunk.attempt});
  insert.bind(4, chunk.number)
      .bind(5, chunk.samples)
      .bind(6, chunk.layout)
      .bind(7, std::span<const std::byte>(chunk.data))
      .bind(8, std::span<const std::byte>(chunk.hash));
  insert.run();
}

std::vector<SessionMark> sessionMarks(const Database& study) {
  Statement select(
      study,
      "SELECT s.id, p.code, e.seq, e.utc FROM session AS s "
      "JOIN participant AS p ON p.id = s.participant_id "
      "JOIN event AS e ON e.seq = (SELECT max(seq) FROM event WHERE session_id = s.id) "
      "ORDER BY s.id");
  std::vector<SessionMark> marks;
  while (select.step()) {
    marks.push_back(
        {.session = SessionId{select.number(0)},
         .participant = select.text(1),
         .lastEvent = select.number(2),
         .utc = select.text(3)});
  }
  return marks;
}

}  // namespace study::storage

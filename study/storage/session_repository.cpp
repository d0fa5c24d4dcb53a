#include "study/storage/session_repository.h"

#include <array>
#include <set>

#include <fmt/format.h>

#include "study/model/named_value.h"
#include "study/storage/required_key.h"
#include "study/storage/statement.h"

namespace study::storage {
namespace {

constexpr std::array<std::string_view, 3> kSlotStates{"reserved", "consumed", "released"};
constexpr std::array<std::string_view, 5> kVisitStatuses{
    "open", "finished", "skipped", "repeated", "broken_off"};

constexpr const char* kSelect =
    "SELECT s.id, p.code, s.number, s.protocol_id, s.run_mode, s.cohort, s.language, s.slot, "
    "s.slot_state, s.state, s.step, s.attempt, s.started_utc, s.ended_utc, s.end_reason, ";
constexpr const char* kStationColumns = "s.site, s.station";
constexpr const char* kNoStationColumns = "'', ''";
constexpr const char* kFromClause =
    " FROM session AS s JOIN participant AS p ON p.id = s.participant_id ";

}  // namespace

std::string selectSessions(const Database& database, const std::string& moreColumns) {
  const bool hasStations = database.hasColumn("session", "station");
  return std::string(kSelect) + (hasStations ? kStationColumns : kNoStationColumns) + moreColumns +
         kFromClause;
}

SessionRow sessionIn(const Statement& row) {
  const auto mode = runModeNamed(row.text(4));
  const auto state = sessionStateNamed(row.text(9));
  if (!mode || !state) {
    throw StorageError(
        "A session's state cannot be read. Is the study damaged? 'palpate study verify' says more.",
        StorageError::Kind::Damaged);
  }
  return {
      .id = SessionId{row.number(0)},
      .participant = row.text(1),
      .number = static_cast<int>(row.number(2)),
      .protocol = ProtocolId{row.number(3)},
      .runMode = *mode,
      .cohort = row.text(5),
      .language = row.text(6),
      .site = row.text(15),
      .station = row.text(16),
      .slot = row.number(7),
      .slotState = requireKnown(valueNamed<SlotState>(kSlotStates, row.text(8)), row.text(8)),
      .state = *state,
      .step = static_cast<int>(row.number(10)),
      .attempt = static_cast<int>(row.number(11)),
      .startedUtc = row.text(12),
      .endedUtc = row.optionalText(13),
      .endReason = row.optionalText(14)};
}

const char* sealedColumn(const Database& database) {
  return database.hasTable("wrapped_key") ? "a.sealed" : "NULL";
}

std::string_view nameOf(SlotState state) noexcept {
  return kSlotStates[static_cast<std::size_t>(state)];
}

std::string_view nameOf(VisitStatus status) noexcept {
  return kVisitStatuses[static_cast<std::size_t>(status)];
}

std::optional<VisitStatus> visitStatusNamed(std::string_view name) noexcept {
  return valueNamed<VisitStatus>(kVisitStatuses, name);
}

std::int64_t SessionRepository::freeSlot(
    const std::vector<ProtocolId>& versions,
    RunMode mode,
    const std::string& cohort,
    const std::string& station) const {
  std::set<std::int64_t> held;
  for (const auto version : versions) {
    Statement select(
        database_,
        "SELECT slot FROM session WHERE protocol_id = ? AND run_mode = ? AND cohort = ? "
        "AND station = ? AND slot_state <> 'released'");
    select.bindAll(version, nameOf(mode), cohort, station);
    while (select.step()) held.insert(select.number(0));
  }
  std::int64_t free = 0;
  while (held.contains(free)) ++free;
  return free;
}

std::string SessionRepository::freeCode(RunMode mode, const std::string& station) const {
  const std::string prefix =
      (station.empty() ? "" : station + "_") + (mode == RunMode::Live    ? "P"
                                                : mode == RunMode::Pilot ? "PILOT-"
                                                                         : "SIM-");
  Statement count(database_, "SELECT count(*) FROM participant WHERE run_mode = ?");
  count.bindAll(nameOf(mode));
  count.step();
  for (auto number = count.number(0) + 1;; ++number) {
    std::string code = fmt::format("{}{:03d}", prefix, number);
    if (!hasParticipant(code)) return code;
  }
}

bool SessionRepository::hasParticipant(const std::string& code) const {
  Statement select(database_, "SELECT 1 FROM participant WHERE code = ?");
  select.bindAll(code);
  return select.step();
}

std::string SessionRepository::enrolledUtc(const std::string& code) const {
  Statement select(database_, "SELECT created_utc FROM participant WHERE code = ?");
  select.bindAll(code);
  return select.step() ? select.text(0) : std::string();
}

std::int64_t SessionRepository::participantId(const SessionRow& session) {
  Statement select(database_, "SELECT id, cohort, run_mode FROM participant WHERE code = ?");
  select.bindAll(session.participant);
  if (select.step()) {
    if (select.text(1) != session.cohort || select.text(2) != nameOf(session.runMode)) {
      throw StorageError(
          "'" + session.participant + "' is known as " + select.text(2) + " of the cohort '" +
          select.text(1) + "'. Choose another code, or the same cohort and run mode.");
    }
    return select.number(0);
  }
  Statement insert(
      database_, "INSERT INTO participant (code, cohort, run_mode, created_utc) VALUES (?,?,?,?)");
  insert.bindAll(session.participant, session.cohort, nameOf(session.runMode), session.startedUtc);
  insert.run();
  return database_.lastInsertedId();
}

void SessionRepository::add(
    SessionRow& session, const std::vector<Step>& steps, const std::string& appVersion) {
  const auto participant = participantId(session);
  Statement last(
      database_, "SELECT coalesce(max(number), 0) FROM session WHERE participant_id = ?");
  last.bindAll(participant);
  last.step();
  session.number = static_cast<int>(last.number(0)) + 1;

  Statement insert(
      database_,
      "INSERT INTO session (participant_id, number, protocol_id, run_mode, cohort, language, slot, "
      "slot_state, state, step, attempt, app_version, started_utc, site, station) VALUES "
      "(?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)");
  insert.bindAll(
      participant,
      session.number,
      session.protocol,
      nameOf(session.runMode),
      session.cohort,
      session.language,
      session.slot,
      nameOf(session.slotState),
      study::nameOf(session.state),
      session.step,
      session.attempt,
      appVersion,
      session.startedUtc,
      session.site,
      session.station);
  insert.run();
  session.id = SessionId{database_.lastInsertedId()};
  addSteps(session, steps);
}

void SessionRepository::addSteps(const SessionRow& session, const std::vector<Step>& steps) {
  const auto id = static_cast<std::int64_t>(session.id);
  // Simulated sessions need no blinding and can be reproduced from the seed, so they are not
  // sealed.
  const auto* key = session.runMode == RunMode::Simulated ? nullptr : database_.key();
  Statement insert(
      database_,
      "INSERT INTO step (session_id, step, kind, phase, instrument, item_set, position, label) "
      "VALUES (?,?,?,?,?,?,?,?)");
  std::int64_t number = 0;
  for (const auto& step : steps) {
    insert.bindAll(
        id,
        number,
        study::nameOf(step.kind),
        step.phase,
        step.instrument,
        step.itemSet,
        step.position,
        step.label);
    insert.run();
    if (!step.condition.empty()) addCondition(database_, session.id, number, step.condition, key);
    ++number;
  }
}

void SessionRepository::update(const SessionRow& session) {
  Statement update(
      database_,
      "UPDATE session SET language = ?, slot_state = ?, state = ?, step = ?, attempt = ?, "
      "ended_utc = ?, end_reason = ? WHERE id = ?");
  update.bindAll(
      session.language,
      nameOf(session.slotState),
      study::nameOf(session.state),
      session.step,
      session.attempt,
      session.endedUtc,
      session.endReason,
      session.id);
  update.run();
}

SessionRow SessionRepository::load(SessionId id) const {
  Statement select(database_, selectSessions(database_) + "WHERE s.id = ?");
  select.bindAll(id);
  if (!select.step()) {
    throw StorageError(
        "There is no session " + std::to_string(static_cast<std::int64_t>(id)) + ".");
  }
  return sessionIn(select);
}

std::vector<SessionRow> SessionRepository::all() const {
  Statement select(database_, selectSessions(database_) + "ORDER BY s.id");
  std::vector<SessionRow> sessions;
  while (select.step()) sessions.push_back(sessionIn(select));
  return sessions;
}

void SessionRepository::openVisit(const VisitKey& visit, const std::string& utc) {
  Statement insert(
      database_,
      "INSERT INTO visit (session_id, step, attempt, status, began_utc) VALUES (?, ?, ?, 'open', "
      "?)");
  insert.bindAll(visit, utc);
  insert.run();
}

void SessionRepository::closeVisit(
    const VisitKey& visit, VisitStatus status, const std::string& utc, const std::string& reason) {
  Statement update(
      database_,
      "UPDATE visit SET status = ?, ended_utc = ?, reason = ? "
      "WHERE session_id = ? AND step = ? AND attempt = ? AND status = 'open'");
  update.bindAll(nameOf(status), utc, reason, visit);
  update.run();
}

int SessionRepository::attempts(SessionId session, int step) const {
  Statement select(
      database_, "SELECT coalesce(max(attempt), 0) FROM visit WHERE session_id = ? AND step = ?");
  select.bindAll(session, step);
  select.step();
  return static_cast<int>(select.number(0));
}

VisitStatus SessionRepository::statusOf(const VisitKey& visit) const {
  Statement select(
      database_, "SELECT status FROM visit WHERE session_id = ? AND step = ? AND attempt = ?");
  select.bindAll(visit);
  return select.step() ? requireKnown(visitStatusNamed(select.text(0)), select.text(0))
                       : VisitStatus::Open;
}

void SessionRepository::markRepeated(
    SessionId session, int step, const std::string& utc, const std::string& reason) {
  Statement update(
      database_,
      "UPDATE visit SET status = 'repeated', ended_utc = coalesce(ended_utc, ?), reason = ? "
      "WHERE session_id = ? AND step >= ? AND status IN ('open', 'finished', 'skipped')");
  update.bindAll(utc, reason, session, step);
  update.run();
}

bool SessionRepository::isSealed(SessionId session) const {
  Statement open(
      database_,
      std::string("SELECT 1 FROM allocation AS a WHERE session_id = ? AND ") +
          sealedColumn(database_) + " IS NULL");
  return !open.bindAll(session).step();
}

void addCondition(
    Database& study,
    SessionId session,
    std::int64_t step,
    const std::string& condition,
    const SealingKey* key) {
  Statement insert(
      study, "INSERT INTO allocation (session_id, step, condition, sealed) VALUES (?,?,?,?)");
  if (key == nullptr) {
    insert.bindAll(session, step, condition).run();
  } else {
    const auto sealed = sealCondition(*key, session, static_cast<int>(step), condition);
    insert.bindAll(session, step, "", sealed).run();
  }
}

std::vector<std::pair<int, std::string>> allocationOf(const Database& study, SessionId session) {
  Statement select(
      study,
      std::string("SELECT step, condition, ") + sealedColumn(study) +
          " FROM allocation AS a WHERE session_id = ? ORDER BY step");
  select.bindAll(session);
  std::vector<std::pair<int, std::string>> result;
  while (select.step()) {
    const int step = static_cast<int>(select.number(0));
    const auto sealed = select.blob(2);
    result.emplace_back(
        step,
        sealed.empty() ? select.text(1) : openCondition(requireKey(study), session, step, sealed));
  }
  return result;
}

}  // namespace study::storage

#include "study/storage/content_hash.h"

#include <array>
#include <optional>
#include <vector>

#include "study/storage/statement.h"

namespace study::storage {
namespace {

// The columns are listed in a fixed order, so that a column that a later format adds does not
// change hashes of older formats. Every value is hashed exactly, with its type.
constexpr std::array kSessionQueries{
    "SELECT p.id, p.code, p.cohort, p.run_mode, p.created_utc FROM participant AS p "
    "JOIN session AS s ON s.participant_id = p.id WHERE s.id = ?",
    "SELECT id, participant_id, number, protocol_id, run_mode, cohort, language, slot, slot_state, "
    "state, step, attempt, app_version, started_utc, ended_utc, end_reason "
    "FROM session WHERE id = ?",
    "SELECT step, kind, phase, instrument, item_set, position, label FROM step "
    "WHERE session_id = ? ORDER BY step",
    "SELECT step, condition FROM allocation WHERE session_id = ? ORDER BY step",
    "SELECT step, attempt, status, began_utc, ended_utc, reason FROM visit "
    "WHERE session_id = ? ORDER BY step, attempt",
    "SELECT step, attempt, item, item_order, kind, point, number, text, first_touch_s, response_s, "
    "changes, language, saved_utc FROM answer WHERE session_id = ? ORDER BY step, attempt, item",
    "SELECT step, attempt, device, ending, verdict, verdict_reason, force_unit, travel_unit, "
    "duration_s, ticks, nominal_rate_hz, achieved_rate_hz, lateness_p50_us, lateness_p99_us, "
    "lateness_max_us, late_ticks, lost_samples, invalid_ticks, saturated_s, slewed_s, undefined_s, "
    "contact_s, largest_force_n, cuts, trace_samples FROM trial "
    "WHERE session_id = ? ORDER BY step, attempt",
    "SELECT step, attempt, number, interception_travel, interception_n, yield_travel, yield_n, "
    "bottom_out_travel, bottom_out_n, opening_travel, opening_n, peak_n FROM cut "
    "WHERE session_id = ? ORDER BY step, attempt, number"};

constexpr std::array kStudyQueries{
    "SELECT id, uuid, seed, random_version, app_version, created_utc FROM study ORDER BY id",
    "SELECT id, sha256, reason, added_utc, frozen_utc FROM protocol ORDER BY id",
    "SELECT protocol_id, name, sha256 FROM protocol_file ORDER BY protocol_id, name"};

/// Hashed only if the session has such rows, so that hashes of sessions of older formats stay the
/// same.
constexpr const char* kSealedConditions =
    "SELECT step, sealed FROM allocation WHERE session_id = ? AND sealed IS NOT NULL ORDER BY step";
constexpr const char* kSealedTrials =
    "SELECT step, attempt, sealed FROM trial WHERE session_id = ? AND sealed IS NOT NULL "
    "ORDER BY step, attempt";
constexpr const char* kWrappedKey = "SELECT salt, operations, memory, sealed FROM wrapped_key";

/// Hashed only if there are such rows, so that hashes of studies of older formats stay the same.
/// finished_utc is left out, because the trail has no event for it.
constexpr const char* kErasures =
    "SELECT id, participant, level, reason, erased_utc FROM erasure ORDER BY id";

bool hasFormatOfSealedConditions(const Database& database) {
  return database.hasTable("wrapped_key");
}

bool hasRows(const Database& database, const char* select, SessionId session) {
  Statement rows(database, select);
  return rows.bindAll(session).step();
}

/// The statements on sealed data that return rows for a session.
std::vector<const char*> sealedParts(const Database& database, SessionId session) {
  std::vector<const char*> parts;
  if (hasFormatOfSealedConditions(database) && hasRows(database, kSealedConditions, session)) {
    parts.push_back(kSealedConditions);
  }
  if (database.hasColumn("trial", "sealed") && hasRows(database, kSealedTrials, session)) {
    parts.push_back(kSealedTrials);
  }
  return parts;
}

bool hasWrappedKey(const Database& database) {
  return hasFormatOfSealedConditions(database) && Statement(database, kWrappedKey).step();
}

/// Hashed only if the session has a station, so that hashes of other sessions stay the same.
constexpr const char* kSessionStationQuery =
    "SELECT site, station FROM session WHERE id = ? AND station <> ''";

bool wasAnyoneErased(const Database& database) {
  return database.hasTable("erasure") && Statement(database, "SELECT 1 FROM erasure").step();
}

/// Adds separators between rows and after the last one, so that moving a value to another row or
/// table changes the hash.
/// @param session  whose rows are selected; std::nullopt: the statement has no parameter
void addRows(
    Hasher& hasher,
    const Database& database,
    const char* select,
    std::optional<SessionId> session = std::nullopt) {
  Statement rows(database, select);
  if (session) rows.bindAll(*session);
  while (rows.step()) {
    hasher.add("row");
    for (int column = 0; column < rows.columnCount(); ++column) {
      hasher.add(rows.exactBytes(column));
    }
  }
  hasher.add("end");
}

void addStation(const Database& database, SessionId session, Hasher& hasher) {
  // A file of an older format that was opened for reading only lacks the column `station`.
  if (!database.hasColumn("session", "station")) return;
  Statement row(database, kSessionStationQuery);
  row.bindAll(session);
  if (!row.step()) return;
  hasher.add("station");
  hasher.add(row.exactBytes(0));
  hasher.add(row.exactBytes(1));
}

}  // namespace

Hash contentHash(const Database& database, SessionId session, const SealingKey* key) {
  Hasher hasher;
  for (const char* select : kSessionQueries) addRows(hasher, database, select, session);
  for (const char* select : sealedParts(database, session)) {
    addRows(hasher, database, select, session);
  }
  addStation(database, session, hasher);
  return key == nullptr ? hasher.finish() : hasher.finish(key->hashingKey());
}

Hash contentHash(const Database& database) {
  Hasher hasher;
  for (const char* select : kStudyQueries) addRows(hasher, database, select);
  if (wasAnyoneErased(database)) addRows(hasher, database, kErasures);
  if (hasWrappedKey(database)) addRows(hasher, database, kWrappedKey);
  return hasher.finish();
}

}  // namespace study::storage

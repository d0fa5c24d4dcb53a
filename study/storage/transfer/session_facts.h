#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "study/model/ids.h"
#include "study/storage/database.h"
#include "study/storage/named_rows.h"

namespace study::storage {

/// All rows of one session, without the row numbers of one file, so that they are equal in every
/// study that contains the session. By table: participant, session (one row each), step,
/// allocation, visit, answer, trial, cut. The session refers to its protocol by hash.
using SessionTables = std::map<std::string, std::vector<NamedRow>>;

/// The rows of a table. @throws StorageError  if there is no such table.
const std::vector<NamedRow>& rowsIn(const SessionTables& facts, std::string_view table);

/// A text in the first row of a table; empty if the table has no row.
std::string textIn(const SessionTables& facts, const std::string& table, const std::string& column);

/// The rows of a session. Conditions and measurements are unsealed, even if they are sealed in this
/// file.
/// @throws StorageError  if there is no such session, or if the key is needed but not available.
SessionTables sessionTablesOf(const Database& study, SessionId session);

/// Adds a session from another file; adds its participant if no participant has that code. If the
/// study has its key, conditions and measurements are sealed, except for simulated sessions. Inside
/// the caller's transaction.
/// @throws StorageError  if the session's protocol is missing, or if rows or columns are not in the
///     form that this program knows.
SessionId addSessionTables(Database& study, const SessionTables& facts);

/// Like addSessionTables(), but the session keeps its number @p session in the other file, so that
/// its rows can be compared with the audit trail of that file.
/// @param key  with which conditions and measurements are sealed in the other file; nullptr: they
///     are not sealed
/// @param openTrials  trials whose measurements an earlier release stored unsealed in the other
///     file
void addSessionTablesAs(
    Database& study,
    const SessionTables& facts,
    SessionId session,
    const SealingKey* key,
    const std::set<VisitKey>& openTrials);

/// The last event of a session in the audit trail.
struct LastSessionEvent {
  SessionId session{};
  std::string participant;  ///< code
  std::int64_t lastEvent = 0;
  std::string utc;           ///< of that event
  bool isSimulated = false;  ///< its times are virtual
};

/// The last event of each session, in the order of the sessions' numbers.
std::vector<LastSessionEvent> lastSessionEvents(const Database& study);

}  // namespace study::storage

#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "study/model/ids.h"
#include "study/storage/database.h"
#include "study/storage/fact_rows.h"

namespace study::storage {

/// All that the tables say of one session, without the numbers that they have in one file: the same
/// in every study that holds the session. By table: participant, session (one row each), step,
/// allocation, visit, answer, trial, cut. The session names its protocol by hash.
using SessionFacts = std::map<std::string, std::vector<FactRow>>;

/// The rows of a table. @throws StorageError  if there is no such table.
const std::vector<FactRow>& rowsIn(const SessionFacts& facts, std::string_view table);

/// A text of the first row of a table; empty if there is none.
std::string textIn(const SessionFacts& facts, const std::string& table, const std::string& column);

/// Conditions and measurements are in the open, whether or not they are sealed in this file.
/// @throws StorageError  if there is no such session, or the key of what is sealed is not here.
SessionFacts factsOf(const Database& study, SessionId session);

/// Adds a session that came from another file, with a participant if there is none of the code.
/// Conditions and measurements are sealed if the study has its key, but for simulated sessions.
/// Inside the caller's transaction.
/// @throws StorageError  if its protocol is not there, or a row or column is not as this program
///     knows it.
SessionId addFacts(Database& study, const SessionFacts& facts);

/// Like addFacts(), but the session keeps the number @p session of the file that it comes from, so
/// that its rows can be compared with the audit trail of that file.
/// @param key  with which conditions and measurements are sealed there; nullptr: they are not
/// @param openTrials  trials whose measurements are not sealed there: an earlier program wrote them
void addFactsAs(
    Database& study,
    const SessionFacts& facts,
    SessionId session,
    const SealingKey* key,
    const std::set<VisitKey>& openTrials);

/// The last event of a session in the audit trail.
struct LastSessionEvent {
  SessionId session{};
  std::string participant;  ///< code
  std::int64_t lastEvent = 0;
  std::string utc;  ///< of that event
};

/// The last event of each session, in the order of the sessions' numbers.
std::vector<LastSessionEvent> lastSessionEvents(const Database& study);

}  // namespace study::storage

#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "study/model/ids.h"
#include "study/storage/database.h"

namespace study::storage {

/// A value of a column.
using FactValue = std::variant<std::monostate, std::int64_t, double, std::string>;

/// A row, by the names of its columns.
using FactRow = std::map<std::string, FactValue>;

/// All that the tables say of one session, without the numbers that they have in one file: the same
/// in every study that holds the session. By table: participant, session (one row each), step,
/// allocation, visit, answer, trial, cut. The session names its protocol by hash.
using SessionFacts = std::map<std::string, std::vector<FactRow>>;

/// A text of the first row of a table; empty if there is none.
std::string textIn(const SessionFacts& facts, const std::string& table, const std::string& column);

/// The conditions are in the open, whether or not they are sealed in this file.
/// @throws StorageError  if there is no such session, or the key of its conditions is not here.
SessionFacts factsOf(const Database& study, SessionId session);

/// Adds a session that came from another file, with a participant if there is none of the code.
/// Inside the caller's transaction.
/// @throws StorageError  if its protocol is not there, or a row or column is not as this program
///     knows it.
SessionId addFacts(Database& study, const SessionFacts& facts);

/// The same with the number that the session has in the file that it comes from, to be compared
/// with what the audit trail of that file says. @param key  with which its conditions are sealed
/// there; nullptr: they are not
void addFactsAs(
    Database& study, const SessionFacts& facts, SessionId session, const SealingKey* key);

/// Raw chunks of samples, to be written to another file as they are.
struct TraceChunk {
  int step = 0;
  int attempt = 1;
  std::int64_t number = 0;
  std::int64_t samples = 0;
  std::int64_t layout = 0;
  std::vector<std::byte> data;
  std::vector<std::byte> hash;
};

/// The chunks of a visit, in order. @param traces  traces.db
std::vector<TraceChunk> chunksOf(const Database& traces, const VisitKey& visit);

/// Inside the caller's transaction. @throws StorageError  if the bytes are not those of the hash.
void addChunk(Database& traces, SessionId session, const TraceChunk& chunk);

/// How far the audit trail speaks of a session.
struct SessionMark {
  SessionId session{};
  std::string participant;  ///< code
  std::int64_t lastEvent = 0;
  std::string utc;  ///< of that event
};

/// Of all sessions, in the order of their numbers.
std::vector<SessionMark> sessionMarks(const Database& study);

}  // namespace study::storage

#include "study/storage/erasure/erased_rows.h"

#include <array>

#include "study/storage/statement.h"

namespace study::storage {
namespace {

void runFor(Database& database, const char* sql, SessionId session) {
  Statement statement(database, sql);
  statement.bindAll(session);
  statement.run();
}

/// Empties the write-ahead log. Other programs usually read for moments only; one that keeps its
/// snapshot is reported as an error, because the pages that it still sees cannot be removed.
void emptyLog(Database& database) {
  Statement checkpoint(database, "PRAGMA wal_checkpoint(TRUNCATE)");
  if (checkpoint.step() && checkpoint.number(0) == 0) return;
  throw StorageError(
      "What was erased cannot be removed from " + database.path() +
          " while another program reads it. Close it there. Then open the study again: the rest is "
          "done at once.",
      StorageError::Kind::Busy);
}

}  // namespace

std::int64_t eraseAnswers(Database& study, SessionId session, const std::string& utc) {
  Statement count(study, "SELECT count(*) FROM answer WHERE session_id = ?");
  count.bindAll(session);
  count.step();
  const auto answers = count.number(0);
  count.reset();
  // A table comes before those that its foreign keys refer to.
  constexpr std::array kDeletions{
      "DELETE FROM answer WHERE session_id = ?",
      "DELETE FROM cut WHERE session_id = ?",
      "DELETE FROM trial WHERE session_id = ?",
      "DELETE FROM visit WHERE session_id = ?",
      "DELETE FROM lease WHERE session_id = ?"};
  for (const char* sql : kDeletions) runFor(study, sql, session);
  Statement update(
      study,
      "UPDATE session SET state = 'erased', slot_state = 'released', end_reason = NULL, "
      "ended_utc = coalesce(ended_utc, ?2) WHERE id = ?1");
  update.bindAll(session, utc);
  update.run();
  return answers;
}

void eraseTraces(Database& traces, const std::vector<SessionId>& sessions) {
  traces.execute("PRAGMA secure_delete = ON");
  Transaction transaction(traces);
  for (const auto session : sessions) {
    runFor(traces, "DELETE FROM chunk WHERE session_id = ?", session);
  }
  transaction.commit();
}

std::vector<std::string> textsAbout(const Database& study, const std::string& participant) {
  Statement select(
      study,
      "WITH theirs AS (SELECT s.id FROM session AS s JOIN participant AS p "
      "  ON p.id = s.participant_id WHERE p.code = ?), "
      "said AS ("
      "  SELECT session_id AS session, text FROM answer WHERE kind = 'text' "
      "  UNION ALL SELECT session_id, reason FROM visit WHERE reason <> '' "
      "  UNION ALL SELECT id, end_reason FROM session WHERE end_reason <> '') "
      "SELECT DISTINCT text FROM said WHERE session IN theirs "
      "EXCEPT SELECT text FROM said WHERE session NOT IN theirs");
  select.bindAll(participant);
  std::vector<std::string> texts;
  while (select.step()) texts.push_back(select.text(0));
  return texts;
}

bool hasUnsealedEvents(const Database& study, SessionId session) {
  // A file of an older format that was opened for reading only has no column `sealed` and no sealed
  // events.
  const std::string sealed = study.hasTable("erasure") ? "sealed" : "NULL";
  Statement select(
      study,
      "SELECT 1 FROM event WHERE session_id = ? AND " + sealed +
          " IS NULL AND kind <> 'erased' LIMIT 1");
  select.bindAll(session);
  return select.step();
}

void purge(Database& database) {
  emptyLog(database);
  database.execute("VACUUM");
  emptyLog(database);
}

}  // namespace study::storage

#include "study/storage/completed_sessions.h"

#include "study/model/session_state.h"

namespace study::storage {

CompletedSessions::CompletedSessions(Database& database, RunMode mode, SessionId first)
    : select_(
          database,
          "SELECT id, cohort FROM session INDEXED BY sessions_by_outcome "
          "WHERE run_mode = ? AND state = ? AND id >= ? ORDER BY id") {
  select_.bind(1, nameOf(mode)).bind(2, nameOf(SessionState::Completed));
  select_.bind(3, static_cast<std::int64_t>(first));
}

bool CompletedSessions::next() {
  if (isAtEnd_ || !select_.step()) {
    isAtEnd_ = true;
    return false;
  }
  id_ = SessionId{select_.number(0)};
  cohort_ = select_.text(1);
  return true;
}

bool CompletedSessions::isThere(SessionId session) {
  while (id_ < session && next()) {
  }
  return id_ == session;
}

}  // namespace study::storage

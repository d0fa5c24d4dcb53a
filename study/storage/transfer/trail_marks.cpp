#include "study/storage/transfer/trail_marks.h"

#include "study/storage/statement.h"

namespace study::storage {

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

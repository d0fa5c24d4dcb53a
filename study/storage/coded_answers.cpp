#include "study/storage/coded_answers.h"

#include <exception>

#include <sqlite3.h>

#include "study/storage/statement.h"

namespace study::storage {
namespace {

// A function of our own sees each row from within SQLite's loop: handing every row out through a
// statement takes twice the time (docs/decisions/0012).
constexpr const char* kVisit = "palpate_visit";
constexpr const char* kVisitAll =
    "SELECT palpate_visit(session_id, question, point) "
    "FROM answer INDEXED BY answers_to_be_counted "
    "WHERE point IS NOT NULL AND session_id >= ? AND session_id < ?";

struct Visiting {
  const CodedAnswers::Visitor& visitor;
  std::exception_ptr failure;
};

/// Called by SQLite: nothing may be thrown through it.
void visitRow(sqlite3_context* context, int, sqlite3_value** values) noexcept {
  auto& visiting = *static_cast<Visiting*>(sqlite3_user_data(context));
  if (visiting.failure) return;
  try {
    visiting.visitor(
        {.session = SessionId{sqlite3_value_int64(values[0])},
         .question = sqlite3_value_int64(values[1]),
         .point = sqlite3_value_int64(values[2])});
  } catch (...) {
    visiting.failure = std::current_exception();
    sqlite3_result_error_code(context, SQLITE_ABORT);
  }
}

void hasVisited(sqlite3_context* context) noexcept {
  sqlite3_result_null(context);
}

/// Makes the function known to a connection for as long as it lives.
class VisitFunction {
 public:
  VisitFunction(Database& database, Visiting& visiting) : database_(database) {
    const int code = sqlite3_create_function_v2(
        database.handle(),
        kVisit,
        3,
        SQLITE_UTF8 | SQLITE_DIRECTONLY,
        &visiting,
        nullptr,
        visitRow,
        hasVisited,
        nullptr);
    if (code != SQLITE_OK) database.fail(code, "read");
  }
  ~VisitFunction() {
    sqlite3_create_function_v2(
        database_.handle(), kVisit, 3, SQLITE_UTF8, nullptr, nullptr, nullptr, nullptr, nullptr);
  }
  VisitFunction(const VisitFunction&) = delete;
  VisitFunction& operator=(const VisitFunction&) = delete;

 private:
  Database& database_;
};

}  // namespace

std::vector<Question> CodedAnswers::questionsAfter(std::int64_t known) const {
  Statement select(
      database_,
      "SELECT id, kind, phase, instrument, condition, item FROM question WHERE id > ? ORDER BY id");
  select.bind(1, known);
  std::vector<Question> questions;
  while (select.step()) {
    questions.push_back(
        {.id = select.number(0),
         .kind = select.text(1),
         .phase = select.text(2),
         .instrument = select.text(3),
         .condition = select.text(4),
         .item = select.text(5)});
  }
  return questions;
}

SessionId CodedAnswers::lastSession() const {
  Statement select(database_, "SELECT coalesce(max(id), 0) FROM session");
  select.step();
  return SessionId{select.number(0)};
}

void CodedAnswers::visitAll(const Visitor& visitor, const SessionRange& sessions) const {
  Visiting visiting{visitor, nullptr};
  const VisitFunction function(database_, visiting);
  try {
    Statement select(database_, kVisitAll);
    select.bind(1, static_cast<std::int64_t>(sessions.first));
    select.bind(2, static_cast<std::int64_t>(sessions.end));
    select.run();
  } catch (const StorageError&) {
    if (!visiting.failure) throw;
  }
  if (visiting.failure) std::rethrow_exception(visiting.failure);
}

void CodedAnswers::visitFinished(SessionId session, const Visitor& visitor) const {
  Statement select(
      database_,
      "SELECT x.question, x.point FROM answer AS x JOIN visit AS v ON v.session_id = x.session_id "
      "AND v.step = x.step AND v.attempt = x.attempt "
      "WHERE x.session_id = ? AND x.point IS NOT NULL AND v.status = 'finished'");
  select.bind(1, static_cast<std::int64_t>(session));
  while (select.step()) {
    visitor({.session = session, .question = select.number(0), .point = select.number(1)});
  }
}

std::vector<SessionId> CodedAnswers::sessionsWithMore() const {
  Statement select(
      database_,
      "SELECT DISTINCT session_id FROM visit INDEXED BY visits_that_do_not_count "
      "WHERE status <> 'finished' ORDER BY session_id");
  std::vector<SessionId> sessions;
  while (select.step()) sessions.push_back(SessionId{select.number(0)});
  return sessions;
}

std::vector<std::string> CodedAnswers::misplaced() const {
  Statement select(
      database_,
      "SELECT x.item, x.session_id, x.step + 1, x.attempt FROM answer AS x "
      "JOIN step AS s ON s.session_id = x.session_id AND s.step = x.step "
      "LEFT JOIN allocation AS a ON a.session_id = x.session_id AND a.step = x.step "
      "LEFT JOIN question AS q ON q.id = x.question "
      "WHERE q.id IS NULL OR q.kind <> s.kind OR q.phase <> s.phase OR q.item <> x.item "
      "OR q.instrument <> s.instrument OR q.condition <> coalesce(a.condition, '')");
  std::vector<std::string> found;
  while (select.step()) {
    found.push_back(
        select.text(0) + " (session " + select.text(1) + ", step " + select.text(2) + ", attempt " +
        select.text(3) + ")");
  }
  return found;
}

}  // namespace study::storage

// What the tables themselves refuse, as the last check against our own mistakes.
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/study/made_study.h"
#include "tests/study/storage/sql.h"
#include "tests/study/walk.h"
#include "tests/support/test_data.h"

namespace study {
namespace schema_test {

class SchemaTest : public testing::Test {
 protected:
  void SetUp() override {
    {
      auto session = Session::enrol(*study_, {.cohort = "surgeons"});
      tests::walkToTheEnd(session);
    }
    study_.close();
    sql_.emplace(study_.file("study.db"));
    sql_->run("PRAGMA foreign_keys = ON");
  }

  void expectRefused(const std::string& refused) { EXPECT_TRUE(sql_->refuses(refused)) << refused; }
  /// The control of a refusal: without the mistake the statement is accepted.
  void expectAllowed(const std::string& allowed) {
    EXPECT_FALSE(sql_->refuses("SAVEPOINT s; " + allowed + "; ROLLBACK TO s; RELEASE s"))
        << allowed;
  }

  tests::MadeStudy study_;
  std::optional<tests::Sql> sql_;
};

/// The words of a source: names of columns among them.
std::set<std::string> wordsIn(const std::string& source) {
  std::ifstream file(tests::repository() / source);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const std::regex word("\\w+");
  return {std::sregex_token_iterator(text.begin(), text.end(), word), {}};
}

TEST_F(SchemaTest, HasNoColumnOfASessionThatItsHashOrItsTransferLeavesOut) {
  // It follows from other columns: of the step, its allocation and the item.
  const std::set<std::string> kLeftOut{"answer.question"};
  // What travels of a trial and of its cuts are the columns of its repository.
  const std::map<std::string, std::vector<std::string>> kSources{
      {"hash", {"study/storage/content_hash.cpp"}},
      {"transfer",
       {"study/storage/transfer/session_facts.cpp", "study/storage/trial_repository.h"}}};
  for (const auto& [purpose, sources] : kSources) {
    std::set<std::string> named;
    for (const auto& source : sources) named.merge(wordsIn(source));
    for (const std::string table :
         {"participant", "session", "step", "allocation", "visit", "answer", "trial", "cut"}) {
      const std::string columns = " FROM pragma_table_info('" + table + "')";
      const auto count = sql_->number("SELECT count(*)" + columns);
      EXPECT_GT(count, 0) << table;
      for (std::int64_t i = 0; i < count; ++i) {
        const auto column =
            sql_->text("SELECT name" + columns + " WHERE cid = " + std::to_string(i));
        if (kLeftOut.contains(table + "." + column)) continue;
        EXPECT_TRUE(named.contains(column)) << purpose << ": " << table << "." << column;
      }
    }
  }
}

TEST_F(SchemaTest, RefusesASecondAnswerToTheSameQuestion) {
  const std::string copy =
      "INSERT INTO answer SELECT session_id, step, attempt, item, item_order, kind, point, number, "
      "text, first_touch_s, response_s, changes, language, saved_utc, NULL FROM answer LIMIT 1";
  expectRefused(copy);
}

TEST_F(SchemaTest, RefusesAnAnswerWithTwoTypesOrNone) {
  const auto answer = [](const std::string& values) {
    return "INSERT INTO answer VALUES (1, 0, 1, 'new', 1, " + values + ", 0, 0, 0, 'en', '', NULL)";
  };
  expectAllowed(answer("'point', 3, NULL, NULL"));
  expectRefused(answer("'point', NULL, NULL, NULL"));
  expectRefused(answer("'point', 3, 3.0, NULL"));
  expectRefused(answer("'point', 3, NULL, 'three'"));
  expectRefused(answer("'number', NULL, NULL, NULL"));
  expectRefused(answer("'text', NULL, NULL, NULL"));
  expectRefused(answer("'colour', 3, NULL, NULL"));
  expectRefused(answer("'point', 'three', NULL, NULL"));
}

TEST_F(SchemaTest, RefusesAnAnswerWithoutAVisit) {
  expectRefused(
      "INSERT INTO answer VALUES (1, 77, 1, 'new', 1, 'point', 3, NULL, NULL, 0, 0, 0, 'en', '', "
      "NULL)");
  expectRefused(
      "INSERT INTO answer VALUES (9, 0, 1, 'new', 1, 'point', 3, NULL, NULL, 0, 0, 0, 'en', '', "
      "NULL)");
}

TEST_F(SchemaTest, RefusesImpossibleTimes) {
  const auto answer = [](const std::string& times) {
    return "INSERT INTO answer VALUES (1, 0, 1, 'new', 1, 'point', 3, NULL, NULL, " + times +
           ", 'en', '', NULL)";
  };
  expectAllowed(answer("1.0, 1.0, 0"));
  expectRefused(answer("-0.1, 1.0, 0"));
  expectRefused(answer("2.0, 1.0, 0"));
  expectRefused(answer("1.0, 1.0, -1"));
}

TEST_F(SchemaTest, RefusesAnUnknownRunModeSlotStateVisitStatusAndVerdict) {
  expectRefused("UPDATE participant SET run_mode = 'test'");
  expectRefused("UPDATE session SET run_mode = 'test'");
  expectRefused("UPDATE session SET slot_state = 'lost'");
  expectRefused("UPDATE session SET slot = -1");
  expectRefused("UPDATE visit SET status = 'lost'");
  expectRefused("UPDATE trial SET verdict = 'GOOD'");
}

TEST_F(SchemaTest, RefusesTheSamePlaceTwice) {
  const std::string another =
      "INSERT INTO session (participant_id, number, protocol_id, run_mode, cohort, language, slot, "
      "slot_state, state, step, attempt, app_version, started_utc) "
      "SELECT participant_id, 2, protocol_id, run_mode, cohort, language, ";
  expectRefused(another + "slot, 'reserved', state, step, attempt, '', '' FROM session");
  expectAllowed(another + "slot + 1, 'reserved', state, step, attempt, '', '' FROM session");
  expectAllowed(another + "slot, 'released', state, step, attempt, '', '' FROM session");
}

TEST_F(SchemaTest, RefusesToChangeOrRemoveAnEvent) {
  expectRefused("UPDATE event SET detail = 'nothing happened'");
  expectRefused("DELETE FROM event WHERE seq = 3");
  expectRefused("DELETE FROM event");
  expectRefused("REPLACE INTO event SELECT * FROM event WHERE seq = 3");
  expectRefused(
      "INSERT INTO event SELECT 1000, session_id, step, attempt, utc, monotonic_ns, actor, kind, "
      "detail, hash, content_hash, sealed FROM event WHERE seq = 3");
}

TEST_F(SchemaTest, RefusesToChangeOrRemoveAnErasure) {
  sql_->run(
      "INSERT INTO erasure (participant, level, reason, erased_utc) "
      "SELECT code, 'all', 'a reason', 'now' FROM participant");
  expectAllowed("UPDATE erasure SET finished_utc = 'now'");
  expectRefused("UPDATE erasure SET reason = 'another'");
  expectRefused("DELETE FROM erasure");
  expectRefused(
      "INSERT INTO erasure (participant, level, reason, erased_utc) VALUES ('P009', 'all', '', "
      "'')");
  expectRefused("UPDATE erasure SET level = 'half'");
}

TEST_F(SchemaTest, RefusesToChangeAFrozenProtocol) {
  for (const char* column : {"text", "sha256", "reason", "added_utc"}) {
    expectRefused("UPDATE protocol SET " + std::string(column) + " = 'x'");
  }
  expectRefused("UPDATE protocol SET frozen_utc = NULL");
  expectRefused("UPDATE protocol SET frozen_utc = 'later'");
  expectRefused("DELETE FROM protocol");
  expectRefused(
      "REPLACE INTO protocol SELECT id, 'x', text, reason, added_utc, NULL FROM protocol");
  expectRefused("INSERT INTO protocol_file VALUES (1, 'more.json', 'x', '{}')");
}

TEST_F(SchemaTest, RefusesToChangeTheFilesOfAFrozenProtocol) {
  sql_->run(
      "INSERT INTO protocol (sha256, text, reason, added_utc) VALUES ('x', '{}', '', '');"
      "INSERT INTO protocol_file VALUES (2, 'cut.json', 'x', '{}')");
  expectAllowed("UPDATE protocol_file SET text = '[]' WHERE protocol_id = 2");
  expectAllowed("DELETE FROM protocol_file WHERE protocol_id = 2");
  sql_->run("UPDATE protocol SET frozen_utc = 'now' WHERE id = 2");
  expectRefused("UPDATE protocol_file SET text = '[]'");
  expectRefused("DELETE FROM protocol_file");
  expectRefused("REPLACE INTO protocol_file VALUES (2, 'cut.json', 'y', '[]')");
}

TEST_F(SchemaTest, RefusesValuesOfTheWrongType) {
  expectRefused("UPDATE session SET step = 'three'");
  expectRefused("UPDATE trial SET duration_s = 'long'");
  expectRefused("UPDATE study SET id = 2");
}

TEST_F(SchemaTest, RefusesAnEmptyChunkOfATrace) {
  tests::Sql traces(study_.file("traces.db"));
  EXPECT_TRUE(traces.refuses("INSERT INTO chunk VALUES (1, 1, 1, 0, 0, 1, x'', zeroblob(32))"));
  EXPECT_TRUE(traces.refuses("INSERT INTO chunk VALUES (1, 1, 1, 0, 1, 1, x'', zeroblob(31))"));
  EXPECT_FALSE(traces.refuses("INSERT INTO chunk VALUES (1, 1, 1, 0, 1, 1, x'', zeroblob(32))"));
}

}  // namespace schema_test
}  // namespace study

// Pooled answers: counted from whole numbers as from the rows themselves, and counted on.
#include "study/results/pooled_answers.h"

#include <gtest/gtest.h>

#include "study/results/results.h"
#include "study/session/verification.h"
#include "study/storage/answer_repository.h"
#include "study/storage/statement.h"
#include "tests/study/made_study.h"
#include "tests/study/storage/sql.h"
#include "tests/study/walk.h"

namespace study {
namespace pooled_answers_test {

using Counts = std::vector<std::vector<analysis::LikertCounts>>;

class PooledAnswersTest : public testing::Test {
 protected:
  /// Somebody who answers differently from whoever came before.
  Session begun(const std::string& cohort) {
    auto session = Session::enrol(*study_, {.cohort = cohort});
    tests::walkTo(session, StepKind::Questionnaire);
    return session;
  }

  void answerStep(Session& session) {
    for (const auto& item : session.items()) {
      auto given = tests::answerTo(session, item);
      given.response = std::int64_t{1} + (next_++ * 7 / 3) % 5;
      session.record(given);
    }
    session.finishStep();
  }

  void goOn(Session& session) {
    while (!session.isOver()) {
      session.step().kind == StepKind::Questionnaire ? answerStep(session)
                                                     : tests::passStep(session);
    }
  }

  void takePart(const std::string& cohort) {
    auto session = begun(cohort);
    goOn(session);
  }

  Counts countsOf(const PooledAnswers& pooled) {
    Counts all;
    for (std::size_t cohort = 0; cohort < study_->protocol().protocol.cohorts.size(); ++cohort) {
      all.emplace_back();
      for (const auto& named : pooled.of(0, cohort)) all.back().push_back(named.counts);
    }
    return all;
  }

  Counts countedNow() { return countsOf(PooledAnswers(*study_, RunMode::Live)); }

  /// By the rows themselves, answer by answer.
  Counts countedByRows() {
    const auto results = computeResults(*study_, RunMode::Live);
    Counts all;
    for (const auto& cohort : results.families.at(0).cohorts) {
      all.emplace_back();
      for (std::size_t i = 0; i < cohort.table.methods.size(); ++i) {
        all.back().push_back(cohort.table.countsOf(i));
      }
    }
    return all;
  }

  std::uint64_t total(const Counts& counts) {
    std::uint64_t sum = 0;
    for (const auto& cohort : counts) {
      for (const auto& condition : cohort) sum += condition.total();
    }
    return sum;
  }

  /// Its first answer to item 2.2 becomes the next higher point, or the lowest.
  VisitKey correctAnAnswerOf(std::int64_t session) {
    storage::Statement one(
        study_->database(),
        "SELECT step, attempt FROM answer WHERE item = '2.2' AND session_id = ? LIMIT 1");
    one.bind(1, session);
    if (!one.step()) throw std::runtime_error("there is no such answer");
    const VisitKey visit{
        SessionId{session}, static_cast<int>(one.number(0)), static_cast<int>(one.number(1))};
    one.reset();
    storage::AnswerRepository answers(study_->database());
    auto answer = answers.find(visit, "2.2").value();
    answer.response = std::get<std::int64_t>(answer.response) % 5 + 1;
    study_->transact([&] {
      answers.put(visit, answer, "later");
      study_->events().append(
          {.visit = visit, .kind = "answered", .values = storage::valuesOf(answer)});
    });
    return visit;
  }

  tests::MadeStudy study_{tests::libraryProtocol("punch-face-validity.json"), 1};
  int next_ = 0;
};

TEST_F(PooledAnswersTest, AreThoseOfTheRows) {
  for (const char* cohort : {"professional", "non-professional", "professional"}) takePart(cohort);
  const auto counts = countedNow();
  EXPECT_EQ(total(counts), 3U * 18U);
  EXPECT_EQ(counts, countedByRows());
}

TEST_F(PooledAnswersTest, LeaveOutWhatDoesNotCount) {
  takePart("professional");
  auto repeated = begun("professional");
  answerStep(repeated);
  repeated.repeatStep("the participant asked for it");
  goOn(repeated);
  auto withdrawn = begun("professional");
  answerStep(withdrawn);
  withdrawn.withdraw("had to go");
  begun("non-professional");  // is still answering
  const auto counts = countedNow();
  EXPECT_EQ(total(counts), 2U * 18U);
  EXPECT_EQ(counts, countedByRows());
  EXPECT_EQ(total(countsOf(PooledAnswers(*study_, RunMode::Pilot))), 0U);
}

TEST_F(PooledAnswersTest, GoOnWithWhateverHappens) {
  PooledAnswers pooled(*study_, RunMode::Live);
  EXPECT_FALSE(pooled.refresh());
  auto session = begun("non-professional");
  answerStep(session);
  EXPECT_TRUE(pooled.refresh());
  EXPECT_EQ(total(countsOf(pooled)), 0U);  // it is not over
  goOn(session);
  takePart("professional");
  EXPECT_TRUE(pooled.refresh());
  EXPECT_FALSE(pooled.refresh());
  EXPECT_EQ(total(countsOf(pooled)), 2U * 18U);
  EXPECT_EQ(countsOf(pooled), countedNow());
}

TEST_F(PooledAnswersTest, FollowAnAnswerThatIsCorrected) {
  takePart("professional");
  takePart("non-professional");
  PooledAnswers pooled(*study_, RunMode::Live);
  const auto before = countsOf(pooled);
  const auto visit = correctAnAnswerOf(1);
  EXPECT_TRUE(pooled.refresh());
  EXPECT_NE(countsOf(pooled), before);
  EXPECT_EQ(countsOf(pooled), countedByRows());
  study_->transact([&] {
    storage::AnswerRepository(study_->database()).remove(visit, "2.2");
    study_->events().append({.visit = visit, .kind = "retracted", .detail = "2.2"});
  });
  EXPECT_TRUE(pooled.refresh());
  EXPECT_EQ(countsOf(pooled), countedByRows());
  EXPECT_EQ(total(countsOf(pooled)), 2U * 18U - 1U);
}

TEST_F(PooledAnswersTest, AreTheSameWhenTwoThreadsCountHalfEach) {
  for (int i = 0; i < 5; ++i) takePart(i % 2 == 0 ? "professional" : "non-professional");
  PooledAnswers halves(*study_, RunMode::Live, 1);
  EXPECT_EQ(total(countsOf(halves)), 5U * 18U);
  EXPECT_EQ(countsOf(halves), countedNow());
  // What is corrected in either half, and who comes later.
  correctAnAnswerOf(1);
  correctAnAnswerOf(5);
  takePart("professional");
  EXPECT_TRUE(halves.refresh());
  EXPECT_EQ(countsOf(halves), countedByRows());
  EXPECT_EQ(total(countsOf(halves)), 6U * 18U);
}

TEST_F(PooledAnswersTest, FollowAProtocolThatIsAmended) {
  takePart("professional");
  PooledAnswers pooled(*study_, RunMode::Live);
  const auto before = countsOf(pooled);
  study_->amend(tests::libraryProtocol("punch-face-validity.json"), "once more");
  EXPECT_TRUE(pooled.refresh());
  EXPECT_EQ(countsOf(pooled), before);
}

TEST_F(PooledAnswersTest, AreReadFromTheirIndexAlone) {
  storage::Statement plan(
      study_->database(),
      "EXPLAIN QUERY PLAN SELECT session_id, question, point FROM answer "
      "INDEXED BY answers_to_be_counted WHERE point IS NOT NULL");
  ASSERT_TRUE(plan.step());
  EXPECT_EQ(plan.text(3), "SCAN answer USING COVERING INDEX answers_to_be_counted");
  EXPECT_FALSE(plan.step());
  storage::Statement sessions(
      study_->database(),
      "EXPLAIN QUERY PLAN SELECT id, cohort FROM session INDEXED BY sessions_by_outcome "
      "WHERE run_mode = 'live' AND state = 'completed' ORDER BY id");
  ASSERT_TRUE(sessions.step());
  EXPECT_NE(sessions.text(3).find("COVERING INDEX sessions_by_outcome"), std::string::npos);
  EXPECT_FALSE(sessions.step());
}

TEST_F(PooledAnswersTest, HandOnWhatAVisitorThrows) {
  takePart("professional");
  const storage::CodedAnswers answers(study_->database());
  const auto stop = [](const storage::CodedAnswer&) { throw std::range_error("enough"); };
  EXPECT_THROW(answers.visitAll(stop), std::range_error);
  EXPECT_EQ(total(countedNow()), 18U);
}

TEST_F(PooledAnswersTest, CannotBeTurnedRoundBehindTheProgramsBack) {
  takePart("professional");
  EXPECT_TRUE(verify(*study_).isSound());
  study_.close();
  tests::Sql sql(study_.file("study.db"));
  EXPECT_TRUE(sql.refuses("UPDATE question SET condition = 'kalman'"));
  EXPECT_TRUE(sql.refuses("DELETE FROM question"));
  EXPECT_TRUE(
      sql.refuses("REPLACE INTO question SELECT id, kind, phase, instrument, '', item "
                  "FROM question"));
  EXPECT_TRUE(sql.refuses("UPDATE answer SET question = 1 + question"));
  sql.run("DROP TRIGGER an_answer_keeps_its_question");
  sql.run("UPDATE answer SET question = 1 + question WHERE item = '1.1'");
  study_.reopen();
  std::string problems;
  for (const auto& check : verify(*study_).checks) {
    for (const auto& problem : check.problems) problems += check.what + ": " + problem + "\n";
  }
  EXPECT_NE(problems.find("every answer is counted where it was given"), std::string::npos);
  EXPECT_NE(problems.find("the answer to 1.1 (session 1, step "), std::string::npos) << problems;
}

TEST(CountedSessions, GiveBackWhatTheyWereGiven) {
  using Places = std::vector<CountedSessions::Place>;
  CountedSessions sessions;
  const Places small{0, 1, 127};
  const Places large{128, 16'383, 16'384, 4'294'967'295U, 5};
  sessions.put(SessionId{7}, large);
  sessions.put(SessionId{3}, small);
  sessions.put(SessionId{5}, {});
  EXPECT_THROW(sessions.put(SessionId{3}, small), std::invalid_argument);
  EXPECT_EQ(sessions.take(SessionId{3}), small);
  EXPECT_EQ(sessions.take(SessionId{3}), Places{});
  EXPECT_EQ(sessions.take(SessionId{7}), large);
  sessions.put(SessionId{7}, small);
  EXPECT_EQ(sessions.take(SessionId{7}), small);
  EXPECT_EQ(sessions.take(SessionId{5}), Places{});
}

}  // namespace pooled_answers_test
}  // namespace study

// Pooled answers: how often each point was chosen.
#include "study/results/pooled_results.h"

#include <gtest/gtest.h>

#include "study/results/results.h"
#include "study/storage/answer_repository.h"
#include "study/storage/records.h"
#include "study/storage/statement.h"
#include "tests/study/made_study.h"
#include "tests/study/walk.h"

namespace study {
namespace pooled_results_test {

using Counts = std::vector<std::vector<analysis::LikertCounts>>;

class PooledResultsTest : public testing::Test {
 protected:
  /// A participant at the first questionnaire.
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

  static Counts countsOf(const Results& results) {
    Counts all;
    for (const auto& cohort : results.families.at(0).cohorts) {
      all.emplace_back();
      for (const auto& named : cohort.conditions)
        all.back().push_back(named.answers.points().value());
    }
    return all;
  }

  Counts counted(RunMode mode = RunMode::Live) { return countsOf(pooledResults(*study_, mode)); }

  /// The counts of the full results, which are computed from single answers.
  Counts countedOneByOne() { return countsOf(computeResults(*study_, RunMode::Live)); }

  std::uint64_t total(const Counts& counts) {
    std::uint64_t sum = 0;
    for (const auto& cohort : counts) {
      for (const auto& condition : cohort) sum += condition.total();
    }
    return sum;
  }

  /// Changes the first answer to item 2.2 to the next higher point, or from the highest to the
  /// lowest.
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
          {.visit = visit, .kind = EventKind::Answered, .values = storage::valuesOf(answer)});
    });
    return visit;
  }

  tests::MadeStudy study_{tests::libraryProtocol("punch-face-validity.json"), 1};
  int next_ = 0;
};

TEST_F(PooledResultsTest, CountEveryAnswerOfCompletedSessions) {
  for (const char* cohort : {"professional", "non-professional", "professional"}) takePart(cohort);
  const auto counts = counted();
  EXPECT_EQ(total(counts), 3U * 18U);
  EXPECT_EQ(counts, countedOneByOne());
}

TEST_F(PooledResultsTest, LeaveOutRepeatedStepsAndSessionsThatWereNotCompleted) {
  takePart("professional");
  auto repeated = begun("professional");
  answerStep(repeated);
  repeated.repeatStep("the participant asked for it");
  goOn(repeated);
  auto withdrawn = begun("professional");
  answerStep(withdrawn);
  withdrawn.withdraw("had to go");
  begun("non-professional");  // has not finished answering
  const auto counts = counted();
  EXPECT_EQ(total(counts), 2U * 18U);
  EXPECT_EQ(counts, countedOneByOne());
  EXPECT_EQ(total(counted(RunMode::Pilot)), 0U);
}

TEST_F(PooledResultsTest, CountASessionOnceItIsCompleted) {
  EXPECT_EQ(total(counted()), 0U);
  auto session = begun("non-professional");
  answerStep(session);
  EXPECT_EQ(total(counted()), 0U);
  goOn(session);
  EXPECT_EQ(total(counted()), 18U);
}

TEST_F(PooledResultsTest, CountTheLatestValueOfACorrectedAnswer) {
  takePart("professional");
  takePart("non-professional");
  const auto before = counted();
  const auto visit = correctAnAnswerOf(1);
  EXPECT_NE(counted(), before);
  EXPECT_EQ(counted(), countedOneByOne());
  study_->transact([&] {
    storage::AnswerRepository(study_->database()).remove(visit, "2.2");
    study_->events().append({.visit = visit, .kind = EventKind::Retracted, .detail = "2.2"});
  });
  EXPECT_EQ(counted(), countedOneByOne());
  EXPECT_EQ(total(counted()), 2U * 18U - 1U);
}

TEST_F(PooledResultsTest, CountAnswersToAnEarlierVersionOfTheProtocol) {
  takePart("professional");
  const auto before = counted();
  study_->amend(tests::libraryProtocol("punch-face-validity.json"), "once more");
  EXPECT_EQ(counted(), before);
}

TEST_F(PooledResultsTest, NameTheItemWithEveryCount) {
  takePart("professional");
  const auto counts = storage::Records(study_->database()).pointCounts(RunMode::Live);
  std::uint64_t answers = 0;
  for (const auto& one : counts) {
    EXPECT_EQ(one.cohort, "professional");
    EXPECT_EQ(one.instrument, "punch-face-validity");
    EXPECT_FALSE(one.phase.empty());
    EXPECT_FALSE(one.condition.empty());
    EXPECT_FALSE(one.item.empty());
    EXPECT_TRUE(one.point >= 1 && one.point <= 5);
    answers += one.times;
  }
  EXPECT_EQ(answers, 18U);
}

TEST_F(PooledResultsTest, TestNothingWhereOnePersonAnswered) {
  takePart("professional");
  for (const auto& results :
       {pooledResults(*study_, RunMode::Live), computeResults(*study_, RunMode::Live)}) {
    for (const auto& row : results.families.at(0).cohorts.at(0).comparisons.rows) {
      EXPECT_FALSE(row.p || row.adjusted || row.isSignificant || row.interval);
      EXPECT_EQ(base::describe(row.reason), "the test needs two participants");
      EXPECT_TRUE(row.estimate.value);
    }
  }
  takePart("professional");
  for (const auto& results :
       {pooledResults(*study_, RunMode::Live), computeResults(*study_, RunMode::Live)}) {
    EXPECT_TRUE(results.families.at(0).cohorts.at(0).comparisons.rows.at(0).p);
  }
}

}  // namespace pooled_results_test
}  // namespace study

// A session is resumed at its present step, whenever the program ended.
#include <cmath>
#include <numbers>
#include <span>

#include <gtest/gtest.h>

#include "study/session/verification.h"
#include "study/storage/keys/sealed_condition.h"
#include "study/storage/records.h"
#include "study/storage/statement.h"
#include "tests/study/made_study.h"
#include "tests/study/walk.h"

namespace study {
namespace resume_test {

using storage::StorageError;
using tests::MadeStudy;

class ResumeTest : public testing::Test {
 protected:
  /// The session after an end and restart of the program.
  Session& again() {
    const auto id = session_->id();
    session_.reset();
    study_.reopen();
    session_.emplace(Session::resume(*study_, id));
    return *session_;
  }

  MadeStudy study_;
  std::optional<Session> session_{Session::enrol(*study_, {.cohort = "surgeons"})};
};

TEST_F(ResumeTest, ContinuesAtEveryStep) {
  while (!session_->isOver()) {
    const auto visit = session_->visit();
    const auto state = session_->state();
    auto& resumed = again();
    EXPECT_EQ(resumed.visit(), visit);
    EXPECT_EQ(resumed.state(), state);
    tests::passStep(resumed);
  }
  EXPECT_EQ(session_->state(), SessionState::Completed);
  EXPECT_TRUE(verify(*study_).isSound());
}

TEST_F(ResumeTest, HasTheAnswersThatWereGivenBefore) {
  tests::walkTo(*session_, StepKind::Questionnaire);
  const auto items = session_->items();
  session_->record(tests::answerTo(*session_, items[0], 1));
  const auto before = session_->answers();
  auto& resumed = again();
  EXPECT_EQ(resumed.answers(), before);
  EXPECT_EQ(resumed.missing().size(), items.size() - 1);
}

TEST_F(ResumeTest, CountsARunningTrialAsBrokenOff) {
  tests::walkTo(*session_, StepKind::Trial);
  const auto visit = session_->visit();
  session_->beginTrial();
  study_->traces().add(visit, 0, std::vector<storage::TraceSample>(1000));
  study_->traces().add(visit, 1, std::vector<storage::TraceSample>(1000));
  auto& resumed = again();
  EXPECT_EQ(resumed.state(), SessionState::Interrupted);
  EXPECT_EQ(resumed.visit(), visit);
  const auto trials = storage::Records(study_->database()).trials();
  ASSERT_EQ(trials.size(), 1U);
  EXPECT_EQ(trials[0].ending, TrialEnding::ProgramEnded);
  EXPECT_EQ(trials[0].verdict, Verdict::Fail);
  EXPECT_EQ(trials[0].traceSamples, 2000);
  EXPECT_TRUE(verify(*study_).isSound());
  resumed.repeatStep("the program had ended");
  EXPECT_EQ(resumed.visit(), (VisitKey{visit.session, visit.step, 2}));
}

TEST_F(ResumeTest, CountsInTheStoredSamplesWhatWasFeltBeforeTheProgramEnded) {
  tests::walkTo(*session_, StepKind::Trial);
  session_->beginTrial();
  // A stroke in each second, through tissue that is touched at 4 and cut at 8.
  for (int second = 0; second < 2; ++second) {
    std::vector<storage::TraceSample> samples(1000);
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const double phase = 2.0 * std::numbers::pi * 1e-3 * static_cast<double>(i);
      const double travel = 5.5 - 5.5 * std::cos(phase);
      const bool isCutting = std::sin(phase) >= 0.0 && travel > 4.0 && travel < 8.0;
      samples[i] = {
          .travel = static_cast<float>(travel),
          .force = isCutting ? static_cast<float>(1.2 * (travel - 4.0)) : 0.0F};
    }
    study_->traces().add(session_->visit(), second, samples);
  }
  again();
  const storage::Records records(study_->database());
  const auto trials = records.trials();
  ASSERT_EQ(trials.size(), 1U);
  EXPECT_EQ(trials[0].ending, TrialEnding::ProgramEnded);
  EXPECT_EQ(trials[0].duration, 2.0);
  EXPECT_EQ(trials[0].ticks, 2000);
  EXPECT_EQ(trials[0].cuts, 2);
  EXPECT_GT(trials[0].contact, 0.1);
  EXPECT_EQ(records.cuts().size(), 2U);
  EXPECT_TRUE(verify(*study_).isSound());
}

TEST_F(ResumeTest, StaysInterruptedUntilTheOperatorDecides) {
  tests::walkTo(*session_, StepKind::Trial);
  session_->beginTrial();
  session_->abortTrial({.ending = TrialEnding::DeviceGone});
  EXPECT_EQ(again().state(), SessionState::Interrupted);
  EXPECT_EQ(storage::Records(study_->database()).trials().size(), 1U);
  session_->skipStep("no device");
  EXPECT_EQ(again().step().kind, StepKind::Trial);
}

TEST_F(ResumeTest, StaysPausedAndInItsLanguage) {
  tests::walkTo(*session_, StepKind::Questionnaire);
  session_->setLanguage("nb");
  session_->pause("lunch");
  auto& resumed = again();
  EXPECT_EQ(resumed.state(), SessionState::Paused);
  EXPECT_EQ(resumed.language(), "nb");
  resumed.resumeAfterPause();
  EXPECT_EQ(resumed.step().kind, StepKind::Questionnaire);
}

TEST_F(ResumeTest, HasTheSameAlternativesInTheSameOrder) {
  const auto labels = [](const Session& session) {
    std::string all;
    for (const auto& step : session.plan()) all += step.condition + std::to_string(step.label);
    return all;
  };
  const std::string before = labels(*session_);
  tests::walkTo(*session_, StepKind::Trial);
  EXPECT_EQ(labels(again()), before);
}

TEST_F(ResumeTest, RecordsThatItWasResumedUnlessItIsOver) {
  tests::walkTo(*session_, StepKind::Trial);
  again();
  EXPECT_NE(tests::eventsOf(*study_, session_->id()).find("resumed"), std::string::npos);
  tests::walkToTheEnd(*session_);
  const std::string events = tests::eventsOf(*study_, session_->id());
  EXPECT_TRUE(again().isOver());
  EXPECT_EQ(tests::eventsOf(*study_, session_->id()), events);
}

TEST_F(ResumeTest, RefusesAnOrderThatIsNotTheOneThatWasDrawn) {
  const auto id = session_->id();
  session_.reset();
  // As who has the key could.
  for (const auto& [step, condition] : storage::allocationOf(study_->database(), id)) {
    if (condition != "interpolation") continue;
    const auto sealed = storage::sealCondition(*study_->database().key(), id, step, "kalman");
    storage::Statement update(
        study_->database(), "UPDATE allocation SET sealed = ? WHERE step = ?");
    update.bind(1, std::span(sealed)).bind(2, std::int64_t{step}).run();
  }
  EXPECT_THROW(Session::resume(*study_, id), StorageError);
}

TEST_F(ResumeTest, RefusesAStepThatTheSessionDoesNotHave) {
  const auto id = session_->id();
  session_.reset();
  study_->database().execute("UPDATE session SET step = 400");
  try {
    Session::resume(*study_, id);
    FAIL() << "it was resumed";
  } catch (const StorageError& error) {
    EXPECT_EQ(error.kind(), StorageError::Kind::Damaged);
  }
}

TEST_F(ResumeTest, RefusesASessionThatDoesNotExist) {
  EXPECT_THROW(Session::resume(*study_, SessionId{77}), StorageError);
}

}  // namespace resume_test
}  // namespace study

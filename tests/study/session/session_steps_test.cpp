// The course of a session: steps, trials, and the operator's decisions.
#include <map>

#include <gtest/gtest.h>

#include "study/session/verification.h"
#include "study/storage/records.h"
#include "tests/study/made_study.h"
#include "tests/study/walk.h"

namespace study {
namespace session_steps_test {

using namespace std::string_literals;

using tests::MadeStudy;

class SessionStepsTest : public testing::Test {
 protected:
  /// The statuses of a step's visits in order: "repeated finished".
  std::string visitsOf(int step) {
    std::string all;
    for (int attempt = 1; attempt <= study_->sessions().attempts(session_.id(), step); ++attempt) {
      const auto status = study_->sessions().statusOf({session_.id(), step, attempt});
      all += (all.empty() ? "" : " ") + std::string(nameOf(status));
    }
    return all;
  }

  bool isSound() { return verify(*study_).isSound(); }

  MadeStudy study_;
  Session session_ = Session::enrol(*study_, {.cohort = "surgeons"});
};

TEST_F(SessionStepsTest, FinishesNoStepWhileARequiredAnswerIsMissing) {
  EXPECT_EQ(session_.missing(), std::vector<std::string>{"consent"});
  EXPECT_THROW(session_.finishStep(), UserError);
  tests::answerStep(session_);
  EXPECT_TRUE(session_.missing().empty());
  session_.finishStep();
  EXPECT_EQ(session_.state(), SessionState::Consented);
  EXPECT_EQ(session_.stepIndex(), 1);
}

TEST_F(SessionStepsTest, EndsWithoutATrialWhenConsentIsRefused) {
  auto no = tests::answerTo(session_, session_.items().front());
  no.response = std::string("no");
  session_.record(no);
  session_.finishStep();
  EXPECT_EQ(session_.state(), SessionState::Declined);
  EXPECT_FALSE(session_.allows(SessionEvent::BeganTrial));
  EXPECT_THROW(session_.beginTrial(), UserError);
}

TEST_F(SessionStepsTest, FinishesATrialOnlyAsATrial) {
  tests::walkTo(session_, StepKind::Trial);
  EXPECT_FALSE(session_.allows(SessionEvent::FinishedStep));
  EXPECT_THROW(session_.finishStep(), UserError);
  session_.beginTrial();
  EXPECT_THROW(session_.beginTrial(), UserError);
  EXPECT_THROW(session_.pause(""), UserError);
  EXPECT_THROW(session_.reject(""), UserError);
  session_.finishTrial(tests::feltTrial());
  EXPECT_EQ(session_.step().kind, StepKind::Questionnaire);
}

TEST_F(SessionStepsTest, RefusesToFinishATrialThatBrokeOff) {
  tests::walkTo(session_, StepKind::Trial);
  session_.beginTrial();
  for (const auto ending : {TrialEnding::Stopped, TrialEnding::DeviceGone, TrialEnding::TimedOut}) {
    EXPECT_THROW(session_.finishTrial({.ending = ending}), UserError);
  }
  EXPECT_EQ(session_.state(), SessionState::InTrial);
}

TEST_F(SessionStepsTest, RepeatsTheTrialFromItsQuestions) {
  tests::walkTo(session_, StepKind::Questionnaire);
  const int trial = session_.stepIndex() - 1;
  tests::answerStep(session_);
  const auto before = session_.visit();
  session_.repeatStep("the hand slipped");
  EXPECT_EQ(session_.stepIndex(), trial);
  EXPECT_EQ(session_.visit().attempt, 2);
  EXPECT_EQ(visitsOf(trial), "repeated open");
  EXPECT_EQ(visitsOf(trial + 1), "repeated");
  tests::passStep(session_);
  // those of the new attempt …
  EXPECT_TRUE(session_.answers().empty());
  EXPECT_FALSE(storage::Records(study_->database()).answers().empty());  // … the old ones are kept
  EXPECT_NE(session_.visit(), before);
  tests::walkToTheEnd(session_);
  EXPECT_EQ(visitsOf(trial), "repeated finished");
  EXPECT_TRUE(isSound());
}

TEST_F(SessionStepsTest, RepeatsTheQuestionsBeforeATrial) {
  tests::walkTo(session_, StepKind::Questionnaire);
  const int questions = session_.stepIndex();
  tests::passStep(session_);
  ASSERT_EQ(session_.step().kind, StepKind::Trial);
  session_.repeatStep("wants to correct something");
  EXPECT_EQ(session_.stepIndex(), questions);
}

TEST_F(SessionStepsTest, RepeatsATrialThatBrokeOff) {
  tests::walkTo(session_, StepKind::Trial);
  const int trial = session_.stepIndex();
  session_.beginTrial();
  session_.abortTrial({.ending = TrialEnding::DeviceGone});
  EXPECT_EQ(session_.state(), SessionState::Interrupted);
  EXPECT_THROW(session_.beginTrial(), UserError);
  session_.repeatStep("plugged in again");
  EXPECT_EQ(session_.stepIndex(), trial);
  EXPECT_EQ(session_.visit().attempt, 2);
  tests::walkToTheEnd(session_);
  EXPECT_EQ(visitsOf(trial), "broken_off finished");
  EXPECT_EQ(session_.state(), SessionState::Completed);
  EXPECT_TRUE(isSound());
}

TEST_F(SessionStepsTest, SkipsTheQuestionsAboutASkippedTrial) {
  tests::walkTo(session_, StepKind::Trial);
  const int trial = session_.stepIndex();
  session_.beginTrial();
  session_.abortTrial({.ending = TrialEnding::Stopped});
  session_.skipStep("does not want to feel it again");
  EXPECT_EQ(session_.stepIndex(), trial + 2);
  EXPECT_EQ(session_.step().kind, StepKind::Trial);
  EXPECT_EQ(visitsOf(trial), "broken_off");
  EXPECT_EQ(visitsOf(trial + 1), "skipped");
}

TEST_F(SessionStepsTest, RepeatsASkippedTrialAndNotItsQuestions) {
  tests::walkTo(session_, StepKind::Trial);
  const int trial = session_.stepIndex();
  session_.skipStep("a mistake");
  session_.repeatStep("it was a mistake to skip it");
  EXPECT_EQ(session_.stepIndex(), trial);
  EXPECT_EQ(visitsOf(trial), "repeated open");
}

TEST_F(SessionStepsTest, RepeatsQuestionsThatWereSkippedAlone) {
  tests::walkTo(session_, StepKind::Questionnaire);
  const int questions = session_.stepIndex();
  session_.skipStep("the screen went dark");
  session_.repeatStep("it is back");
  EXPECT_EQ(session_.stepIndex(), questions);
}

TEST_F(SessionStepsTest, NeitherSkipsNorRepeatsConsent) {
  EXPECT_FALSE(session_.allows(SessionEvent::SkippedStep));
  EXPECT_THROW(session_.skipStep("in a hurry"), UserError);
  tests::passStep(session_);
  EXPECT_FALSE(session_.allows(SessionEvent::RepeatedStep));
  EXPECT_THROW(session_.repeatStep("again, please"), UserError);
}

/// A consent form with two questions that need a yes, and one that does not.
std::string twoConsents() {
  const std::string asksForConsent = R"("required": true, "consent_option": "yes")";
  const auto question = [](const std::string& id, const std::string& about) {
    return R"({"id": ")" + id + R"(", "type": "single_choice", )" + about + R"(,
        "text": {"en": "Do you agree?", "de": "Sind Sie einverstanden?", "nb": "Samtykker du?"},
        "options": [{"id": "yes", "text": {"en": "Yes", "de": "Ja", "nb": "Ja"}},
                    {"id": "no", "text": {"en": "No", "de": "Nein", "nb": "Nei"}}]})";
  };
  return R"({"$schema": "instrument-1.schema.json", "id": "two-consents", "version": "1",
    "title": {"en": "Consent", "de": "Einwilligung", "nb": "Samtykke"},
    "source": {"citation": "Own wording.", "licence": "CC0-1.0"},
    "languages": ["en", "de", "nb"], "items": [)" +
         question("study", asksForConsent) + "," + question("storage", asksForConsent) + "," +
         question("video", R"("required": false)") + "]}";
}

class TwoConsents
    : public testing::TestWithParam<std::tuple<std::string, std::string, std::string>> {
 protected:
  static std::string protocol() {
    auto json = tests::shortProtocol({.files = R"("two-consents.json")"});
    const std::string shipped = "consent-punch";
    return json.replace(json.find(shipped), shipped.size(), "two-consents");
  }

  MadeStudy study_{tests::protocolFrom(protocol(), {{"two-consents.json", twoConsents()}})};
  Session session_ = Session::enrol(*study_, {.cohort = "surgeons"});
};

TEST_P(TwoConsents, AreBothNeededAndAnOptionalOneIsNot) {
  const auto& [study, storage, video] = GetParam();
  session_.record({.item = "study", .response = std::string(study), .itemOrder = 1});
  session_.record({.item = "storage", .response = std::string(storage), .itemOrder = 2});
  session_.record({.item = "video", .response = std::string(video), .itemOrder = 3});
  session_.finishStep();
  const bool gaveBoth = std::string(study) == "yes" && std::string(storage) == "yes";
  EXPECT_EQ(session_.state(), gaveBoth ? SessionState::Consented : SessionState::Declined);
  EXPECT_EQ(session_.isOver(), !gaveBoth);
}

INSTANTIATE_TEST_SUITE_P(
    Of,
    TwoConsents,
    testing::Values(
        std::tuple("yes"s, "yes"s, "yes"s),
        std::tuple("yes"s, "yes"s, "no"s),
        std::tuple("yes"s, "no"s, "yes"s),
        std::tuple("no"s, "yes"s, "yes"s),
        std::tuple("no"s, "no"s, "yes"s)),
    [](const auto& answers) {
      const auto all = answers.param;
      return std::string("Study_") + std::get<0>(all) + "_Storage_" + std::get<1>(all) + "_Video_" +
             std::get<2>(all);
    });

TEST_F(SessionStepsTest, ContinuesAtTheSameStepAfterAPause) {
  tests::walkTo(session_, StepKind::Questionnaire);
  tests::answerStep(session_);
  const auto visit = session_.visit();
  session_.pause("a telephone rings");
  EXPECT_THROW(session_.finishStep(), UserError);
  EXPECT_THROW(session_.record(tests::answerTo(session_, session_.items().front())), UserError);
  EXPECT_THROW(session_.retract(session_.items().front().id), UserError);
  session_.resumeAfterPause();
  EXPECT_EQ(session_.visit(), visit);
  EXPECT_TRUE(session_.missing().empty());
  session_.finishStep();
}

TEST_F(SessionStepsTest, AllowsWithdrawalDuringATrial) {
  tests::walkTo(session_, StepKind::Trial);
  const auto visit = session_.visit();
  session_.beginTrial();
  study_->traces().add(visit, 0, std::vector<storage::TraceSample>(1000));
  session_.withdraw("it hurts");
  EXPECT_EQ(session_.state(), SessionState::Withdrawn);
  const auto trials = storage::Records(study_->database()).trials();
  ASSERT_EQ(trials.size(), 1U);
  EXPECT_EQ(trials[0].ending, TrialEnding::Stopped);
  EXPECT_EQ(trials[0].verdict, Verdict::Fail);
  EXPECT_EQ(trials[0].traceSamples, 1000);
  EXPECT_EQ(trials[0].step.visitStatus, storage::VisitStatus::BrokenOff);
  EXPECT_TRUE(isSound());  // every trace has its trial
}

TEST_F(SessionStepsTest, KeepsTheReasonOfABreakOffAfterAWithdrawal) {
  tests::walkTo(session_, StepKind::Trial);
  session_.beginTrial();
  session_.abortTrial({.ending = TrialEnding::DeviceGone});
  session_.withdraw("enough");
  const auto session = storage::Records(study_->database()).sessions().front();
  EXPECT_EQ(session.endReason, "enough");
  EXPECT_EQ(storage::Records(study_->database()).trials().front().ending, TrialEnding::DeviceGone);
}

TEST_F(SessionStepsTest, CountsTheCutsOfABenchmark) {
  MadeStudy study(tests::libraryProtocol("punch-face-validity"));
  auto session = tests::consenting(*study, {.cohort = "professional"});
  tests::walkTo(session, StepKind::Benchmark);
  EXPECT_EQ(session.benchmarkCuts(), 0);
  session.recordBenchmarkCuts(2);
  EXPECT_THROW(session.finishStep(), UserError);  // the protocol asks for at least 3
  EXPECT_THROW(session.recordBenchmarkCuts(-1), UserError);
  EXPECT_EQ(session.benchmarkCuts(), 2);
  session.recordBenchmarkCuts(3);
  session.finishStep();
  EXPECT_THROW(session.recordBenchmarkCuts(4), UserError);
}

TEST_F(SessionStepsTest, AcceptsNotesDuringAndAfterASession) {
  session_.note("wears gloves");
  tests::walkToTheEnd(session_);
  session_.note("came late");
  const std::string events = tests::eventsOf(*study_, session_.id());
  EXPECT_EQ(events.substr(0, 14), "enrolled note ");
  EXPECT_EQ(events.substr(events.size() - 21), "finished_session note");
}

TEST_F(SessionStepsTest, ChangesNothingInASessionThatIsOver) {
  tests::walkToTheEnd(session_);
  ASSERT_EQ(session_.state(), SessionState::Completed);
  EXPECT_THROW(session_.record({.item = "preferred", .response = std::string("1")}), UserError);
  EXPECT_THROW(session_.retract("preferred"), UserError);
  EXPECT_THROW(session_.recordBenchmarkCuts(3), UserError);
  EXPECT_THROW(session_.setLanguage("de"), UserError);
  EXPECT_THROW(session_.repeatStep(""), UserError);
  EXPECT_THROW(session_.skipStep(""), UserError);
  EXPECT_THROW(session_.withdraw(""), UserError);
  EXPECT_THROW(session_.finishStep(), UserError);
}

TEST_F(SessionStepsTest, RecordsActorActionAndReasonInTheAuditTrail) {
  tests::walkTo(session_, StepKind::Trial);
  session_.skipStep("no time");
  const auto events = study_->events().read(session_.id());
  EXPECT_EQ(events.back().name(), "skipped_step");
  EXPECT_EQ(events.back().detail, "no time");
  EXPECT_EQ(events.back().actor, storage::Actor::Operator);
  EXPECT_EQ(events.front().actor, storage::Actor::Program);
}

class OfferedAgain : public testing::Test {
 protected:
  OfferedAgain() {
    tests::walkUntil(session_, [](const Step& step) { return step.isOptionalTrial; });
  }

  MadeStudy study_{tests::protocolFrom(tests::shortProtocol({.offersAgain = true})), 3};
  Session session_ = Session::enrol(*study_, {.cohort = "surgeons"});
};

TEST_F(OfferedAgain, IsEachAlternativeUnderItsLabelWithItsCondition) {
  std::map<int, std::string> before;
  int label = 0;
  for (const auto& step : session_.plan()) {
    if (step.kind != StepKind::Trial) continue;
    if (!step.isOptionalTrial) {
      before[step.label] = step.condition;
      continue;
    }
    EXPECT_EQ(step.label, ++label);
    EXPECT_EQ(step.condition, before.at(step.label));
    EXPECT_EQ(step.phase, "choice");
    EXPECT_EQ(step.position, 0) << "it has no place in the order";
  }
  EXPECT_EQ(label, 3);
}

TEST_F(OfferedAgain, MayBeAcceptedOrDeclined) {
  const int first = session_.stepIndex();
  session_.skipOptionalTrial();
  session_.beginTrial();
  session_.finishTrial(tests::feltTrial());
  session_.skipOptionalTrial();
  EXPECT_EQ(session_.step().kind, StepKind::Preference);
  EXPECT_THROW(session_.skipOptionalTrial(), UserError);
  const auto id = session_.id();
  EXPECT_EQ(study_->sessions().statusOf({id, first, 1}), storage::VisitStatus::Skipped);
  EXPECT_EQ(study_->sessions().statusOf({id, first + 1, 1}), storage::VisitStatus::Finished);
  tests::walkToTheEnd(session_);
  EXPECT_EQ(session_.state(), SessionState::Completed);
  EXPECT_EQ(storage::Records(study_->database()).trials().size(), 3U + 1U);
  EXPECT_TRUE(verify(*study_).isSound());
}

}  // namespace session_steps_test
}  // namespace study

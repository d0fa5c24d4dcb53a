// Enrolment: participants, places of the design, versions of the protocol.
#include <gtest/gtest.h>

#include "study/storage/records.h"
#include "tests/study/made_study.h"
#include "tests/study/walk.h"

namespace study {
namespace enrolment_test {

using storage::StorageError;
using tests::MadeStudy;
using tests::ShortProtocol;

std::vector<std::string> orderOf(const Session& session) {
  std::vector<std::string> order;
  for (const auto& step : session.plan()) {
    if (step.kind == StepKind::Trial) {
      order.push_back(step.condition + "/" + std::to_string(step.label));
    }
  }
  return order;
}

bool isFrozen(Study& study) {
  return study.protocols().current().frozenUtc.has_value();
}

TEST(Enrolment, ReservesTheLowestFreePlaceOfItsCohort) {
  MadeStudy study;
  const auto first = Session::enrol(*study, {.cohort = "surgeons"});
  const auto second = Session::enrol(*study, {.cohort = "surgeons"});
  const auto other = Session::enrol(*study, {.cohort = "students"});
  EXPECT_EQ(first.slot(), 0);
  EXPECT_EQ(second.slot(), 1);
  EXPECT_EQ(other.slot(), 0);
  EXPECT_EQ(first.participant(), "P001");
  EXPECT_EQ(other.participant(), "P003");
}

TEST(Enrolment, KeepsThePlaceOfACompletedSession) {
  MadeStudy study;
  auto first = Session::enrol(*study, {.cohort = "surgeons"});
  tests::walkToTheEnd(first);
  ASSERT_EQ(first.state(), SessionState::Completed);
  EXPECT_EQ(Session::enrol(*study, {.cohort = "surgeons"}).slot(), 1);
}

/// An event that ends a session and frees its place.
struct Leaving {
  const char* name;
  void (*leave)(Session&);
};

void decline(Session& session) {
  auto answer = tests::answerTo(session, session.items().front());
  answer.response = std::string("no");
  session.record(answer);
  session.finishStep();
}

void giveUp(Session& session) {
  tests::walkTo(session, StepKind::Trial);
  session.beginTrial();
  session.abortTrial({.ending = TrialEnding::DeviceGone});
  session.giveUpOnDevice("the cable is torn");
}

void giveUpBeforeATrial(Session& session) {
  EXPECT_FALSE(session.allows(SessionEvent::GaveUpOnDevice)) << "no device is needed here";
  tests::walkTo(session, StepKind::Trial);
  session.giveUpOnDevice("it cannot be opened");
}

class LeavingTest : public testing::TestWithParam<Leaving> {};

TEST_P(LeavingTest, GivesThePlaceAndItsOrderToTheNextPerson) {
  MadeStudy study;
  auto leaver = Session::enrol(*study, {.cohort = "surgeons"});
  const auto staying = Session::enrol(*study, {.cohort = "surgeons"});
  GetParam().leave(leaver);
  ASSERT_TRUE(leaver.isOver());
  const auto next = Session::enrol(*study, {.cohort = "surgeons"});
  EXPECT_EQ(next.slot(), leaver.slot());
  EXPECT_EQ(orderOf(next), orderOf(leaver));
  EXPECT_NE(next.slot(), staying.slot());
  EXPECT_NE(next.participant(), leaver.participant());
}

INSTANTIATE_TEST_SUITE_P(
    Enrolment,
    LeavingTest,
    testing::Values(
        Leaving{"Declining", decline},
        Leaving{"Withdrawing", [](Session& s) { s.withdraw("tired"); }},
        Leaving{"BeingRejected", [](Session& s) { s.reject("not a surgeon"); }},
        Leaving{"LosingTheDevice", giveUp},
        Leaving{"FindingNoDevice", giveUpBeforeATrial}),
    [](const auto& leaving) { return leaving.param.name; });

TEST(Enrolment, GivesPilotsAndSimulationsTheirOwnPlaces) {
  MadeStudy study;
  const auto pilot = Session::enrol(*study, {.cohort = "surgeons", .runMode = RunMode::Pilot});
  const auto nobody = Session::enrol(*study, {.cohort = "surgeons", .runMode = RunMode::Simulated});
  const auto person = Session::enrol(*study, {.cohort = "surgeons"});
  EXPECT_EQ(pilot.slot(), 0);
  EXPECT_EQ(nobody.slot(), 0);
  EXPECT_EQ(person.slot(), 0);
  EXPECT_EQ(pilot.participant(), "PILOT-001");
  EXPECT_EQ(nobody.participant(), "SIM-001");
}

TEST(Enrolment, FreezesTheProtocolForTheFirstLiveParticipantOnly) {
  MadeStudy study;
  Session::enrol(*study, {.cohort = "surgeons", .runMode = RunMode::Pilot});
  Session::enrol(*study, {.cohort = "surgeons", .runMode = RunMode::Simulated});
  EXPECT_FALSE(isFrozen(*study));
  Session::enrol(*study, {.cohort = "surgeons"});
  const auto frozen = study->protocols().current().frozenUtc;
  ASSERT_TRUE(frozen);
  EXPECT_EQ(*frozen, "2000-01-01T10:00:00.000Z");
  study.clock.advance(60.0);
  Session::enrol(*study, {.cohort = "surgeons"});
  EXPECT_EQ(study->protocols().current().frozenUtc, frozen);
}

TEST(Enrolment, AmendsFreelyBeforeAndOnlyWithAReasonAfterTheFirstParticipant) {
  MadeStudy study;
  const auto changed = tests::protocolFrom(tests::shortProtocol({.minimumCuts = 2}));
  study->amend(changed, "");
  const auto person = Session::enrol(*study, {.cohort = "surgeons"});
  EXPECT_THROW(study->amend(changed, ""), StorageError);
  EXPECT_EQ(study->protocols().all().size(), 2U);
  study->amend(changed, "two cuts are too few");
  EXPECT_EQ(study->protocols().all().size(), 3U);
  EXPECT_FALSE(isFrozen(*study));  // a new version with which no participant has begun
  EXPECT_EQ(study->protocols().current().reason, "two cuts are too few");
}

TEST(Enrolment, TakesNoOtherStudysProtocolForAVersion) {
  MadeStudy study;
  const auto before = study->protocols().all().size();
  EXPECT_THROW(study->amend(tests::libraryProtocol("reaming-hardness"), "by mistake"), UserError);
  EXPECT_EQ(study->protocols().all().size(), before);
}

TEST(Enrolment, ResumesASessionUnderItsOwnProtocol) {
  MadeStudy study;
  auto before = Session::enrol(*study, {.cohort = "surgeons"});
  study->amend(tests::protocolFrom(tests::shortProtocol({.minimumCuts = 7})), "more cuts");
  const auto after = Session::enrol(*study, {.cohort = "surgeons"});
  EXPECT_EQ(after.slot(), 1);  // the new version has the same orders
  tests::walkTo(before, StepKind::Trial);
  EXPECT_EQ(before.step().minimumCuts, 1);
  const auto id = before.id();
  { const Session gone = std::move(before); }
  study.reopen();
  EXPECT_EQ(Session::resume(*study, id).step().minimumCuts, 1);
}

TEST(Enrolment, NumbersASecondSessionOfTheSamePerson) {
  MadeStudy study;
  auto first = Session::enrol(*study, {.cohort = "surgeons", .code = "Q7"});
  tests::walkToTheEnd(first);
  const auto second = Session::enrol(*study, {.cohort = "surgeons", .code = "Q7"});
  EXPECT_EQ(second.slot(), 1);
  const auto records = storage::Records(study->database()).sessions();
  ASSERT_EQ(records.size(), 2U);
  EXPECT_EQ(records[0].participant, records[1].participant);
  EXPECT_EQ(records[0].number, 1);
  EXPECT_EQ(records[1].number, 2);
}

TEST(Enrolment, RefusesACodeOfAnotherCohortOrRunModeAndKeepsThePlaceFree) {
  MadeStudy study;
  Session::enrol(*study, {.cohort = "surgeons", .code = "Q7"});
  EXPECT_THROW(Session::enrol(*study, {.cohort = "students", .code = "Q7"}), StorageError);
  EXPECT_THROW(
      Session::enrol(*study, {.cohort = "surgeons", .runMode = RunMode::Pilot, .code = "Q7"}),
      StorageError);
  EXPECT_EQ(storage::Records(study->database()).sessions().size(), 1U);
  EXPECT_EQ(Session::enrol(*study, {.cohort = "students"}).slot(), 0);
}

TEST(Enrolment, RefusesUnknownCohortsAndLanguages) {
  MadeStudy study;
  EXPECT_THROW(Session::enrol(*study, {.cohort = "nurses"}), UserError);
  EXPECT_THROW(Session::enrol(*study, {.cohort = "surgeons", .language = "fr"}), UserError);
  for (const char* code : {"two words", "a/b", "é", "=1+1", "-x", "a,b"}) {
    EXPECT_THROW(Session::enrol(*study, {.cohort = "surgeons", .code = code}), UserError) << code;
  }
  EXPECT_EQ(storage::Records(study->database()).sessions().size(), 0U);
  EXPECT_FALSE(isFrozen(*study));
}

TEST(Enrolment, ChoosesUnusedCodes) {
  MadeStudy study;
  Session::enrol(*study, {.cohort = "surgeons", .code = "P002"});
  Session::enrol(*study, {.cohort = "students", .code = "SIM-001"});
  EXPECT_EQ(Session::enrol(*study, {.cohort = "surgeons"}).participant(), "P003");
  EXPECT_EQ(
      Session::enrol(*study, {.cohort = "surgeons", .runMode = RunMode::Simulated}).participant(),
      "SIM-002");
}

}  // namespace enrolment_test
}  // namespace study

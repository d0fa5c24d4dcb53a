#include "study/session/unfinished_sessions.h"

#include <optional>

#include <gtest/gtest.h>

#include "tests/study/made_study.h"
#include "tests/study/storage/sql.h"
#include "tests/study/walk.h"

namespace study {
namespace unfinished_sessions_test {

class UnfinishedSessionsTest : public testing::Test {
 protected:
  /// The only unfinished session.
  UnfinishedSession look() {
    const auto all = unfinishedSessions(*study_);
    return all.size() == 1 ? all.front() : UnfinishedSession{};
  }

  static bool offers(const UnfinishedSession& session, const std::string& words) {
    for (const auto& choice : session.choices) {
      if (choice.find(words) != std::string::npos) return true;
    }
    return false;
  }

  tests::MadeStudy study_;
};

TEST_F(UnfinishedSessionsTest, LeaveOutSessionsThatAreOver) {
  auto done = tests::consenting(*study_, {.cohort = "surgeons"});
  tests::walkToTheEnd(done);
  const auto open = Session::enrol(*study_, {.cohort = "surgeons"});
  const auto found = look();
  EXPECT_EQ(found.participant, open.participant());
}

TEST_F(UnfinishedSessionsTest, OfferOnlyTheOtherProgramWhileASessionIsOpenThere) {
  const auto session = Session::enrol(*study_, {.cohort = "surgeons"});
  const auto found = look();
  EXPECT_TRUE(found.isOpenElsewhere());
  ASSERT_EQ(found.choices.size(), 1U);
  EXPECT_TRUE(offers(found, "go on there"));
}

TEST_F(UnfinishedSessionsTest, DoNotOfferToSkipConsent) {
  { const auto session = Session::enrol(*study_, {.cohort = "surgeons"}); }
  const auto found = look();
  EXPECT_TRUE(offers(found, "Continue in this step"));
  EXPECT_TRUE(offers(found, "the participant wants to"));
  EXPECT_FALSE(offers(found, "Skip"));
  EXPECT_FALSE(offers(found, "repeat"));
}

TEST_F(UnfinishedSessionsTest, ReportATrialThatWasNotEnded) {
  {
    auto session = tests::consenting(*study_, {.cohort = "surgeons"});
    tests::walkTo(session, StepKind::Trial);
    session.beginTrial();
  }
  const auto found = look();
  EXPECT_EQ(found.state, SessionState::InTrial);
  EXPECT_NE(describe(found).find("counts as broken off"), std::string::npos) << describe(found);
  EXPECT_TRUE(offers(found, "Repeat the trial"));
  EXPECT_TRUE(offers(found, "Skip the trial"));
  EXPECT_TRUE(offers(found, "Device failed: end it"));
  EXPECT_FALSE(offers(found, "Continue in this step"));
}

TEST_F(UnfinishedSessionsTest, OfferExactlyTheAllowedEvents) {
  std::optional<Session> session(tests::consenting(*study_, {.cohort = "surgeons"}));
  while (!session->isOver()) {
    const auto id = session->id();
    session.reset();
    const auto found = look();
    session.emplace(Session::resume(*study_, id));
    EXPECT_EQ(offers(found, "Skip"), session->allows(SessionEvent::SkippedStep)) << describe(found);
    EXPECT_EQ(offers(found, "Device failed"), session->allows(SessionEvent::GaveUpOnDevice))
        << describe(found);
    EXPECT_EQ(offers(found, "repeat it"), session->allows(SessionEvent::RepeatedStep))
        << describe(found);
    tests::passStep(*session);
  }
}

TEST_F(UnfinishedSessionsTest, NameNoCondition) {
  std::optional<Session> session(tests::consenting(*study_, {.cohort = "surgeons"}));
  while (!session->isOver()) {
    for (const auto* secret : {"interpolation", "finite", "kalman"}) {
      EXPECT_EQ(describe(look()).find(secret), std::string::npos) << describe(look());
    }
    tests::passStep(*session);
  }
}

}  // namespace unfinished_sessions_test
}  // namespace study

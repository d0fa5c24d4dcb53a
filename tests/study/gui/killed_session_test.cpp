// The program is killed during a cut, and a new program resumes the session.
#include <csignal>
#include <cstdlib>

#include <gtest/gtest.h>

#include "protocols/load_protocol.h"
#include "study/gui/operator/operator_window.h"
#include "study/session/verification.h"
#include "study/storage/records.h"
#include "tests/study/gui/participant.h"
#include "tests/study/known_secret.h"
#include "tests/support/child_process.h"
#include "tests/support/programs.h"
#include "tests/support/scratch_folder.h"

namespace study::gui {
namespace killed_session_test {

constexpr const char* kFolder = "PALPATE_TEST_STUDY";

int firstTrial(const Session& session) {
  int trial = 0;
  while (session.plan()[static_cast<std::size_t>(trial)].kind != StepKind::Trial) ++trial;
  return trial;
}

/// Run by the test below in a child process, which it kills.
TEST(KilledSession, DISABLED_IsKilledDuringATrial) {
  SystemClock clock;
  auto study = Study::open(std::getenv(kFolder), clock);
  OperatorWindow window(study);
  window.show();
  window.enrol({.cohort = "professional", .runMode = RunMode::Live, .language = "en", .code = {}});
  tests::Participant participant(window);
  participant.takePart(firstTrial(window.controller()->session()));
  participant.cut(1);
  ASSERT_TRUE(window.controller()->isTrialRunning());
  raise(SIGKILL);
}

TEST(KilledSession, ResumesAtTheInterruptedTrial) {
  tests::ScratchFolder folder;
  const std::string place = folder / "study";
  SystemClock clock;
  questionnaires::Problems problems;
  auto protocol = protocols::loadProtocolFile("punch-face-validity", problems);
  Study::create(place, *protocol, clock, 7, tests::knownSecret());
  const auto killed = tests::run(
      {tests::thisProgram(),
       "--gtest_also_run_disabled_tests",
       "--gtest_filter=KilledSession.DISABLED_IsKilledDuringATrial"},
      // This process may be one of several that share the tests; the other has its one test to
      // itself.
      {std::string(kFolder) + "=" + place, "GTEST_TOTAL_SHARDS=1", "GTEST_SHARD_INDEX=0"});
  ASSERT_EQ(killed.status, -SIGKILL) << killed.out;

  auto study = Study::open(place, clock);
  const auto before = storage::Records(study.database());
  const auto answered = before.answers().size();
  ASSERT_GT(answered, 3U);
  OperatorWindow window(study);
  window.show();
  window.resume(before.sessions().front().id);
  ASSERT_NE(window.controller(), nullptr);
  const auto& session = window.controller()->session();
  EXPECT_EQ(session.stepIndex(), firstTrial(session));
  EXPECT_EQ(session.state(), SessionState::Interrupted);
  EXPECT_EQ(storage::Records(study.database()).answers().size(), answered);
  EXPECT_EQ(storage::Records(study.database()).trials().front().ending, TrialEnding::ProgramEnded);

  window.controller()->repeatStep(QStringLiteral("the power failed"));
  tests::Participant participant(window);
  participant.doStep();
  EXPECT_EQ(session.stepIndex(), firstTrial(session) + 1);
  window.close();
  EXPECT_TRUE(verify(study).isSound());
}

}  // namespace killed_session_test
}  // namespace study::gui

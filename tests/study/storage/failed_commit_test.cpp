// A commit that fails changes nothing on the disk or in the session.
#include <functional>
#include <tuple>

#include <gtest/gtest.h>
#include <sqlite3.h>

#include "study/session/verification.h"
#include "tests/study/made_study.h"
#include "tests/study/walk.h"

namespace study::storage {
namespace failed_commit_test {

class FailedCommitTest : public testing::Test {
 protected:
  /// All functions of a session that tell its state.
  auto situation() {
    return std::tuple(
        session_.state(),
        session_.isOver() ? -1 : session_.stepIndex(),
        session_.visit(),
        session_.language(),
        session_.answers(),
        tests::eventsOf(*study_, session_.id()));
  }

  /// SQLite calls the hook before each commit, and rolls back if it returns anything but 0.
  void letCommits(bool succeed) {
    sqlite3_commit_hook(
        study_->database().handle(), succeed ? nullptr : +[](void*) { return 1; }, nullptr);
  }

  /// Runs @p action twice; its first commit must fail and leave no change.
  void failFirst(const char* name, const std::function<void()>& action) {
    SCOPED_TRACE(name);
    const auto before = situation();
    letCommits(false);
    EXPECT_THROW(action(), StorageError);
    letCommits(true);
    EXPECT_EQ(situation(), before);
    action();
    EXPECT_NE(situation(), before);
  }

  tests::MadeStudy study_;
  Session session_ = Session::enrol(*study_, {.cohort = "surgeons"});
};

TEST_F(FailedCommitTest, ChangesNothingInTheSession) {
  const auto consent = session_.items().front();
  failFirst("answer", [&] { session_.record(tests::answerTo(session_, consent)); });
  failFirst("language", [&] { session_.setLanguage("de"); });
  failFirst("finish a step", [&] { session_.finishStep(); });
  tests::walkTo(session_, StepKind::Trial);
  failFirst("pause", [&] { session_.pause("the telephone"); });
  failFirst("resume", [&] { session_.resumeAfterPause(); });
  failFirst("begin a trial", [&] { session_.beginTrial(); });
  failFirst("break off", [&] { session_.abortTrial({.ending = TrialEnding::Stopped}); });
  failFirst("repeat", [&] { session_.repeatStep("stopped by mistake"); });
  session_.beginTrial();
  failFirst("finish a trial", [&] { session_.finishTrial(tests::feltTrial()); });
  failFirst("skip", [&] { session_.skipStep("no time"); });
  failFirst("note", [&] { session_.note("wears gloves"); });
  failFirst("withdraw", [&] { session_.withdraw("enough"); });
  EXPECT_EQ(session_.state(), SessionState::Withdrawn);
  const auto report = verify(*study_);
  EXPECT_TRUE(report.isSound());
}

}  // namespace failed_commit_test
}  // namespace study::storage

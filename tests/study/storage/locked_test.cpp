// Another program holds the write lock.
#include <chrono>
#include <future>
#include <stdexcept>

#include <gtest/gtest.h>

#include "study/session/verification.h"
#include "tests/study/made_study.h"
#include "tests/study/storage/refusals.h"
#include "tests/study/storage/sql.h"
#include "tests/study/walk.h"

namespace study::storage {
namespace locked_test {

using Kind = StorageError::Kind;
using Seconds = std::chrono::duration<double>;

/// How long it takes on this machine that SQLite itself gives up on the lock after 3 s: the
/// control.
double secondsOfSqliteAlone(const std::string& file) {
  tests::Sql control(file);
  control.run("PRAGMA busy_timeout = 3000");
  const auto start = std::chrono::steady_clock::now();
  EXPECT_THROW(control.run("BEGIN IMMEDIATE"), std::runtime_error);
  return Seconds(std::chrono::steady_clock::now() - start).count();
}

class LockedTest : public testing::TestWithParam<const char*> {
 protected:
  tests::Refusal timed(const std::function<void()>& action) {
    const auto start = std::chrono::steady_clock::now();
    auto refusal = tests::refusalOf(action);
    took_ = Seconds(std::chrono::steady_clock::now() - start).count();
    return refusal;
  }

  tests::MadeStudy study_;
  Session session_ = Session::enrol(*study_, {.cohort = "surgeons"});
  double took_ = 0.0;
};

TEST_P(LockedTest, FailsInTimeChangesNothingAndContinuesAfterwards) {
  tests::answerStep(session_);
  const auto answers = session_.answers();
  const auto events = tests::eventsOf(*study_, session_.id());
  tests::Sql other(study_.file("study.db"));
  other.run(GetParam());

  auto control = std::async(std::launch::async, secondsOfSqliteAlone, study_.file("study.db"));
  const auto refusal = timed([&] { session_.finishStep(); });
  EXPECT_EQ(refusal.kind, Kind::Busy);
  tests::expectClear(refusal, "another program is using it");
  EXPECT_GE(took_, 2.5);  // the busy timeout is 3 s
  EXPECT_LT(took_, 1.9 * control.get()) << "it waited for the lock more than once";
  EXPECT_EQ(session_.state(), SessionState::Enrolled);
  EXPECT_EQ(session_.answers(), answers);  // reading works meanwhile
  EXPECT_EQ(tests::eventsOf(*study_, session_.id()), events);

  other.run("ROLLBACK");
  session_.finishStep();
  EXPECT_EQ(session_.state(), SessionState::Consented);
  EXPECT_TRUE(verify(*study_).isSound());
}

INSTANTIATE_TEST_SUITE_P(
    By, LockedTest, testing::Values("BEGIN IMMEDIATE", "BEGIN EXCLUSIVE"), [](const auto& lock) {
      return std::string(lock.param).substr(6);
    });

TEST(Locked, ExclusivelyIsNotOpened) {
  tests::MadeStudy study;
  study.close();
  tests::Sql other(study.file("study.db"));
  other.run(
      "PRAGMA locking_mode = EXCLUSIVE; PRAGMA journal_mode = DELETE; BEGIN EXCLUSIVE;"
      "CREATE TABLE mine (x)");
  const auto refusal = tests::refusalOf([&] { Study::open(study.folder(), study.clock); });
  EXPECT_EQ(refusal.kind, Kind::Busy) << refusal.words;
  tests::expectClear(refusal, "another program is using it");
  other.run("ROLLBACK; PRAGMA locking_mode = NORMAL; SELECT * FROM study");
  study.reopen();
  EXPECT_TRUE(verify(*study).isSound());
}

TEST(Locked, IdentitiesRefuseTheAnswer) {
  tests::MadeStudy study;
  auto session = Session::enrol(*study, {.cohort = "surgeons"});
  const auto signature = session.items().back();
  ASSERT_TRUE(signature.isIdentifying);
  session.record(tests::answerTo(session, session.items().front()));  // a name waits for a yes
  tests::Sql other(study.file("identity.db"));
  other.run("BEGIN IMMEDIATE");
  const auto refusal =
      tests::refusalOf([&] { session.record(tests::answerTo(session, signature)); });
  EXPECT_EQ(refusal.kind, Kind::Busy);
  EXPECT_EQ(tests::eventsOf(*study, session.id()), "enrolled answered");
  other.run("ROLLBACK");
  session.record(tests::answerTo(session, signature));
}

}  // namespace locked_test
}  // namespace study::storage

#include "study/storage/lease.h"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "study/session/backup.h"
#include "study/session/verification.h"
#include "tests/study/made_study.h"
#include "tests/study/storage/refusals.h"
#include "tests/study/storage/sql.h"
#include "tests/study/walk.h"

namespace study::storage {
namespace lease_test {

using Kind = StorageError::Kind;

class LeaseTest : public testing::Test {
 protected:
  void SetUp() override { id_ = Session::enrol(*study_, {.cohort = "surgeons"}).id(); }

  tests::Refusal resuming() {
    return tests::refusalOf([&] { Session::resume(*study_, id_); });
  }

  /// Writes a lease's row as another program may have left it.
  void leave(const std::string& station, std::int64_t pid, const std::string& process) {
    tests::Sql(study_.file("study.db"))
        .run(
            "INSERT OR REPLACE INTO lease (session_id, station, pid, process, taken_utc) VALUES "
            "(1, '" +
            station + "', " + std::to_string(pid) + ", '" + process + "', 'earlier')");
  }

  std::string thisStation() {
    const auto session = Session::resume(*study_, id_);
    return tests::Sql(study_.file("study.db")).text("SELECT station FROM lease");
  }

  tests::MadeStudy study_;
  SessionId id_{};
};

TEST_F(LeaseTest, IsForOneWindowAtATime) {
  auto first = std::make_optional(Session::resume(*study_, id_));
  const auto refusal = resuming();
  EXPECT_EQ(refusal.kind, Kind::Busy);
  tests::expectClear(refusal, "process " + std::to_string(getpid()));
  tests::passStep(*first);  // the first holder continues
  first.reset();
  EXPECT_FALSE(resuming().happened);
}

TEST_F(LeaseTest, IsGivenBackWithTheSession) {
  { const auto session = Session::resume(*study_, id_); }
  EXPECT_EQ(tests::Sql(study_.file("study.db")).number("SELECT count(*) FROM lease"), 0);
}

TEST_F(LeaseTest, DoesNotBlockOtherSessions) {
  const auto session = Session::resume(*study_, id_);
  const auto other = Session::enrol(*study_, {.cohort = "surgeons"});
  EXPECT_NE(other.id(), session.id());
}

/// Another program that runs the session until it is told to end.
class OtherProgram {
 public:
  OtherProgram(const std::string& folder, SessionId id) {
    if (pipe(ready_) != 0) throw std::runtime_error("no pipe");
    pid_ = fork();
    if (pid_ == 0) run(folder, id);
    char byte = 0;
    hasIt_ = read(ready_[0], &byte, 1) == 1 && byte == 'y';
  }
  ~OtherProgram() { die(); }
  OtherProgram(const OtherProgram&) = delete;
  OtherProgram& operator=(const OtherProgram&) = delete;

  pid_t pid() const noexcept { return pid_; }
  bool hasIt() const noexcept { return hasIt_; }
  void die() {
    if (pid_ <= 0) return;
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
    pid_ = 0;
  }
  /// It dies, and its parent does not take note of that.
  void dieUnnoticed() const {
    kill(pid_, SIGKILL);
    siginfo_t ended{};
    waitid(P_PID, static_cast<id_t>(pid_), &ended, WEXITED | WNOWAIT);
  }

 private:
  [[noreturn]] void run(const std::string& folder, SessionId id) {
    try {
      SimulatedClock clock;
      auto study = Study::open(folder, clock);
      const auto session = Session::resume(study, id);
      if (write(ready_[1], "y", 1) == 1) pause();
    } catch (const std::exception&) {
      if (write(ready_[1], "n", 1) == 1) _exit(1);
    }
    _exit(0);
  }

  pid_t pid_ = 0;
  int ready_[2]{};
  bool hasIt_ = false;
};

TEST_F(LeaseTest, IsHeldByAnotherProgramUntilItEnds) {
  study_.close();
  OtherProgram other(study_.folder(), id_);
  ASSERT_TRUE(other.hasIt());
  study_.reopen();
  const auto refusal = resuming();
  EXPECT_EQ(refusal.kind, Kind::Busy);
  tests::expectClear(refusal, "process " + std::to_string(other.pid()));
  other.die();  // kill -9: the lease is not given back
  EXPECT_FALSE(resuming().happened);
}

TEST_F(LeaseTest, OfAProgramThatWasKilledIsFreeBeforeItsParentTakesNote) {
  study_.close();
  OtherProgram other(study_.folder(), id_);
  ASSERT_TRUE(other.hasIt());
  study_.reopen();
  other.dieUnnoticed();
  EXPECT_FALSE(resuming().happened);
}

TEST_F(LeaseTest, IsTakenOverFromAnEarlierProcessWithTheSameNumber) {
  leave(thisStation(), 1, "another-boot/12345#1");  // process 1 always exists
  EXPECT_FALSE(resuming().happened);
}

TEST_F(LeaseTest, IsTakenOverFromAProcessBeforeARestartWithTheSameNumber) {
  leave(thisStation(), getpid(), "another-boot/12345#1");
  EXPECT_FALSE(resuming().happened);
}

std::string processOfTheLease(const tests::MadeStudy& study) {
  return tests::Sql(study.file("study.db")).text("SELECT process FROM lease");
}

TEST_F(LeaseTest, OfADeadProgramIsTakenAfterTheComputerWasRenamed) {
  std::string process;
  {
    const auto session = Session::resume(*study_, id_);
    process = processOfTheLease(study_);
  }
  leave("its-former-name", 1, process);  // process 1 began at another time
  EXPECT_FALSE(resuming().happened);
}

TEST_F(LeaseTest, OfAProgramThatRunsHereIsKeptWhenTheComputerIsRenamed) {
  study_.close();
  const OtherProgram other(study_.folder(), id_);
  ASSERT_TRUE(other.hasIt());
  study_.reopen();
  leave("its-former-name", other.pid(), processOfTheLease(study_));
  EXPECT_EQ(tests::refusalOf([&] { Session::resume(*study_, id_, "why not"); }).kind, Kind::Busy);
}

TEST_F(LeaseTest, OfAnotherContainerOnThisComputerIsNotTakenOver) {
  std::string process;
  {
    const auto session = Session::resume(*study_, id_);
    process = processOfTheLease(study_);
  }
  leave(thisStation(), 4711, process.substr(0, process.find('@')) + "@pid:[1]#1");
  EXPECT_EQ(resuming().kind, Kind::Busy);
  EXPECT_NO_THROW(Session::resume(*study_, id_, "the container was removed"));
}

TEST_F(LeaseTest, IsTakenOverFromAFormatWithoutWindowNumbers) {
  leave(thisStation(), 1, "another-boot/12345");
  EXPECT_FALSE(resuming().happened);
}

TEST_F(LeaseTest, OfAnotherComputerIsNotTakenOver) {
  leave("the-other-laboratory", 4711, "boot/1#1");
  const auto refusal = resuming();
  EXPECT_EQ(refusal.kind, Kind::Busy);
  tests::expectClear(refusal, "the-other-laboratory");
}

TEST_F(LeaseTest, OfAnotherComputerTellsWhenSomethingWasStoredLast) {
  const auto last = [&] { return asUtc(study_->events().read(id_).back().when.wall); };
  const auto before = last();
  study_.clock.advance(3600.0);
  {
    auto session = Session::resume(*study_, id_);
    session.note("an hour later");
  }
  ASSERT_NE(last(), before);
  leave("the-other-laboratory", 4711, "boot/1#1");
  tests::expectClear(resuming(), "stored there last on " + last());
}

TEST_F(LeaseTest, OfAnotherComputerIsTakenOverWithAReason) {
  leave("the-other-laboratory", 4711, "boot/1#1");
  const auto session = Session::resume(*study_, id_, "it was replaced");
  const auto events = study_->events().read(id_);
  ASSERT_GE(events.size(), 2U);
  const auto& taken = events[events.size() - 2];
  EXPECT_EQ(taken.kind, EventKind::TookOver);
  EXPECT_EQ(
      describe(taken), "from the-other-laboratory, process 4711, since earlier: it was replaced");
  EXPECT_TRUE(verify(*study_).isSound());
}

TEST_F(LeaseTest, OfAProgramThatRunsHereIsNotTakenOver) {
  study_.close();
  const OtherProgram other(study_.folder(), id_);
  ASSERT_TRUE(other.hasIt());
  study_.reopen();
  const auto refusal = tests::refusalOf([&] { Session::resume(*study_, id_, "I am in a hurry"); });
  EXPECT_EQ(refusal.kind, Kind::Busy);
}

TEST_F(LeaseTest, ThatWasTakenOverStoresNothingMore) {
  auto session = Session::resume(*study_, id_);
  const auto before = study_->events().last();
  leave("the-other-laboratory", 4711, "boot/1#1");
  const auto refusal = tests::refusalOf([&] { tests::passStep(session); });
  EXPECT_EQ(refusal.kind, Kind::Other) << "waiting does not help";
  tests::expectClear(refusal, "taken over");
  EXPECT_EQ(study_->events().last(), before);
}

TEST_F(LeaseTest, IsNotInABackup) {
  const auto session = Session::resume(*study_, id_);
  leave("the-other-laboratory", 4711, "boot/1#1");
  const auto copy = study_.scratch() / "copy";
  EXPECT_TRUE(backUp(study_.folder(), copy).verification.isSound());
  auto study = Study::open(copy, study_.clock);
  EXPECT_NO_THROW(Session::resume(study, id_));
  EXPECT_EQ(
      tests::Sql(study_.file("study.db")).text("SELECT station FROM lease"),
      "the-other-laboratory");
}

TEST_F(LeaseTest, ThatCouldNotBeGivenBackIsTakenOverByItsOwnProgram) {
  auto session = std::make_optional(Session::resume(*study_, id_));
  {
    tests::Sql other(study_.file("study.db"));
    other.run("BEGIN IMMEDIATE");
    session.reset();  // waits in vain for the write lock
    other.run("ROLLBACK");
  }
  EXPECT_EQ(tests::Sql(study_.file("study.db")).number("SELECT count(*) FROM lease"), 1);
  EXPECT_FALSE(resuming().happened);
}

TEST_F(LeaseTest, OfALaterHolderIsNotRemovedByAnEarlierOne) {
  auto session = std::make_optional(Session::resume(*study_, id_));
  leave("the-other-laboratory", 4711, "boot/1#1");
  session.reset();
  EXPECT_EQ(
      tests::Sql(study_.file("study.db")).text("SELECT station FROM lease"),
      "the-other-laboratory");
}

}  // namespace lease_test
}  // namespace study::storage

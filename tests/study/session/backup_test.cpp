#include "study/session/backup.h"

#include <fstream>
#include <optional>

#include <gtest/gtest.h>

#include "study/storage/records.h"
#include "tests/study/made_study.h"
#include "tests/study/storage/refusals.h"
#include "tests/study/storage/sql.h"
#include "tests/study/walk.h"

namespace study {
namespace backup_test {

class BackupTest : public testing::Test {
 protected:
  std::string target() const { return study_.scratch() / "copy"; }

  /// The number of files and folders beside the study.
  std::ptrdiff_t neighbours() const {
    using Entries = std::filesystem::directory_iterator;
    return std::distance(Entries(study_.scratch().path()), Entries());
  }

  tests::MadeStudy study_;
};

TEST_F(BackupTest, HasAllDataOfTheStudy) {
  auto session = tests::consenting(*study_, {.cohort = "surgeons"});
  tests::walkToTheEnd(session);
  std::ofstream(study_.file("devices.json")) << "{}";
  const auto copy = backUp(study_.folder(), target());
  EXPECT_TRUE(copy.verification.isSound());
  EXPECT_GT(copy.bytes, 0U);
  SystemClock clock;
  auto again = Study::open(target(), clock, storage::Database::Access::ReadOnly);
  EXPECT_EQ(
      storage::Records(again.database()).answers().size(),
      storage::Records(study_->database()).answers().size());
  EXPECT_EQ(again.uuid(), study_->uuid());
  EXPECT_EQ(tests::contentOf(target() + "/devices.json"), "{}");
  EXPECT_TRUE(std::filesystem::is_directory(target() + "/exports"));
}

TEST_F(BackupTest, IsForItsOwnerAlone) {
  namespace fs = std::filesystem;
  const fs::path from = study_.folder();
  for (const auto mode : {fs::perms(0700), fs::perms(0755)}) {
    fs::permissions(from, mode);
    fs::permissions(from / "study.db", mode & fs::perms(0644));
    const fs::path copy = target() + std::to_string(static_cast<unsigned>(mode));
    backUp(from, copy);
    EXPECT_EQ(fs::status(copy).permissions(), fs::perms(0700));
    for (const auto* name : {"study.db", "traces.db", "identity.db"}) {
      EXPECT_EQ(fs::status(copy / name).permissions(), fs::perms(0600)) << name;
    }
  }
  EXPECT_EQ(fs::status(from / "identity.db").permissions(), fs::perms(0600));
}

TEST_F(BackupTest, VerifiesWhenMadeDuringATrial) {
  std::optional<Session> session(tests::consenting(*study_, {.cohort = "surgeons"}));
  tests::walkTo(*session, StepKind::Trial);
  session->beginTrial();
  study_->traces().add(session->visit(), 0, std::vector<storage::TraceSample>(1000));
  const auto copy = backUp(study_.folder(), target());
  EXPECT_TRUE(copy.verification.isSound());
  const auto id = session->id();
  session.reset();  // a lease is not copied to another computer
  SystemClock clock;
  auto again = Study::open(target(), clock);
  const auto resumed = Session::resume(again, id);
  EXPECT_EQ(resumed.state(), SessionState::Interrupted);
}

TEST_F(BackupTest, IsConsistentWhileOthersWrite) {
  auto session = tests::consenting(*study_, {.cohort = "surgeons"});
  std::size_t atFirst = storage::Records(study_->database()).answers().size();
  bool hasWritten = false;
  backUp(study_.folder(), target(), [&](double, const std::string&) {
    if (hasWritten) return;
    hasWritten = true;
    tests::walkToTheEnd(session);
  });
  ASSERT_TRUE(hasWritten);
  ASSERT_GT(storage::Records(study_->database()).answers().size(), atFirst);
  SystemClock clock;
  auto again = Study::open(target(), clock, storage::Database::Access::ReadOnly);
  EXPECT_EQ(storage::Records(again.database()).answers().size(), atFirst);
}

TEST_F(BackupTest, ReportsDamageAndKeepsTheCopy) {
  auto session = tests::consenting(*study_, {.cohort = "surgeons"});
  tests::walkToTheEnd(session);
  tests::Sql(study_.file("study.db")).run("UPDATE answer SET changes = changes + 1");
  const auto copy = backUp(study_.folder(), target());
  EXPECT_FALSE(copy.verification.isSound());
  EXPECT_TRUE(std::filesystem::exists(target() + "/study.db"));
}

TEST_F(BackupTest, OverwritesNothingAndIsNeverInsideTheStudy) {
  std::filesystem::create_directory(target());
  tests::expectClear(
      tests::refusalOf([&] { backUp(study_.folder(), target()); }), "is there already");
  tests::expectClear(
      tests::refusalOf([&] { backUp(study_.folder(), study_.file("copy")); }),
      "outside of the study");
}

TEST_F(BackupTest, LeavesNoFolderWhenItIsCancelled) {
  const auto before = neighbours();
  int told = 0;
  const auto giveUp = [&](double, const std::string&) {
    if (++told == 5) throw Cancelled();
  };
  EXPECT_THROW(backUp(study_.folder(), target(), giveUp), Cancelled);
  EXPECT_EQ(neighbours(), before);
}

}  // namespace backup_test
}  // namespace study

// A study in an archive without permission to write can be read completely.
#include <unistd.h>

#include <filesystem>
#include <set>

#include <gtest/gtest.h>

#include "study/session/verification.h"
#include "tests/study/made_study.h"
#include "tests/study/storage/refusals.h"
#include "tests/study/walk.h"

namespace study::storage {
namespace sealed_test {

namespace fs = std::filesystem;
using Access = Database::Access;

class SealedTest : public testing::Test {
 protected:
  void SetUp() override { Session::enrol(*study_, {.cohort = "surgeons"}); }
  void TearDown() override { mayWrite(fs::perm_options::add); }

  /// Copies the study as it is on the disk now, and removes all permissions to write.
  std::string seal() {
    fs::create_directory(archive_);
    for (const auto& entry : fs::directory_iterator(study_.folder())) {
      const bool isIndex = entry.path().extension() == ".db-shm";
      if (entry.is_regular_file() && !isIndex) fs::copy(entry.path(), archive_);
    }
    mayWrite(fs::perm_options::remove);
    return archive_;
  }

  void mayWrite(fs::perm_options how) {
    constexpr auto kWrite =
        fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
    if (!fs::exists(archive_)) return;
    for (const auto& entry : fs::directory_iterator(archive_)) {
      fs::permissions(entry.path(), kWrite, how);
    }
    fs::permissions(archive_, kWrite, how);
  }

  std::set<std::string> names() const {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(archive_)) {
      names.insert(entry.path().filename().string());
    }
    return names;
  }

  tests::MadeStudy study_;
  std::string archive_ = study_.scratch() / "100% sealed? yes #1";
};

TEST_F(SealedTest, IsReadAndVerifiedWithoutAddingFiles) {
  const auto events = study_->events().read().size();
  study_.close();
  seal();
  const auto before = names();
  {
    auto study = Study::open(archive_, study_.clock, Access::ReadOnly);
    EXPECT_TRUE(verify(study).isSound());
    EXPECT_EQ(study.events().read().size(), events);
    EXPECT_EQ(names(), before);  // no log, no index, no reserved space
  }
  EXPECT_EQ(names(), before);
}

TEST_F(SealedTest, IsReadWithItsLogOrRefused) {
  const auto events = study_->events().read().size();
  seal();  // while the study is open: its latest changes are in the log
  ASSERT_EQ(names().count("study.db-wal"), 1U);
  const auto refusal = tests::refusalOf([&] {
    auto study = Study::open(archive_, study_.clock, Access::ReadOnly);
    // with permission to write the log can be read
    EXPECT_EQ(study.events().read().size(), events);
  });
  if (refusal.happened) tests::expectClear(refusal, "may not be written");
}

TEST_F(SealedTest, IsNeverWritten) {
  if (geteuid() == 0) GTEST_SKIP() << "nothing is sealed from root";
  study_.close();
  seal();
  const auto refusal = tests::refusalOf([&] { Study::open(archive_, study_.clock); });
  tests::expectClear(refusal, "may not be written");
}

}  // namespace sealed_test
}  // namespace study::storage

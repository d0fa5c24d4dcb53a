#include <gtest/gtest.h>

#include "study/storage/local_disk.h"
#include "tests/study/made_study.h"
#include "tests/study/storage/refusals.h"
#include "tests/study/storage/sql.h"

namespace study::storage {
namespace disk_check_test {

TEST(DiskCheck, MeasuresEveryCommitAndLeavesNoFiles) {
  const tests::ScratchFolder folder;
  const auto times = measureCommits(folder.path(), 5);
  EXPECT_EQ(times.commits, 5);
  EXPECT_GT(times.median, 0.0);
  EXPECT_GE(times.longest, times.median);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(DiskCheck, NamesAFolderThatCannotBeWritten) {
  tests::expectClear(tests::refusalOf([] { measureCommits("/proc/palpate", 1); }), "/proc/palpate");
}

TEST(DiskCheck, FindsNoProblemInAnIntactFile) {
  tests::MadeStudy study;
  EXPECT_EQ(study->database().quickCheckProblems(), "");
}

}  // namespace disk_check_test
}  // namespace study::storage

// palpate-bench collect: that everything arrives. Times are not judged.
#include <filesystem>

#include <gtest/gtest.h>

#include "tests/support/child_process.h"
#include "tests/support/programs.h"
#include "tests/support/scratch_folder.h"

namespace collect_command_test {

TEST(CollectCommand, CountsTheSameOnTheServerAndInTheFolderThatIsPulled) {
  if (!std::filesystem::exists("/usr/lib/postgresql"))
    GTEST_SKIP() << "PostgreSQL is not installed";
  tests::ScratchFolder folder;
  const auto finished = tests::run(
      {tests::program(),
       "bench",
       "collect",
       "--answers",
       "400",
       "--sites",
       "3",
       "--participants",
       "2",
       "--repetitions",
       "1",
       "--disk",
       folder / "",
       "--out",
       folder / "out"});
  ASSERT_EQ(finished.status, 0) << finished.error << finished.out;
  EXPECT_EQ(finished.out.find("FAIL"), std::string::npos) << finished.out;
  for (const auto* name :
       {"collect.html",
        "collect-ingest.csv",
        "collect-growth.csv",
        "collect-counts.csv",
        "collect-pull.csv",
        "collect-sizes.csv",
        "collect-plan.csv"}) {
    EXPECT_TRUE(std::filesystem::exists(folder / (std::string("out/") + name))) << name;
  }
  std::filesystem::remove_all(folder / "out");
  EXPECT_TRUE(std::filesystem::is_empty(folder / ""));
}

}  // namespace collect_command_test

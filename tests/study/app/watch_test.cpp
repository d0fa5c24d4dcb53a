// `palpate stats run --watch`: the tables follow the changes of another process.
#include <csignal>

#include <gtest/gtest.h>

#include "tests/support/child_process.h"
#include "tests/support/programs.h"
#include "tests/support/scratch_folder.h"

namespace watch_test {

/// The lines up to the next warning about looking at interim results.
std::string nextTables(tests::ChildProcess& watching) {
  std::string tables;
  for (std::string line; watching.readLine(line);) {
    tables += line + "\n";
    if (line.rfind("INTERIM", 0) == 0) return tables;
  }
  return tables;
}

TEST(StatsWatch, FollowsTheChangesOfAnotherProcess) {
  tests::ScratchFolder folder;
  const std::string study = folder / "study";
  const auto simulate = [&](const char* participants) {
    const auto finished =
        tests::run({tests::program(), "study", "simulate", study, "--participants", participants});
    ASSERT_EQ(finished.status, 0) << finished.error;
  };
  ASSERT_EQ(
      tests::run({tests::program(), "study", "create", study, "--protocol", "punch-face-validity"})
          .status,
      0);
  simulate("2");
  tests::ChildProcess watching(
      {tests::program(), "stats", "run", study, "--watch", "--run-mode", "simulated"});
  const auto before = nextTables(watching);
  simulate("5");
  auto after = nextTables(watching);
  // The tables may be printed after each of the five, and between the changes of one.
  const auto everybody = tests::run(
      {tests::program(),
       "stats",
       "run",
       study,
       "--profile",
       "as-published",
       "--run-mode",
       "simulated"});
  const auto rowOf = [](const std::string& tables) -> std::string {
    const auto at = tables.find("\nOrthopaedic surgeons   ");
    return at == std::string::npos ? "" : tables.substr(at, tables.find('\n', at + 1) - at);
  };
  for (int looks = 0; looks < 40 && rowOf(after) != rowOf(everybody.out); ++looks) {
    after = nextTables(watching);
  }
  EXPECT_NE(rowOf(before), "") << before;
  EXPECT_NE(rowOf(before), rowOf(after));
  EXPECT_EQ(rowOf(after), rowOf(everybody.out));
  watching.kill(SIGINT);
  EXPECT_EQ(watching.finish().status, -SIGINT);
}

TEST(StatsWatch, ShowsTheDeclaredTest) {
  tests::ScratchFolder folder;
  const std::string study = folder / "study";
  const std::vector<std::vector<std::string>> steps{
      {tests::program(), "study", "create", study, "--protocol", "punch-counterbalanced"},
      {tests::program(), "study", "simulate", study, "--participants", "3"}};
  for (const auto& step : steps) ASSERT_EQ(tests::run(step).status, 0);
  tests::ChildProcess watching(
      {tests::program(), "stats", "run", study, "--watch", "--run-mode", "simulated"});
  const auto tables = nextTables(watching);
  EXPECT_NE(tables.find("declared, confirmatory: paired t-test"), std::string::npos) << tables;
  EXPECT_EQ(tables.find("Welch"), std::string::npos) << tables;
  watching.kill(SIGINT);
  watching.finish();
}

}  // namespace watch_test

// palpate-bench stats: times the computation of a study's table.
#include <filesystem>

#include <gtest/gtest.h>

#include "study/bench/synthetic_study.h"
#include "study/results/pooled_results.h"
#include "tests/support/child_process.h"
#include "tests/support/programs.h"
#include "tests/support/scratch_folder.h"

namespace study::bench {
namespace stats_command_test {

TEST(SyntheticStudy, HasItsCountsInItsResults) {
  constexpr std::int64_t kAnswers = 500;
  tests::ScratchFolder folder;
  const auto made = makeSyntheticStudy(folder / "", kAnswers);
  EXPECT_EQ(made.sessions, 28);
  SystemClock clock;
  auto study = Study::open(made.folder, clock, storage::Database::Access::ReadOnly);
  const auto pooled = pooledResults(study, RunMode::Simulated);
  const auto results = computeResults(study, RunMode::Simulated);
  const auto& cohorts = results.families.at(0).cohorts;
  ASSERT_EQ(cohorts.size(), 2U);
  std::uint64_t total = 0;
  for (std::size_t i = 0; i < cohorts.size(); ++i) {
    const auto& conditions = pooled.families.at(0).cohorts.at(i).conditions;
    ASSERT_EQ(conditions.size(), 3U);
    for (std::size_t j = 0; j < conditions.size(); ++j) {
      EXPECT_EQ(
          conditions[j].answers.points().value(), cohorts[i].table.sampleOf(j).points().value());
      total += conditions[j].answers.total();
    }
  }
  EXPECT_EQ(total, static_cast<std::uint64_t>(kAnswers));
  EXPECT_EQ(study.database().integrityCheckProblems(), "");
}

TEST(StatsCommand, CountsEveryAnswerAndLeavesNoFiles) {
  tests::ScratchFolder folder;
  const auto finished = tests::run(
      {tests::program(),
       "bench",
       "stats",
       "--answers",
       "2000",
       "--repetitions",
       "2",
       "--disk",
       folder / "",
       "--out",
       folder / "out"});
  ASSERT_EQ(finished.status, 0) << finished.error;
  const auto sizes = tests::contentOf(folder / "out/stats-sizes.csv");
  EXPECT_NE(sizes.find("\n2000,2000,"), std::string::npos) << sizes;
  EXPECT_TRUE(std::filesystem::exists(folder / "out/stats.html"));
  EXPECT_TRUE(std::filesystem::exists(folder / "out/stats-times.csv"));
  std::filesystem::remove_all(folder / "out");
  EXPECT_TRUE(std::filesystem::is_empty(folder / ""));
}

}  // namespace stats_command_test
}  // namespace study::bench

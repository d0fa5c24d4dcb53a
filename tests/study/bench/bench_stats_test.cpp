// What `palpate bench stats` measures is the table that everybody else gets, in its short form.
#include "study/bench/bench_stats.h"

#include <filesystem>
#include <fstream>
#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "study/bench/bench_stats_study.h"
#include "study/results/pooled_answers.h"
#include "study/storage/coded_answers.h"
#include "tests/support/child_process.h"
#include "tests/support/programs.h"
#include "tests/support/scratch_folder.h"

namespace study::app {
namespace bench_stats_test {

TEST(SyntheticStudy, GivesTheSameCountsByItsRowsAndByItsNumbers) {
  constexpr std::int64_t kAnswers = 500;
  tests::ScratchFolder folder;
  const auto made = makeSyntheticStudy(folder / "", kAnswers, true);
  EXPECT_EQ(made.sessions, 28);
  SystemClock clock;
  auto study = Study::open(made.folder, clock, storage::Database::Access::ReadOnly);
  const PooledAnswers pooled(study, RunMode::Simulated);
  const auto results = computeResults(study, RunMode::Simulated);
  const auto& cohorts = results.families.at(0).cohorts;
  ASSERT_EQ(cohorts.size(), 2U);
  std::uint64_t total = 0;
  for (std::size_t i = 0; i < cohorts.size(); ++i) {
    const auto conditions = pooled.of(0, i);
    ASSERT_EQ(conditions.size(), 3U);
    for (std::size_t j = 0; j < conditions.size(); ++j) {
      EXPECT_EQ(conditions[j].counts, cohorts[i].table.countsOf(j));
      total += conditions[j].counts.total();
    }
  }
  EXPECT_EQ(total, static_cast<std::uint64_t>(kAnswers));
  EXPECT_TRUE(storage::CodedAnswers(study.database()).misplaced().empty());
  EXPECT_EQ(study.database().integrityProblems(), "");

  std::ifstream csv(made.answers);
  std::int64_t lines = 0;
  for (std::string line; std::getline(csv, line);) ++lines;
  EXPECT_EQ(lines, kAnswers + 1);
}

TEST(BenchStats, TimesWhatItSaysAndKeepsNothing) {
  tests::ScratchFolder folder;
  const auto finished = tests::run(
      {tests::program(),
       "bench",
       "stats",
       "--answers",
       "2000",
       "--repetitions",
       "2",
       "--edits",
       "3",
       "--disk",
       folder / "",
       "--out",
       folder / "out",
       "--json"});
  ASSERT_EQ(finished.status, 0) << finished.error;
  const auto json = nlohmann::json::parse(finished.out);
  EXPECT_EQ(json["synthetic"], true);
  EXPECT_EQ(json["answers"], 2000);
  EXPECT_EQ(json["table"]["time"]["times"], 2);
  EXPECT_EQ(json["table"]["rows"].size(), 6U);
  EXPECT_EQ(json["after_an_edit"]["times"], 3);
  EXPECT_EQ(json["same_after_edits"], true);
  EXPECT_GT(json["memory_mb"].get<double>(), 1.0);
  EXPECT_TRUE(std::filesystem::exists(folder / "out/stats.html"));
  EXPECT_TRUE(std::filesystem::exists(folder / "out/stats-times.csv"));
  std::filesystem::remove_all(folder / "out");
  EXPECT_TRUE(std::filesystem::is_empty(folder / ""));
}

TEST(BenchStats, SaysWhichPackagesBringPeersThatAreNotThere) {
  const auto finished = tests::run(
      {tests::program(),
       "bench",
       "stats",
       "--answers",
       "200",
       "--repetitions",
       "1",
       "--edits",
       "1",
       "--peers"},
      {"PATH=/nowhere"});
  ASSERT_EQ(finished.status, 0) << finished.error;
  EXPECT_NE(
      finished.out.find("R data.table, from CSV: not measured, there is no Rscript; on Debian: apt "
                        "install r-base-core r-cran-data.table r-cran-rsqlite"),
      std::string::npos)
      << finished.out;
}

TEST(BenchStats, ComparesTablesWhicheverWayRoundTheirRowsAre) {
  const TableRow row{"c", "a", "b", 1.0, 2.0, 0.5, 0.25, -3.0, 0.01};
  const TableRow turned{"c", "b", "a", 2.0, 1.0, 0.25, 0.5, 3.0, 0.01};
  EXPECT_EQ(largestDifference({row}, {turned}), 0.0);
  auto other = turned;
  other.t = 3.3;
  EXPECT_NEAR(largestDifference({row}, {other}), 0.1, 1e-12);
  other.first = "d";
  EXPECT_EQ(largestDifference({row}, {other}), std::numeric_limits<double>::infinity());
  EXPECT_EQ(largestDifference({row}, {}), std::numeric_limits<double>::infinity());
  EXPECT_EQ(quantileOf({3.0, 1.0, 2.0}, 0.5), 2.0);
  EXPECT_EQ(quantileOf({3.0, 1.0, 2.0}, 0.99), 3.0);
}

}  // namespace bench_stats_test
}  // namespace study::app

// `palpate bench` starts palpate-bench: its options, pages and tables.
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "tests/study/app/palpate_command.h"
#include "tests/support/test_data.h"

namespace bench_command_test {

using tests::kTheCallIsWrong;
using tests::linesOf;
using tests::palpate;

class BenchCommand : public tests::StudyOfCommands {};

TEST_F(BenchCommand, PassesAllOptionsOnToTheBenchmarks) {
  const auto help = palpate({"bench", "accuracy", "--help"});
  EXPECT_EQ(help.status, 0) << help.error;
  EXPECT_NE(help.out.find("--family"), std::string::npos) << help.out;
  const auto wrong = palpate({"bench", "accuracy", "--processes=0"});
  EXPECT_EQ(wrong.status, kTheCallIsWrong);
  EXPECT_NE(wrong.error.find("palpate-bench: --processes"), std::string::npos) << wrong.error;
  const auto unknown = palpate({"bench", "study"});
  EXPECT_EQ(unknown.status, kTheCallIsWrong);
  EXPECT_NE(unknown.error.find("There are: accuracy, stability"), std::string::npos)
      << unknown.error;
}

TEST_F(BenchCommand, WritesBenchmarksAsAPageTablesAndFigures) {
  const std::string folder = folder_ / "bench";
  const auto accuracy =
      palpate({"bench", "accuracy", "--processes", "1", "--family", "encoders", "--out", folder});
  ASSERT_EQ(accuracy.status, 0) << accuracy.error;
  EXPECT_NE(accuracy.error.find("process 1 of 1: encoder"), std::string::npos);
  const auto stability = palpate({"bench", "stability", "--effort", "0.01", "--out", folder});
  ASSERT_EQ(stability.status, 0) << stability.out << stability.error;
  EXPECT_NE(stability.out.find(", 0 failed."), std::string::npos) << stability.out;
  for (const char* name : {"accuracy.html", "stability.html"}) {
    const auto page = tests::contentOf(std::filesystem::path(folder) / name);
    EXPECT_NE(page.find("processor"), std::string::npos) << name;
    EXPECT_NE(page.find("<table>"), std::string::npos) << name;
  }
  const auto encoders =
      linesOf(tests::contentOf(std::filesystem::path(folder) / "accuracy-encoders.csv"));
  EXPECT_EQ(encoders.size(), 1U + 6U * 3U * 3U * 2U);  // scenes, speeds, resolutions, two errors
  const auto walls =
      linesOf(tests::contentOf(std::filesystem::path(folder) / "stability-walls.csv"));
  EXPECT_GT(walls.size(), 100U);
}

TEST_F(BenchCommand, MeasuresTheClockAndTheRecorder) {
  const auto servo = palpate(
      {"bench",
       "servo",
       "--rates",
       "1000",
       "--seconds",
       "0.2",
       "--recording",
       "0.3",
       "--disk",
       folder_.path().string()});
  ASSERT_EQ(servo.status, 0) << servo.error;
  EXPECT_NE(servo.out.find("palpate: chunks of a second"), std::string::npos) << servo.out;
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));  // no file is left
}

}  // namespace bench_command_test

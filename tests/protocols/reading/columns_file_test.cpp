#include <string>

#include <gtest/gtest.h>

#include "protocols/reading/recording_file.h"
#include "tests/support/says.h"

namespace protocols {
namespace columns_file_test {

using questionnaires::Problems;
using tests::says;

std::string problemsOf(const std::string& json) {
  Problems problems;
  EXPECT_FALSE(readColumns(json, problems).has_value());
  return questionnaires::describe(problems.all());
}

TEST(ColumnsFile, SaysWhatEveryColumnMeans) {
  Problems problems;
  const auto file = readColumns(
      R"({"format": "palpate-columns-1", "skip_lines": 3, "separator": "semicolon",
          "time": {"column": "Zeit", "unit": "ms"},
          "travel": {"column": 4, "open": 12.5, "closed": -3},
          "force": {"column": "U", "unit": "V", "zero": 0.1, "factor": -1, "saturates_at": -4.9},
          "calibration": "sensor.json"})",
      problems);
  ASSERT_TRUE(file.has_value()) << questionnaires::describe(problems.all());
  const auto& columns = file->columns;
  EXPECT_EQ(columns.skippedLines, 3U);
  EXPECT_EQ(columns.separator, ';');
  ASSERT_TRUE(columns.time.has_value());
  EXPECT_EQ(columns.time->heading, "Zeit");
  EXPECT_EQ(columns.millisecondsPerTime, 1.0);
  EXPECT_EQ(columns.travel.number, 4U);
  EXPECT_EQ(columns.open, 12.5);
  EXPECT_EQ(columns.closed, -3.0);
  EXPECT_EQ(columns.readingUnit, "V");
  EXPECT_EQ(columns.forceZero, 0.1);
  EXPECT_EQ(columns.forceFactor, -1.0);
  EXPECT_EQ(columns.saturatesAt, -4.9);
  EXPECT_EQ(file->calibrationFile, "sensor.json");
}

TEST(ColumnsFile, TurnsUnitsOfForceIntoNewtons) {
  Problems problems;
  const auto file = readColumns(
      R"({"format": "palpate-columns-1", "time": {"rate_hz": 2000},
          "travel": {"column": "x", "open": 0, "closed": 10},
          "force": {"column": "F", "unit": "kN", "factor": -1}})",
      problems);
  ASSERT_TRUE(file.has_value()) << questionnaires::describe(problems.all());
  EXPECT_EQ(file->columns.rate, 2000.0);
  EXPECT_FALSE(file->columns.time.has_value());
  EXPECT_EQ(file->columns.readingUnit, "N");
  EXPECT_EQ(file->columns.forceFactor, -1000.0);
}

TEST(ColumnsFile, NamesEveryMistakeInOneReading) {
  const auto problems = problemsOf(
      R"({"format": "palpate-columns-2", "time": {"column": "t", "rate_hz": 5},
          "travel": {"column": "x", "open": 3, "closed": 3},
          "force": {"column": 0, "unit": "N", "factor": 0, "offset": 1}, "calibration": "s.json"})");
  EXPECT_TRUE(says(problems, "this program reads palpate-columns-1"));
  EXPECT_TRUE(says(problems, "either a column or a rate"));
  EXPECT_TRUE(says(problems, "$.travel.closed"));
  EXPECT_TRUE(says(problems, "offset"));
}

TEST(ColumnsFile, RefusesOneColumnForTheTravelAndTheForce) {
  EXPECT_TRUE(says(
      problemsOf(
          R"({"format": "palpate-columns-1", "time": {"column": "t", "unit": "s"},
              "travel": {"column": "x", "open": 0, "closed": 10},
              "force": {"column": "x", "unit": "N"}})"),
      "$.force.column: this is the column of the travel or of the time, too"));
}

TEST(ColumnsFile, RefusesACalibrationOfNewtons) {
  EXPECT_TRUE(says(
      problemsOf(
          R"({"format": "palpate-columns-1", "time": {"column": "t", "unit": "s"},
              "travel": {"column": "x", "open": 0, "closed": 10},
              "force": {"column": "F", "unit": "N"}, "calibration": "s.json"})"),
      "in newtons already"));
}

TEST(CalibrationFile, ComesBackAsItWas) {
  haptics::recordings::CalibrationTable table{.source = "loads.csv", .readingUnit = "V"};
  for (int i = 0; i < 8; ++i) table.points.push_back({0.3 * i, 1.1 * i + 0.01 * i * i});
  auto fit = haptics::recordings::fitCalibration(table, 3, false);
  fit.calibration.name = "load-cell-2";
  Problems problems;
  const auto back = readCalibration(calibrationAsJson(fit, "loads.csv", "ab"), problems);
  ASSERT_TRUE(back.has_value()) << questionnaires::describe(problems.all());
  EXPECT_EQ(back->name, "load-cell-2");
  EXPECT_EQ(back->unit, "V");
  EXPECT_EQ(back->coefficients, fit.calibration.coefficients);
  EXPECT_EQ(back->lowest, fit.calibration.lowest);
  EXPECT_EQ(back->highest, fit.calibration.highest);
}

TEST(CalibrationFile, IsRefusedWithItsMistakes) {
  Problems problems;
  EXPECT_FALSE(readCalibration(
      R"({"format": "palpate-calibration-1", "name": "a", "unit": "V", "coefficients_n": [1],
          "range": [4, 2]})",
      problems));
  const auto words = questionnaires::describe(problems.all());
  EXPECT_TRUE(says(words, "2 to 6 coefficients"));
  EXPECT_TRUE(says(words, "$.range"));
}

}  // namespace columns_file_test
}  // namespace protocols

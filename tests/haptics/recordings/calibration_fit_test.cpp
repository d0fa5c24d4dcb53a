#include <cmath>
#include <fstream>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "haptics/recordings/force_calibration.h"
#include "haptics/recordings/recording.h"
#include "tests/support/complaint.h"
#include "tests/support/says.h"
#include "tests/support/test_data.h"

namespace haptics::recordings {
namespace calibration_fit_test {

using tests::says;

nlohmann::json golden() {
  std::ifstream file(tests::testData("recordings/golden.json"));
  return nlohmann::json::parse(file)["calibration"];
}

CalibrationTable goldenTable(const nlohmann::json& from) {
  CalibrationTable table{.source = "loads.csv", .readingUnit = "counts"};
  for (std::size_t i = 0; i < from["readings"].size(); ++i) {
    table.points.push_back({from["readings"][i].get<double>(), from["forces_n"][i].get<double>()});
  }
  return table;
}

std::string complaintAbout(const std::string& text, const CalibrationColumns& columns = {}) {
  return tests::complaintOf([&] { readCalibrationTable(text, "loads.csv", columns); });
}

TEST(CalibrationFit, IsThePolynomialOfNumPyAtEveryOrder) {
  const auto expected = golden();
  const auto table = goldenTable(expected);
  ASSERT_EQ(expected["fits"].size(), 10U);
  for (const auto& row : expected["fits"]) {
    const auto fit =
        fitCalibration(table, row["order"].get<int>(), row["through_zero"].get<bool>());
    EXPECT_NEAR(fit.rms, row["rms_n"].get<double>(), 1e-10);
    EXPECT_NEAR(fit.standardError.value(), row["standard_error_n"].get<double>(), 1e-10);
    EXPECT_NEAR(forceOf(500.0, fit.calibration), row["at_500_n"].get<double>(), 1e-9);
    ASSERT_EQ(fit.residuals.size(), row["residuals_n"].size());
    for (std::size_t i = 0; i < fit.residuals.size(); ++i) {
      EXPECT_NEAR(fit.residuals[i], row["residuals_n"][i].get<double>(), 1e-9) << row["order"];
    }
  }
}

TEST(CalibrationFit, HasNoStandardErrorThroughEveryPoint) {
  CalibrationTable table{.source = "made", .readingUnit = "counts"};
  table.points = {{10.0, 1.0}, {20.0, 2.0}, {30.0, 5.0}};
  EXPECT_TRUE(fitCalibration(table, 1, false).standardError);
  EXPECT_FALSE(fitCalibration(table, 2, false).standardError);
}

TEST(CalibrationFit, GivesBackAPolynomialThatTheLoadsLieOn) {
  CalibrationTable table{.source = "made", .readingUnit = "counts"};
  for (int r = 0; r <= 1000; r += 100)
    table.points.push_back({1.0 * r, forceOf(r, publishedCalibration())});
  const auto fit = fitCalibration(table, 3, true);
  EXPECT_EQ(fit.calibration.coefficients[0], 0.0);
  EXPECT_NEAR(fit.calibration.coefficients[1], 0.7815 * 9.81e-3, 1e-12);
  EXPECT_NEAR(fit.calibration.coefficients[2], -2e-4 * 9.81e-3, 1e-14);
  EXPECT_NEAR(fit.calibration.coefficients[3], 3e-7 * 9.81e-3, 1e-17);
  EXPECT_LT(fit.rms, 1e-12);
  EXPECT_TRUE(fit.isRising);
  EXPECT_EQ(fit.calibration.lowest, 0.0);
  EXPECT_EQ(fit.calibration.highest, 1000.0);
}

TEST(CalibrationFit, SaysWhereMoreReadingWouldBeLessForce) {
  const CalibrationTable table{
      .source = "made", .readingUnit = "V", .points = {{0, 0}, {1, 2}, {2, 3}, {3, 2.5}, {4, 1}}};
  EXPECT_FALSE(fitCalibration(table, 2, false).isRising);
}

TEST(CalibrationFit, NeedsAsManyDifferentReadingsAsCoefficients) {
  const CalibrationTable table{
      .source = "made", .readingUnit = "V", .points = {{0, 0}, {1, 2}, {1, 2.1}, {2, 3}}};
  EXPECT_NO_THROW(fitCalibration(table, 2, false));
  EXPECT_THROW(fitCalibration(table, 3, false), base::UserError);
  EXPECT_THROW(
      fitCalibration(table, 3, true), base::UserError);  // a reading of 0 says nothing then
  EXPECT_THROW(fitCalibration(table, 0, false), std::invalid_argument);
  EXPECT_THROW(fitCalibration(table, 6, false), std::invalid_argument);
}

TEST(CalibrationTable, TakesUnitsFromTheHeads) {
  const auto table = readCalibrationTable("Sensor [mV];Last [g]\r\n0,5;0\r\n12;100\r\n", "a.csv");
  EXPECT_EQ(table.readingUnit, "mV");
  ASSERT_EQ(table.points.size(), 2U);
  EXPECT_EQ(table.points[0].reading, 0.5);
  EXPECT_DOUBLE_EQ(table.points[1].force, 0.980665);
  EXPECT_EQ(readCalibrationTable("u_v,load_n\n1,2\n", "b.csv").readingUnit, "V");
}

TEST(CalibrationTable, TakesColumnsAndUnitsThatAreNamed) {
  const auto table = readCalibrationTable(
      "no,load,adc\n1,2,300\n",
      "c.csv",
      {.reading = "adc", .force = "load", .readingUnit = "counts", .forceUnit = "kg"});
  EXPECT_EQ(table.points[0].reading, 300.0);
  EXPECT_DOUBLE_EQ(table.points[0].force, 2.0 * 9.80665);
}

TEST(CalibrationTable, SaysWhatIsMissing) {
  EXPECT_TRUE(says(complaintAbout("adc,load [N]\n1,2\n"), "readings in 'loads.csv' have no unit"));
  EXPECT_TRUE(says(complaintAbout("adc [V],load\n1,2\n"), "no unit"));
  EXPECT_TRUE(says(complaintAbout("adc [V],load [lbf]\n1,2\n"), "an unknown unit, 'lbf'"));
  EXPECT_TRUE(says(complaintAbout("adc [V],load [N]\n1,2\n1,x\n"), "Line 3"));
  EXPECT_TRUE(says(complaintAbout("adc [V],load [N]\n", {.force = "mass"}), "no column 'mass'"));
  EXPECT_TRUE(says(complaintAbout(""), "is empty"));
}

}  // namespace calibration_fit_test
}  // namespace haptics::recordings

#include "haptics/recordings/force_calibration.h"

#include <gtest/gtest.h>

namespace haptics::recordings {
namespace force_calibration_test {

TEST(ForceCalibration, IsEquationOneOfThePaper) {
  EXPECT_EQ(forceOf(0.0, publishedCalibration()), 0.0);
  EXPECT_NEAR(forceOf(1023.0, publishedCalibration()), 8.940328, 5e-7);
  EXPECT_NEAR(forceOf(639.0, publishedCalibration()), 4.865656, 5e-7);
}

TEST(ForceCalibration, KnowsTheRecordersOwnCubic) {
  EXPECT_NEAR(forceOf(1023.0, recorder2021Calibration()), 7.36, 5e-3);
  EXPECT_NEAR(forceOf(144.0, recorder2021Calibration()), 99.23 * 9.81e-3, 5e-5);
}

TEST(ForceCalibration, LeavesNewtonsAsTheyAre) {
  EXPECT_EQ(forceOf(3.25, newtons()), 3.25);
  EXPECT_EQ(forceOf(-0.1, newtons()), -0.1);
  EXPECT_FALSE(isExtrapolated(1e6, newtons()));
}

TEST(ForceCalibration, CoversThePublishedSensorUpTo869Counts) {
  EXPECT_FALSE(isExtrapolated(0.0, publishedCalibration()));
  EXPECT_FALSE(isExtrapolated(869.0, publishedCalibration()));
  EXPECT_TRUE(isExtrapolated(870.0, publishedCalibration()));
}

TEST(ForceCalibration, KnowsUnitsOfForceAndOfWeight) {
  EXPECT_EQ(newtonsIn("N"), 1.0);
  EXPECT_EQ(newtonsIn("mN"), 1e-3);
  EXPECT_EQ(newtonsIn("kN"), 1e3);
  EXPECT_DOUBLE_EQ(newtonsIn("kg"), 9.80665);
  EXPECT_DOUBLE_EQ(newtonsIn("g"), 9.80665e-3);
  EXPECT_EQ(newtonsIn("V"), 0.0);
  EXPECT_EQ(newtonsIn(""), 0.0);
}

}  // namespace force_calibration_test
}  // namespace haptics::recordings

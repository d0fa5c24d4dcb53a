#include <gtest/gtest.h>

#include "haptics/recordings/trace.h"

namespace haptics::recordings {
namespace force_calibration_test {

TEST(ForceCalibration, IsEquationOneOfThePaper) {
  EXPECT_EQ(forceOf(0.0, ForceCalibration::PaperEq1), 0.0);
  EXPECT_NEAR(forceOf(1023.0, ForceCalibration::PaperEq1), 8.940328, 5e-7);
  EXPECT_NEAR(forceOf(639.0, ForceCalibration::PaperEq1), 4.865656, 5e-7);
}

TEST(ForceCalibration, KnowsTheRecordersOwnCubic) {
  // 750 g at full scale, by the older cubic of the published recordings; their first row has
  // 99.23 g at a reading of 144.
  EXPECT_NEAR(forceOf(1023.0, ForceCalibration::Recorder2021), 7.36, 5e-3);
  EXPECT_NEAR(forceOf(144.0, ForceCalibration::Recorder2021), 99.23 * 9.81e-3, 5e-5);
}

TEST(ForceCalibration, IsCalledAsResearchersCallIt) {
  EXPECT_EQ(nameOf(ForceCalibration::PaperEq1), "paper-eq1");
  EXPECT_EQ(nameOf(ForceCalibration::Recorder2021), "recorder-2021");
  EXPECT_EQ(forceCalibrationNamed("paper-eq1"), ForceCalibration::PaperEq1);
  EXPECT_EQ(forceCalibrationNamed("recorder-2021"), ForceCalibration::Recorder2021);
  EXPECT_FALSE(forceCalibrationNamed("Paper-Eq1"));
}

}  // namespace force_calibration_test
}  // namespace haptics::recordings

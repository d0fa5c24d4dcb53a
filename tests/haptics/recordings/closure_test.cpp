#include <string>

#include <gtest/gtest.h>

#include "haptics/recordings/cut_import.h"
#include "haptics/recordings/recording.h"
#include "tests/haptics/recordings/made_recording.h"

namespace haptics::recordings {
namespace closure_test {

RecordingSurvey summariseCuts(const tests::MadeRecording& made) {
  const Recording recording = readRecording(tests::textOf(made));
  const Trace trace = traceOf(recording, publishedCalibration(), TravelFilter{});
  return recordings::summariseCuts(recording, trace);
}

/// Rows with these travels, 3 ms apart, without a force.
std::vector<Closure> closuresAlong(const std::vector<double>& travels) {
  Recording recording;
  for (const double travel : travels) {
    recording.rows.push_back(
        {.travel = travel, .time = 3.0 * static_cast<double>(recording.rows.size())});
  }
  return closuresOf(
      recording,
      traceOf(recording, publishedCalibration(), TravelFilter{TravelFilter::Kind::None}));
}

TEST(Closure, IsAboveSevenUntilBelowFour) {
  const auto closures = closuresAlong({0, 4, 4.1, 7, 7.1, 9, 5, 4, 3.9, 0, 8, 3, 0});

  ASSERT_EQ(closures.size(), 2U);
  EXPECT_EQ(closures[0].rows, (RowRange{2, 9}));  // the last 4 before it, the first 3.9 after it
  EXPECT_EQ(closures[1].rows, (RowRange{10, 12}));
  EXPECT_TRUE(closures[0].isComplete);
  EXPECT_DOUBLE_EQ(closures[0].start, 0.003);
  EXPECT_DOUBLE_EQ(closures[0].duration, 0.021);
}

TEST(Closure, IsNotCompleteAtTheEndsOfARecording) {
  const auto closures = closuresAlong({9, 3, 0, 8, 0, 8, 9});
  ASSERT_EQ(closures.size(), 3U);
  EXPECT_EQ(closures[0].rows, (RowRange{1, 2}));
  EXPECT_FALSE(closures[0].isComplete);
  EXPECT_TRUE(closures[1].isComplete);
  EXPECT_EQ(closures[2].rows, (RowRange{5, 7}));
  EXPECT_FALSE(closures[2].isComplete);
}

TEST(Closure, IsNotCompleteIfTheInstrumentWasLaidDownClosed) {
  std::vector<double> travels{0, 5};
  travels.insert(travels.end(), 1400, 9.0);  // 4.2 s
  travels.insert(travels.end(), {3, 0});
  EXPECT_FALSE(closuresAlong(travels).at(0).isComplete);
}

TEST(Closure, ClosesFromTheLeastTravelBeforeItToTheLargestWithin) {
  const auto closures = closuresAlong({3, 1, 0.5, 0.5, 3, 4.5, 8, 10, 10, 9, 3, 2, 1, 6, 8, 3});
  ASSERT_EQ(closures.size(), 2U);
  EXPECT_EQ(closures[0].closing, (RowRange{4, 8}));
  EXPECT_EQ(closures[1].closing, (RowRange{13, 15}));
}

TEST(Closure, HasTheLandmarksOfItsCut) {
  const RecordingSurvey survey = summariseCuts({.scales = {1.0, 1.0}});

  ASSERT_EQ(survey.closures.size(), 2U);
  for (const Closure& closure : survey.closures) {
    ASSERT_TRUE(closure.landmarks.yield && closure.landmarks.bottomOut);
    EXPECT_NEAR(closure.landmarks.interception->travel, 3.9, 0.3);
    EXPECT_NEAR(closure.landmarks.yield->travel, 7.2, 0.1);
    EXPECT_NEAR(closure.landmarks.yield->force, 4.4, 0.01);
    EXPECT_NEAR(closure.landmarks.bottomOut->travel, 10.3, 0.1);
    EXPECT_NEAR(closure.landmarks.bottomOut->force, 3.2, 0.01);
    EXPECT_NEAR(closure.landmarks.opening->force, 5.0, 0.01);
  }
}

TEST(RecordingSurvey, WarnsOfWhatACutWouldInherit) {
  const RecordingSurvey survey =
      summariseCuts({.scales = {1.0, 2.0}, .bias = 0.5, .ending = "1\t0."});

  EXPECT_EQ(survey.rows, 100U + 2U * (201U + 201U + 100U));
  EXPECT_NEAR(survey.sampling.rate, 1000.0 / 3.0, 1e-9);
  EXPECT_NEAR(survey.sampling.stepMin, 0.003, 1e-12);
  EXPECT_NEAR(survey.sampling.stepMax, 0.003, 1e-12);
  EXPECT_NEAR(survey.minForce, 0.5, 0.005);
  EXPECT_NEAR(survey.maxForce, 8.940328, 5e-7);
  EXPECT_GT(survey.saturatedRows, 0U);
  EXPECT_GE(survey.uncalibratedRows, survey.saturatedRows);
  EXPECT_EQ(survey.refusedLines, 1U);
  EXPECT_FALSE(survey.closures.at(0).isSaturated());
  EXPECT_TRUE(survey.closures.at(1).isSaturated());
}

TEST(Sampling, IsNothingForARecordingWithoutTime) {
  EXPECT_EQ(samplingOf(readRecording("1 0.7 450 0.5 100")).rate, 0.0);
  EXPECT_EQ(samplingOf(readRecording("1 0.7 450 0.5 100\n1 0.7 450 0.5 100")).rate, 0.0);
}

}  // namespace closure_test
}  // namespace haptics::recordings

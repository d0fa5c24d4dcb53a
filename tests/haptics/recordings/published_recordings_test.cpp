#include <algorithm>
#include <cmath>
#include <fstream>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "haptics/recordings/cut_import.h"
#include "haptics/recordings/recording.h"
#include "tests/support/test_data.h"

// The eight published recordings (docs/references.md, [punch-code]), against the numbers in
// punch/measured.json of the fetched data, which a separate script found in them.

namespace haptics::recordings {
namespace published_recordings_test {

/// A recording of the data set and what it is known to hold.
struct Published {
  std::string file;
  std::size_t refused;
  std::size_t saturated;
  // Landmarks found in complete closures without a saturated row; looked at one by one in a plot.
  std::size_t interceptions;
  std::size_t yields;
  std::size_t bottomOuts;
  std::size_t openings;
};

std::ostream& operator<<(std::ostream& out, const Published& published) {
  return out << published.file;
}

class PublishedRecording : public testing::TestWithParam<Published> {
 protected:
  static std::string path() { return "punch/" + GetParam().file; }

  static nlohmann::json measured() {
    std::ifstream stream(tests::fetchedData("punch/measured.json"));
    for (const nlohmann::json& entry : nlohmann::json::parse(stream)) {
      if (entry.at("file") == GetParam().file) return entry;
    }
    throw std::logic_error("not measured: " + GetParam().file);
  }
};

double millimetric(double value) {
  return std::round(value * 1e6) / 1e6;
}

TEST_P(PublishedRecording, HasTheRowsThatWereMeasured) {
  SKIP_WITHOUT_FETCHED_DATA(path());
  const nlohmann::json expected = measured();
  const Recording recording = readRecordingFile(tests::fetchedData(path()));

  EXPECT_EQ(recording.rows.size(), expected.at("rows").get<std::size_t>());
  EXPECT_EQ(recording.refusedCount, expected.at("rejected_lines").get<std::size_t>());
  EXPECT_EQ(recording.refusedCount, GetParam().refused);
  EXPECT_EQ(recording.rows.front().time, expected.at("first_ms").get<double>());
  EXPECT_EQ(recording.rows.back().time, expected.at("last_ms").get<double>());
}

TEST_P(PublishedRecording, WasSampledAsMeasured) {
  SKIP_WITHOUT_FETCHED_DATA(path());
  const nlohmann::json expected = measured();
  const Sampling sampling = samplingOf(readRecordingFile(tests::fetchedData(path())));

  EXPECT_NEAR(sampling.rate, expected.at("rate_hz").get<double>(), 1e-4);
  EXPECT_NEAR(sampling.stepMin * 1e3, expected.at("step_ms").at("min").get<double>(), 1e-9);
  EXPECT_NEAR(sampling.stepMax * 1e3, expected.at("step_ms").at("max").get<double>(), 1e-9);
}

TEST_P(PublishedRecording, IsSurveyedAsMeasured) {
  SKIP_WITHOUT_FETCHED_DATA(path());
  const nlohmann::json expected = measured();
  const Recording recording = readRecordingFile(tests::fetchedData(path()));
  const Trace trace = traceOf(recording, publishedCalibration(), TravelFilter{});
  const RecordingSurvey survey = summariseCuts(recording, trace);

  const auto& raw = expected.at("raw_fsr");
  EXPECT_EQ(survey.saturatedRows, raw.at("saturated_rows").get<std::size_t>());
  EXPECT_EQ(survey.saturatedRows, GetParam().saturated);
  EXPECT_EQ(millimetric(survey.minForce), expected.at("force_n").at("min").get<double>());
  EXPECT_EQ(millimetric(survey.maxForce), expected.at("force_n").at("max").get<double>());
  EXPECT_EQ(survey.distinctTravels, expected.at("travel").at("distinct").get<std::size_t>());
}

TEST_P(PublishedRecording, HasTheClosuresThatWereMeasured) {
  SKIP_WITHOUT_FETCHED_DATA(path());
  const nlohmann::json expected = measured().at("each_closure");
  const Recording recording = readRecordingFile(tests::fetchedData(path()));
  const Trace trace = traceOf(recording, publishedCalibration(), TravelFilter{});
  const std::vector<Closure> closures = closuresOf(recording, trace);

  ASSERT_EQ(closures.size(), expected.size());
  for (std::size_t i = 0; i < closures.size(); ++i) {
    const Closure& closure = closures[i];  // numbered from 1, there from 0
    EXPECT_EQ(closure.rows.first, expected[i].at("first_row").get<std::size_t>() + 1) << i;
    EXPECT_EQ(closure.rows.last, expected[i].at("last_row").get<std::size_t>() + 1) << i;
    EXPECT_NEAR(closure.start * 1e3, expected[i].at("start_ms").get<double>(), 1e-6) << i;
    EXPECT_NEAR(closure.duration * 1e3, expected[i].at("duration_ms").get<double>(), 1e-6) << i;
    EXPECT_EQ(millimetric(closure.peakForce), expected[i].at("peak_n").get<double>()) << i;
    EXPECT_EQ(closure.isComplete, expected[i].at("complete").get<bool>()) << i;
  }
}

TEST_P(PublishedRecording, HasTheMeasuredNumberOfLandmarks) {
  SKIP_WITHOUT_FETCHED_DATA(path());
  const Recording recording = readRecordingFile(tests::fetchedData(path()));
  const Trace trace = traceOf(recording, publishedCalibration(), TravelFilter{});
  Published found{};
  for (const Closure& closure : closuresOf(recording, trace)) {
    if (!closure.isComplete || closure.isSaturated()) continue;
    const CutLandmarks& landmarks = closure.landmarks;
    found.interceptions += landmarks.interception ? 1 : 0;
    found.yields += landmarks.yield ? 1 : 0;
    found.bottomOuts += landmarks.bottomOut ? 1 : 0;
    found.openings += landmarks.opening ? 1 : 0;
  }
  EXPECT_EQ(found.interceptions, GetParam().interceptions);
  EXPECT_EQ(found.yields, GetParam().yields);
  EXPECT_EQ(found.bottomOuts, GetParam().bottomOuts);
  EXPECT_EQ(found.openings, GetParam().openings);
}

TEST_P(PublishedRecording, HasLandmarksInTheOrderOfTheTravel) {
  SKIP_WITHOUT_FETCHED_DATA(path());
  const Recording recording = readRecordingFile(tests::fetchedData(path()));
  const Trace trace = traceOf(recording, publishedCalibration(), TravelFilter{});
  for (const Closure& closure : closuresOf(recording, trace)) {
    if (!closure.isComplete) continue;
    const CutLandmarks& landmarks = closure.landmarks;
    if (landmarks.yield) {
      EXPECT_LT(landmarks.interception->travel, landmarks.yield->travel);
      EXPECT_LT(landmarks.interception->force, landmarks.yield->force);
    }
    if (landmarks.bottomOut) {
      EXPECT_LT(landmarks.yield->travel, landmarks.bottomOut->travel);
      EXPECT_GT(landmarks.yield->force, landmarks.bottomOut->force);
      // The opening is the largest force from the bottom-out on: that itself where no force
      // follows.
      EXPECT_GE(landmarks.opening->force, landmarks.bottomOut->force);
    }
  }
}

TEST_P(PublishedRecording, IsImportedOrRefusedWithAReason) {
  SKIP_WITHOUT_FETCHED_DATA(path());
  const Recording recording = readRecordingFile(tests::fetchedData(path()));
  if (GetParam().interceptions == 0) {
    EXPECT_THROW(importCut(recording), base::UserError);  // every closure is saturated
    return;
  }
  const ImportedCut imported = importCut(recording);
  EXPECT_LE(imported.cut.curve.largestSlope(), 4.39 * (1.0 + 1e-9));
  EXPECT_GE(imported.cut.curve.nodes().size(), 50U);
  EXPECT_GE(std::ranges::min(imported.cut.curve.nodes(), {}, &CurvePoint::force).force, 0.0);
}

TEST_P(PublishedRecording, HasItsOwnCubicInColumnTwo) {  // R7
  SKIP_WITHOUT_FETCHED_DATA(path());
  double largest = 0.0;
  for (const Recording::Row& row : readRecordingFile(tests::fetchedData(path())).rows) {
    const double newtons = forceOf(row.reading, recorder2021Calibration());
    largest = std::max(largest, std::abs(newtons / 9.81e-3 - row.grams));
  }
  EXPECT_LE(largest, 5.0e-3 + 1e-9);
}

TEST(PublishedPaper, HasNoYieldInAnyClosure) {
  for (const auto* name :
       {"punch/part-1/blank/slow/blank_slow_14042021_1758.txt",
        "punch/part-2/blank-paper/fast/BLANK_FAST_14042021_1821.txt"}) {
    SKIP_WITHOUT_FETCHED_DATA(name);
    const Recording recording = readRecordingFile(tests::fetchedData(name));
    for (const auto kind : {TravelFilter::Kind::AuthorsFir, TravelFilter::Kind::AuthorsFir333}) {
      const Trace trace = traceOf(recording, publishedCalibration(), {.kind = kind});
      for (const Closure& closure : closuresOf(recording, trace)) {
        EXPECT_FALSE(closure.landmarks.yield) << name << " row " << closure.rows.first;
        EXPECT_FALSE(closure.landmarks.bottomOut) << name << " row " << closure.rows.first;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Punch,
    PublishedRecording,
    testing::Values(
        Published{"part-1/blank/slow/blank_slow_14042021_1758.txt", 0, 0, 10, 0, 0, 10},
        Published{"part-1/meniscus/fast/MENISK_14042021_1807.txt", 0, 1042, 0, 0, 0, 0},
        Published{"part-1/meniscus/fast/MENISK_2_FAST_14042021_1814.txt", 0, 1243, 0, 0, 0, 0},
        Published{"part-1/meniscus/slow/MENISK_1_14042021_1804.txt", 0, 2410, 0, 0, 0, 0},
        Published{"part-2/blank-paper/fast/BLANK_FAST_14042021_1821.txt", 0, 0, 9, 0, 0, 9},
        Published{"part-2/meniscus/fast/MENISK_FAST_1_14042021_1826.txt", 0, 0, 11, 10, 10, 11},
        Published{"part-2/meniscus/slow/MENISK_SLOW_1_14042021_1824.txt", 0, 0, 10, 9, 9, 10},
        Published{
            "part-2/meniscus/slow/MENISK_SLOW_2_REMOVEDFROMKNEE_14042021_1839.txt",
            1,
            1668,
            7,
            6,
            6,
            7}),
    [](const testing::TestParamInfo<Published>& recording) {
      const std::string stem = recording.param.file.substr(0, recording.param.file.rfind('.'));
      return stem.substr(stem.rfind('_') + 1);  // the time of day
    });

}  // namespace published_recordings_test
}  // namespace haptics::recordings

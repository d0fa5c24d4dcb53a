#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "haptics/filters/low_pass.h"
#include "haptics/recordings/cut_import.h"
#include "haptics/recordings/recording.h"
#include "haptics/recordings/trace.h"
#include "tests/haptics/recordings/printed_table.h"
#include "tests/support/test_data.h"

// Does palpate read the published recordings as their authors did? Their own numbers, printed in
// their sketch and found in their files, say so.

namespace haptics::recordings {
namespace reproduction_test {

const char* const kCopy = "punch/matlab/11_meniscus_fast_1826 - Copy.txt";
const char* const kWhole = "punch/part-2/meniscus/fast/MENISK_FAST_1_14042021_1826.txt";
const char* const kReference = "punch/reference-cut-76.csv";
constexpr RowRange kCut{5900, 5975};
constexpr TravelFilter kAsPublished{.kind = TravelFilter::Kind::AuthorsFir333};

Recording copy() {
  return readRecordingFile(tests::fetchedData(kCopy));
}

/// The 76 pairs of the cut.
std::vector<CurvePoint> pairs() {
  const Trace trace = traceOf(copy(), publishedCalibration(), kAsPublished);
  std::vector<CurvePoint> found;
  for (std::size_t i = kCut.first - 1; i < kCut.last; ++i) {
    found.push_back({trace.travel[i], trace.force[i]});
  }
  return found;
}

double rounded(double value) {
  return std::round(value * 1e3) / 1e3;
}

std::pair<double, double> slopesOf(const std::vector<CurvePoint>& points) {
  double least = 0.0;
  double most = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double slope =
        (points[i].force - points[i - 1].force) / (points[i].travel - points[i - 1].travel);
    least = std::min(least, slope);
    most = std::max(most, slope);
  }
  return {least, most};
}

TEST(Reproduction, R1ForcesOfTheReferenceCut) {
  SKIP_WITHOUT_FETCHED_DATA(kReference);
  const std::vector<CurvePoint> cut = pairs();
  std::ifstream csv(tests::fetchedData(kReference));
  std::string line;
  std::getline(csv, line);
  ASSERT_EQ(line, "index,angle_raw,force_n");

  double largest = 0.0;
  std::size_t rows = 0;
  for (; std::getline(csv, line); ++rows) {
    const double force = std::stod(line.substr(line.rfind(',') + 1));
    largest = std::max(largest, std::abs(cut.at(rows).force - force));
  }
  EXPECT_EQ(rows, 76U);
  EXPECT_LE(largest, 1e-9);
  for (const auto& printed : tests::kPrintedTable) {
    EXPECT_NEAR(cut[printed.index].force, printed.force, tests::kPrintedRounding) << printed.index;
  }
}

TEST(Reproduction, R2TravelsOfTheReferenceCut) {
  SKIP_WITHOUT_FETCHED_DATA(kCopy);
  const std::vector<CurvePoint> cut = pairs();
  for (const auto& printed : tests::kPrintedTable) {
    EXPECT_NEAR(cut[printed.index].travel, printed.travel, tests::kPrintedRounding)
        << printed.index;
  }
}

TEST(Reproduction, R3CopyIsPartOfTheWhole) {
  SKIP_WITHOUT_FETCHED_DATA(kWhole);
  const Recording part = copy();
  const Recording whole = readRecordingFile(tests::fetchedData(kWhole));

  ASSERT_EQ(part.rows.size(), 7237U);
  EXPECT_TRUE(std::equal(part.rows.begin(), part.rows.end(), whole.rows.begin() + 7586));
  EXPECT_EQ(whole.rows[13486 - 1].time, 1'820'425.0);
  EXPECT_EQ(whole.rows[13561 - 1].time, 1'820'659.0);
  EXPECT_EQ(part.rows[kCut.first - 1], whole.rows[13486 - 1]);
}

TEST(Reproduction, R3CutIsTheSameFromCopyAndWhole) {
  SKIP_WITHOUT_FETCHED_DATA(kWhole);
  const Recording whole = readRecordingFile(tests::fetchedData(kWhole));
  const ForceCurve fromCopy = importCut(copy(), {.rows = kCut, .filter = kAsPublished}).cut.curve;
  const ForceCurve fromWhole =
      importCut(whole, {.rows = RowRange{13486, 13561}, .filter = kAsPublished}).cut.curve;
  EXPECT_EQ(fromCopy, fromWhole);
}

TEST(Reproduction, R4StiffnessOfTheReferenceCut) {
  SKIP_WITHOUT_FETCHED_DATA(kCopy);
  const std::vector<CurvePoint> cut = pairs();
  const double stiffness = (rounded(cut[30].force) - rounded(cut[16].force)) /
                           (rounded(cut[30].travel) - rounded(cut[16].travel));
  EXPECT_NEAR(stiffness, 1.7224, 5e-5);
}

TEST(Reproduction, R6SlopesOfTheTable) {
  SKIP_WITHOUT_FETCHED_DATA(kCopy);
  std::vector<CurvePoint> table = pairs();
  const auto [leastRead, mostRead] = slopesOf(table);
  for (CurvePoint& pair : table) pair = {rounded(pair.travel), rounded(pair.force)};
  const auto [least, most] = slopesOf(table);

  // The published range is that of the table as printed, with three decimals.
  EXPECT_NEAR(most, 18.86, 0.005);
  EXPECT_NEAR(least, -6.47, 0.005);
  EXPECT_NEAR(mostRead, 18.91, 0.02);
  EXPECT_NEAR(leastRead, -6.61, 0.02);
  EXPECT_NO_THROW(ForceCurve{table});  // strictly increasing
}

/// The ten ranges of rows that eq. (22) was worked out from.
ProcessNoise ofTenCuts(const Trace& trace) {
  const std::vector<RowRange> cuts{
      {90, 170},
      {870, 910},
      {1440, 1480},
      {2300, 2400},
      {3000, 3050},
      {3700, 3800},
      {4300, 4370},
      {5100, 5150},
      {5900, 5970},
      {6800, 6840}};
  return processNoiseOf(trace, cuts, 0.0);
}

TEST(Reproduction, R5CovariancesOfTheTenCutsAsThePaperPrintsThem) {
  SKIP_WITHOUT_FETCHED_DATA(kCopy);
  const Recording recording = copy();
  const ProcessNoise found = ofTenCuts(traceOf(recording, publishedCalibration(), kAsPublished));

  EXPECT_NEAR(found.force, 6.1024, 5e-5);       // eq. (22)
  EXPECT_NEAR(found.stiffness, 7.0275, 5e-5);   // eq. (22)
  EXPECT_NEAR(found.covariance, 0.2772, 5e-5);  // eq. (22), its lower left
}

TEST(Reproduction, R5CovariancesOfTheTenCutsAsTheReferenceHasThem) {
  SKIP_WITHOUT_FETCHED_DATA(kCopy);
  const Recording recording = copy();
  Trace trace = traceOf(recording, publishedCalibration(), TravelFilter{TravelFilter::Kind::None});
  // Slightly higher, and still 17.69 Hz: the best fit to the 76 printed angles.
  const filters::KaiserLowPass filter({.cutoff = 17.6925});
  trace.travel = filter.filtered(trace.travel);
  const ProcessNoise found = ofTenCuts(trace);

  EXPECT_NEAR(found.force, 6.1024, 1e-4);
  EXPECT_NEAR(found.stiffness, 7.038, 1e-3);
  EXPECT_NEAR(found.covariance, 0.2779, 1e-3);
}

TEST(Reproduction, FindsTheLandmarksOfTheReferenceCut) {
  SKIP_WITHOUT_FETCHED_DATA(kCopy);
  const CutLandmarks found =
      importCut(copy(), {.rows = kCut, .filter = kAsPublished}).cut.landmarks;

  ASSERT_TRUE(found.interception && found.yield && found.bottomOut);
  EXPECT_NEAR(found.interception->travel, 3.813, 5e-4);
  EXPECT_NEAR(found.interception->force, 0.000, 5e-4);
  EXPECT_NEAR(found.yield->travel, 7.183, 5e-4);
  EXPECT_NEAR(found.yield->force, 4.369, 5e-4);
  EXPECT_NEAR(found.bottomOut->travel, 10.349, 5e-4);
  EXPECT_NEAR(found.bottomOut->force, 3.679, 5e-4);
  EXPECT_FALSE(found.opening);  // the 76 rows end before the hand opens
}

TEST(Reproduction, ChoosesTheAuthorsCutByDefault) {
  SKIP_WITHOUT_FETCHED_DATA(kWhole);
  const ImportReport report = importCut(readRecordingFile(tests::fetchedData(kWhole))).report;
  ASSERT_EQ(report.rows.size(), 1U);
  EXPECT_LE(report.rows[0].first, 13486U);
  EXPECT_GE(report.rows[0].last, 13561U);
}

TEST(Reproduction, HardlyChangesTheReferenceCutByTheLimitOfItsSlope) {
  SKIP_WITHOUT_FETCHED_DATA(kCopy);
  const ImportedCut imported = importCut(copy(), {.rows = kCut, .filter = kAsPublished});
  EXPECT_EQ(imported.cut.curve.nodes().size(), 76U);
  EXPECT_EQ(imported.report.mergedSamples, 0U);
  EXPECT_NEAR(imported.report.slopeBefore, 18.91, 0.02);
  EXPECT_LE(imported.cut.curve.largestSlope(), 4.39 * (1.0 + 1e-9));
  EXPECT_LT(imported.report.largestChange, 0.15);
}

}  // namespace reproduction_test
}  // namespace haptics::recordings

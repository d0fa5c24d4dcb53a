#include "haptics/recordings/cut_import.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "haptics/recordings/cut.h"
#include "haptics/recordings/force_curve.h"
#include "haptics/recordings/recording.h"
#include "haptics/recordings/recording_table.h"
#include "tests/haptics/recordings/made_recording.h"
#include "tests/support/complaint.h"
#include "tests/support/says.h"

namespace haptics::recordings {
namespace cut_import_test {

using tests::says;

Recording made(const tests::MadeRecording& recording = {}) {
  return readRecording(tests::textOf(recording), "made.txt");
}

std::string complaintAbout(const Recording& recording, const ImportOptions& options = {}) {
  return tests::complaintOf([&] { importCut(recording, options); });
}

/// The filter rounds the turn at the end of the travel off a little [N].
constexpr double kRounding = 0.06;

/// The largest difference from what the hand felt, scaled [N].
double distance(const ForceCurve& curve, double scale) {
  const ForceCurve felt = parametricCut().curve;
  double largest = 0.0;
  for (const CurvePoint& node : curve.nodes()) {
    largest = std::max(largest, std::abs(node.force - scale * felt.forceAt(node.travel)));
  }
  return largest;
}

TEST(CutImport, TakesTheMostTypicalClosure) {
  const ImportedCut imported = importCut(made({.scales = {0.7, 1.0, 1.3}}));

  EXPECT_EQ(imported.report.closures, std::vector<std::size_t>{2});
  EXPECT_TRUE(says(describe(imported.report.reason), "mean of the 3 complete closures"));
  EXPECT_LT(distance(imported.cut.curve, 1.0), kRounding);
  EXPECT_NEAR(imported.cut.landmarks.yield->force, 4.4, 0.01);
  EXPECT_FALSE(imported.cut.isSynthetic);
}

TEST(CutImport, TakesAClosureByItsNumber) {
  const ImportedCut imported = importCut(made(), {.closures = {1}});
  EXPECT_LT(distance(imported.cut.curve, 0.8), kRounding);
  EXPECT_EQ(imported.report.rows.at(0), imported.report.survey.closures.at(0).closing);
}

TEST(CutImport, TakesTheMeanOfSeveralClosures) {
  const ImportedCut imported = importCut(made(), {.closures = {1, 3}});

  EXPECT_LT(distance(imported.cut.curve, 1.05), kRounding);  // of 0.8 and 1.3
  EXPECT_EQ(imported.report.deviation.size(), MeanCurve::kNodes);
  EXPECT_EQ(imported.cut.provenance.rows.size(), 2U);
  EXPECT_NEAR(imported.cut.landmarks.yield->force, 1.05 * 4.4, 0.02);
  EXPECT_FALSE(imported.cut.landmarks.opening);  // a mean does not open
}

TEST(CutImport, TakesRowsAsTheyAre) {
  const Recording recording = made({.scales = {1.0}});
  const ImportedCut imported = importCut(
      recording, {.rows = RowRange{150, 250}, .filter = TravelFilter{TravelFilter::Kind::None}});

  EXPECT_EQ(imported.cut.curve.nodes().size(), 101U);
  EXPECT_EQ(imported.cut.curve.start(), recording.rows[149].travel);
  EXPECT_EQ(imported.cut.curve.end(), recording.rows[249].travel);
  EXPECT_TRUE(imported.report.closures.empty());
  EXPECT_TRUE(imported.cut.landmarks.interception);
  EXPECT_EQ(imported.cut.title, "made.txt, rows 150-250");
}

TEST(CutImport, LimitsTheSlopeAndSaysWhere) {
  const ImportedCut imported = importCut(made(), {.closures = {2}, .maxSlope = 1.0});

  EXPECT_LE(imported.cut.curve.largestSlope(), 1.0 + 1e-9);
  EXPECT_GT(imported.report.slopeBefore, 3.0);
  const double at = imported.report.largestChangeAt;
  const ForceCurve steep = importCut(made(), {.closures = {2}, .maxSlope = 1e6}).cut.curve;
  const double change = std::abs(steep.forceAt(at) - imported.cut.curve.forceAt(at));
  EXPECT_DOUBLE_EQ(change, imported.report.largestChange);
  const auto& changes = imported.report.changes;
  ASSERT_GE(changes.size(), 2U);
  EXPECT_TRUE(says(describe(changes[changes.size() - 2]), "to 1.00 N per travel unit"));
  EXPECT_TRUE(says(describe(changes.back()), "opening branch"));
  ASSERT_TRUE(imported.cut.opening.has_value());
  EXPECT_LE(imported.cut.opening->largestSlope(), 1.0 + 1e-9);
}

TEST(CutImport, SaysFirstWhatItDidToThePeak) {
  const ImportedCut imported = importCut(made(), {.closures = {2}, .maxSlope = 1.0});
  const ImportReport& report = imported.report;

  EXPECT_NEAR(report.peakBefore, report.survey.closures.at(1).peakForce, 0.05);
  double peak = 0.0;
  for (const CurvePoint& node : imported.cut.curve.nodes()) peak = std::max(peak, node.force);
  EXPECT_EQ(report.peakAfter, peak);
  EXPECT_LT(report.peakAfter, 0.9 * report.peakBefore);
  EXPECT_GT(report.movedPoints, 0U);
  EXPECT_TRUE(report.isAltered());
  const std::string first = describe(report.changes.front());
  EXPECT_TRUE(says(
      first,
      "peak " + decimal(report.peakBefore, 2) + " → " + decimal(report.peakAfter, 2) + " N"));
  EXPECT_TRUE(says(first, std::to_string(report.movedPoints) + " of "));
}

TEST(CutImport, CallsACutThatKeepsItsShapeUnaltered) {
  const ImportReport report = importCut(made(), {.closures = {2}, .maxSlope = 1e6}).report;
  EXPECT_FALSE(report.isAltered());
  EXPECT_EQ(report.movedPoints, 0U);
  EXPECT_NEAR(report.peakAfter, report.peakBefore, 0.05);
}

TEST(CutImport, MeasuresSteepnessOverAStepThatTheToolHasMade) {
  // rests for a while, where noise of 0.1 N lies between travels that differ by 0.0001
  std::string text;
  for (int i = 0; i < 400; ++i) {
    const double travel = i < 100 ? 1e-4 * i : 0.01 + 0.04 * (i - 100);
    const double force = (i % 2 == 0 ? 0.1 : 0.0) + 0.5 * travel;
    text += decimal(force, 4) + "," + decimal(travel, 6) + "\n";
  }
  const Recording recording = readRecordingTable(
      text, "made.csv", {.rate = 500.0, .travel = {.number = 2}, .force = {.number = 1}});
  const ImportReport report =
      importCut(
          recording, {.rows = RowRange{1, 400}, .filter = TravelFilter{TravelFilter::Kind::None}})
          .report;
  EXPECT_GT(report.slopeBefore, 500.0);
  EXPECT_LT(report.steepness, 2.0);
  for (const auto& change : report.changes) {
    EXPECT_EQ(describe(change).find("1000."), std::string::npos) << describe(change);
  }
}

TEST(CutImport, KeepsWhereItCameFrom) {
  const ImportedCut imported = importCut(made(), {.name = "mine", .title = "My cut"});
  const Provenance& provenance = imported.cut.provenance;

  EXPECT_EQ(imported.cut.name, "mine");
  EXPECT_EQ(imported.cut.title, "My cut");
  EXPECT_EQ(imported.cut.unit, "travel_unit");
  EXPECT_EQ(provenance.sourceFile, "made.txt");
  EXPECT_EQ(provenance.calibration, "paper-eq1");
  EXPECT_EQ(provenance.filter, "authors-fir");
  EXPECT_TRUE(says(provenance.filterParameters, "49-tap"));
  EXPECT_EQ(provenance.slopeLimit, 4.39);
  ASSERT_EQ(provenance.changes.size(), imported.report.changes.size());
  for (std::size_t i = 0; i < provenance.changes.size(); ++i) {
    EXPECT_EQ(provenance.changes[i], describe(imported.report.changes[i]));
  }
  EXPECT_TRUE(says(provenance.statement, "of the recording 'made.txt'"));
}

TEST(CutImport, IsNamedAfterItsFileByDefault) {
  EXPECT_EQ(importCut(made()).cut.name, "made");
}

TEST(CutImport, GivesSmallerForcesByTheRecordersOwnCalibration) {
  const double paper = importCut(made()).report.survey.maxForce;
  const double recorder =
      importCut(made(), {.calibration = recorder2021Calibration()}).report.survey.maxForce;
  EXPECT_LT(recorder, 0.9 * paper);
}

TEST(CutImport, WarnsOfAClippedPeak) {
  const ImportedCut imported = importCut(made({.scales = {1.0, 2.5}}), {.closures = {2}});
  EXPECT_TRUE(
      says(describe(imported.report.changes.back()), "saturated: their force is a lower bound"));
  const auto& beforeIt = imported.report.changes.at(imported.report.changes.size() - 2);
  EXPECT_TRUE(says(describe(beforeIt), "more than 869"));
}

TEST(CutImport, SkipsClippedAndIncompleteClosuresByDefault) {
  const ImportedCut imported = importCut(made({.scales = {2.5, 1.0}, .beginsClosed = true}));
  EXPECT_EQ(imported.report.survey.closures.size(), 3U);  // the first begins with the recording
  EXPECT_EQ(imported.report.closures, std::vector<std::size_t>{3});
  EXPECT_EQ(describe(imported.report.reason), "the only complete closure without a saturated row");
}

TEST(CutImport, ReportsARecordingWithoutAClosure) {
  EXPECT_EQ(
      complaintAbout(made({.scales = {}})),
      "There is no closure in 'made.txt': its travel never rises above 7. Check that the recorder "
      "was told both end positions, or choose rows.");
}

TEST(CutImport, NamesALineThatCouldNotBeReadBesideAMissingClosure) {
  auto recording = made({.scales = {}});
  recording.refusedCount = 2;
  recording.refusedLines = {{.number = 3, .reason = "6 numbers instead of 5"}};
  EXPECT_TRUE(says(complaintAbout(recording), "2 of its "));
  EXPECT_TRUE(says(complaintAbout(recording), "the first in line 3 (6 numbers instead of 5)"));
}

/// made() with its forces multiplied.
Recording withForces(double factor) {
  auto recording = made();
  for (double& coefficient : recording.calibration->coefficients) coefficient *= factor;
  return recording;
}

/// The keys of all changes that are doubts.
std::string doubtsIn(const Recording& recording) {
  std::string doubts;
  for (const auto& change : importCut(recording, {.closures = {1}}).report.changes) {
    const auto key = change.key();
    if (key == "forces_negative" || key == "peak_unlikely" || key == "travel_unlikely") {
      doubts.append(doubts.empty() ? "" : " ").append(key);
    }
  }
  return doubts;
}

TEST(CutImport, DoubtsUnitsThatNoHandHas) {
  EXPECT_EQ(doubtsIn(made()), "");
  EXPECT_EQ(doubtsIn(withForces(1000.0)), "peak_unlikely");
  EXPECT_EQ(doubtsIn(withForces(0.001)), "peak_unlikely");
  auto wide = made();
  for (auto& row : wide.rows) row.travel *= 10.0;
  EXPECT_EQ(doubtsIn(wide), "travel_unlikely");
}

TEST(CutImport, DoubtsForcesThatAreNegativeAlmostEverywhere) {
  auto recording = withForces(-1.0);
  recording.calibration->coefficients[0] -= 0.2;
  EXPECT_EQ(doubtsIn(recording), "forces_negative");
}

TEST(CutImport, ReportsClosuresThatAreAllClipped) {
  EXPECT_EQ(
      complaintAbout(made({.scales = {2.5, 3.0}})),
      "Each of the 2 complete closures of 'made.txt' has rows where the force sensor was "
      "saturated, so that its peak is cut off. Take another recording, or choose a closure by its "
      "number, or rows, if that will do.");
}

TEST(CutImport, ReportsClosuresThatAreAllIncomplete) {
  EXPECT_EQ(
      complaintAbout(made({.scales = {}, .beginsClosed = true})),
      "None of the 1 closures of 'made.txt' is complete (it lies within the recording and lasts at "
      "most 4 s): choose one by its number, or rows.");
}

TEST(CutImport, ReportsAClosureThatIsNotThere) {
  EXPECT_EQ(
      complaintAbout(made(), {.closures = {4}}),
      "There is no closure 4 in 'made.txt': it has 3, numbered from 1.");
  EXPECT_TRUE(says(complaintAbout(made(), {.closures = {0}}), "There is no closure 0"));
}

TEST(CutImport, ReportsRowsThatAreNotThere) {
  EXPECT_EQ(
      complaintAbout(made({.scales = {1.0}}), {.rows = RowRange{600, 603}}),
      "Rows 600 to 603 are no part of 'made.txt': it has rows 1 to 602, and the first must come "
      "before the last.");
  EXPECT_TRUE(says(complaintAbout(made(), {.rows = RowRange{0, 5}}), "no part of"));
  EXPECT_TRUE(says(complaintAbout(made(), {.rows = RowRange{9, 9}}), "no part of"));
  EXPECT_TRUE(says(complaintAbout(made(), {.rows = RowRange{9, 5}}), "no part of"));
}

TEST(CutImport, ReportsRowsThatDoNotClose) {
  EXPECT_EQ(
      complaintAbout(made(), {.rows = RowRange{320, 480}}),
      "Rows 320 to 480 are no closing hand (their travel does not rise): choose other rows.");
}

TEST(CutImport, RefusesContradictoryOptions) {
  const Recording recording = made();
  EXPECT_THROW(
      importCut(recording, {.closures = {1}, .rows = RowRange{1, 9}}), std::invalid_argument);
  EXPECT_THROW(importCut(recording, {.closures = {1, 2, 1}}), std::invalid_argument);
  EXPECT_THROW(importCut(recording, {.maxSlope = 0.0}), std::invalid_argument);
  EXPECT_THROW(importCut(recording, {.maxSlope = std::nan("")}), std::invalid_argument);
}

TEST(CutImport, IsTheSameEveryTime) {
  const Recording recording = made();
  EXPECT_EQ(importCut(recording).cut.curve, importCut(recording).cut.curve);
}

}  // namespace cut_import_test
}  // namespace haptics::recordings

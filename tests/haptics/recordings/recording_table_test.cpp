#include "haptics/recordings/recording_table.h"

#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "haptics/recordings/cut_import.h"
#include "haptics/recordings/trace.h"
#include "tests/haptics/recordings/made_recording.h"
#include "tests/support/complaint.h"
#include "tests/support/says.h"

namespace haptics::recordings {
namespace recording_table_test {

using tests::says;

const RecordingColumns kNewtons{
    .time = TableColumn{.heading = "t"},
    .travel = {.heading = "angle"},
    .open = 12.0,
    .closed = 52.0,
    .force = {.heading = "F"}};

std::string complaintAbout(const std::string& text, const RecordingColumns& columns) {
  return tests::complaintOf([&] { readRecordingTable(text, "cut.csv", columns); });
}

TEST(RecordingTable, FindsColumnsByTheirHeadsAndMapsTheStrokeToTenUnits) {
  const auto recording =
      readRecordingTable("F,angle,t\n0,12,1\n2.5,32,1.001\n-0.5,54,1.002\n", "a.csv", kNewtons);
  ASSERT_EQ(recording.rows.size(), 3U);
  EXPECT_EQ(recording.source, "a.csv");
  EXPECT_DOUBLE_EQ(recording.rows[1].travel, 5.0);
  EXPECT_DOUBLE_EQ(recording.rows[2].travel, 10.5);
  EXPECT_DOUBLE_EQ(recording.rows[1].time, 1001.0);
  EXPECT_EQ(recording.rows[1].reading, 2.5);
  EXPECT_EQ(recording.readingUnit, "N");
  EXPECT_NEAR(samplingOf(recording).rate, 1000.0, 1e-6);
  const auto trace =
      traceOf(recording, calibrationFor(recording), {.kind = TravelFilter::Kind::None});
  EXPECT_EQ(trace.force, (std::vector<double>{0.0, 2.5, -0.5}));
}

TEST(RecordingTable, ReadsDecimalCommasSkippedLinesAndALineOfUnits) {
  RecordingColumns columns = kNewtons;
  columns.skippedLines = 2;
  columns.millisecondsPerTime = 1.0;
  const auto recording = readRecordingTable(
      "\xEF\xBB\xBFMachine 7;x\r\n\r\nt;angle;F\r\nms;deg;N\r\n0;12;0,25\r\n1;16;\"0,5\"\r\n",
      "b.csv",
      columns);
  ASSERT_EQ(recording.rows.size(), 2U);
  EXPECT_EQ(recording.rows[0].reading, 0.25);
  EXPECT_EQ(recording.rows[1].reading, 0.5);
  EXPECT_EQ(recording.rows[1].time, 1.0);
  EXPECT_EQ(recording.refusedCount, 1U);
  EXPECT_EQ(recording.refusedLines[0].number, 4U);
  EXPECT_EQ(recording.refusedLines[0].reason, "the time 'ms' is no number");
}

TEST(RecordingTable, TakesColumnsByNumberAndARateWhereThereIsNoTime) {
  const RecordingColumns columns{
      .rate = 500.0, .travel = {.number = 1}, .force = {.number = 3}, .separator = ' '};
  const auto recording = readRecordingTable("0 7 1.5\n  5\t7 2.5 \n", "c.txt", columns);
  ASSERT_EQ(recording.rows.size(), 2U);
  EXPECT_EQ(recording.rows[1].time, 2.0);
  EXPECT_EQ(recording.rows[1].travel, 5.0);
  EXPECT_EQ(recording.rows[1].reading, 2.5);
}

TEST(RecordingTable, TurnsScalesAndZeroesTheForce) {
  RecordingColumns columns = kNewtons;
  columns.forceZero = 0.2;
  columns.forceFactor = -2.0;
  columns.saturatesAt = -9.8;
  const auto recording = readRecordingTable("t,angle,F\n0,12,-4.8\n1,13,0.2\n", "d.csv", columns);
  EXPECT_DOUBLE_EQ(recording.rows[0].reading, 10.0);
  EXPECT_EQ(recording.rows[1].reading, 0.0);
  EXPECT_DOUBLE_EQ(recording.saturation, 20.0);
  const auto unlimited = readRecordingTable("t,angle,F\n0,12,1\n", "d.csv", kNewtons);
  EXPECT_EQ(unlimited.saturation, std::numeric_limits<double>::infinity());
}

TEST(RecordingTable, NeedsTheCalibrationOfItsSensor) {
  RecordingColumns columns = kNewtons;
  columns.readingUnit = "V";
  const std::string text = "t,angle,F\n0,12,1\n1,13,2\n";
  const auto raw = readRecordingTable(text, "e.csv", columns);
  EXPECT_THROW(calibrationFor(raw), base::UserError);
  EXPECT_THROW(
      traceOf(raw, publishedCalibration(), {.kind = TravelFilter::Kind::None}),
      base::UserError);  // counts

  columns.calibration = ForceCalibration{.name = "mine", .unit = "V", .coefficients = {0.5, 2.0}};
  const auto recording = readRecordingTable(text, "e.csv", columns);
  const auto trace =
      traceOf(recording, calibrationFor(recording), {.kind = TravelFilter::Kind::None});
  EXPECT_EQ(trace.force, (std::vector<double>{2.5, 4.5}));
}

TEST(RecordingTable, SaysWhatIsWrongWithIt) {
  EXPECT_TRUE(says(complaintAbout("a,b\n1,2\n", kNewtons), "no column 't' for the time"));
  EXPECT_TRUE(says(complaintAbout("a,b\n1,2\n", kNewtons), "'a', 'b'"));
  EXPECT_TRUE(says(complaintAbout("t,angle,F\n", kNewtons), "only a head"));
  EXPECT_TRUE(says(complaintAbout("t,angle,F\nx,1,2\n", kNewtons), "line 2: the time 'x'"));
  EXPECT_TRUE(says(complaintAbout("t,angle,F\n2,1,2\n1,1,2\n", kNewtons), "backwards"));
  EXPECT_TRUE(says(complaintAbout("", kNewtons), "is empty"));
  RecordingColumns same = kNewtons;
  same.closed = same.open;
  EXPECT_TRUE(says(complaintAbout("t,angle,F\n1,1,2\n", same), "the same"));
  RecordingColumns timeless = kNewtons;
  timeless.time.reset();
  EXPECT_TRUE(says(complaintAbout("t,angle,F\n1,1,2\n", timeless), "neither a time nor a rate"));
}

TEST(RecordingTable, GivesTheSameCutAsTheFormatOfThePunch) {
  const Recording punch = readRecording(tests::textOf({}), "made.txt");
  std::string table = "time [s],handle [deg],load [mN]\n";
  for (const auto& row : punch.rows) {
    table += decimal(row.time / 1000.0, 6) + "," + decimal(12.0 + 4.0 * row.travel, 6) + "," +
             decimal(1000.0 * forceOf(row.reading, publishedCalibration()), 9) + "\n";
  }
  const RecordingColumns columns{
      .time = TableColumn{.heading = "time [s]"},
      .travel = {.heading = "handle [deg]"},
      .open = 12.0,
      .closed = 52.0,
      .force = {.heading = "load [mN]"},
      .forceFactor = 1e-3};
  const auto expected = importCut(punch).cut;
  const auto found = importCut(readRecordingTable(table, "made.csv", columns)).cut;
  ASSERT_EQ(found.curve.nodes().size(), expected.curve.nodes().size());
  for (std::size_t i = 0; i < found.curve.nodes().size(); ++i) {
    EXPECT_NEAR(found.curve.nodes()[i].travel, expected.curve.nodes()[i].travel, 1e-5);
    EXPECT_NEAR(found.curve.nodes()[i].force, expected.curve.nodes()[i].force, 1e-4);
  }
  EXPECT_EQ(found.provenance.calibration, "newtons");
  EXPECT_EQ(expected.provenance.calibration, "paper-eq1");
}

}  // namespace recording_table_test
}  // namespace haptics::recordings

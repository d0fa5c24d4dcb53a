#include <locale>
#include <string>

#include <gtest/gtest.h>

#include "haptics/recordings/recording.h"
#include "tests/haptics/recordings/made_recording.h"
#include "tests/support/complaint.h"
#include "tests/support/says.h"

namespace haptics::recordings {
namespace recording_text_test {

using tests::says;

const std::string kRow = "144\t99.23\t451.00\t0.25\t192037.00\t";  // from the data set's README
const std::string kNextRow = "145\t99.90\t452.00\t0.51\t192040.00\t";

/// What the reader says of a text it refuses.
std::string complaintAbout(const std::string& text) {
  return tests::complaintOf([&] { readRecording(text, "cut.txt"); });
}

TEST(RecordingText, ReadsTheFiveColumns) {
  const Recording recording = readRecording(kRow + "\n" + kNextRow + "\n", "cut.txt");

  ASSERT_EQ(recording.rows.size(), 2U);
  const Recording::Row& row = recording.rows[0];
  EXPECT_EQ(row.reading, 144.0);
  EXPECT_EQ(row.grams, 99.23);
  EXPECT_EQ(row.potentiometer, 451.0);
  EXPECT_EQ(row.travel, 0.25);
  EXPECT_EQ(row.time, 192037.0);
  EXPECT_EQ(recording.source, "cut.txt");
  EXPECT_EQ(recording.refusedCount, 0U);
}

TEST(RecordingText, ReadsTheSameWithAnyLineEnding) {
  const Recording plain = readRecording(tests::textOf({}));
  const Recording windows = readRecording(tests::textOf({.lineEnd = "\r\n"}));
  const Recording rtf = readRecording(tests::textOf({.lineEnd = "\r\\\n"}));
  const Recording blanks = readRecording(tests::textOf({.lineEnd = "\\\n", .separator = "  "}));

  EXPECT_EQ(windows.rows, plain.rows);
  EXPECT_EQ(rtf.rows, plain.rows);
  EXPECT_EQ(blanks.rows, plain.rows);
  EXPECT_EQ(rtf.refusedCount, 0U);
}

TEST(RecordingText, ReadsALastRowWithoutAnEnd) {
  EXPECT_EQ(readRecording(kRow + "\n" + kNextRow).rows.size(), 2U);
}

TEST(RecordingText, TakesOffAClosingBrace) {
  const Recording alone = readRecording(kRow + "\r\\\n}");
  EXPECT_EQ(alone.rows.size(), 1U);
  EXPECT_EQ(alone.refusedCount, 0U);

  const Recording glued = readRecording(kRow + "\n" + kNextRow + "}");
  EXPECT_EQ(glued.rows.size(), 2U);
  EXPECT_EQ(glued.refusedCount, 0U);
}

TEST(RecordingText, SkipsEmptyLines) {
  const Recording recording = readRecording("\t\n\n" + kRow + "\n \n\\\n" + kNextRow + "\n\n");
  EXPECT_EQ(recording.rows.size(), 2U);
  EXPECT_EQ(recording.refusedCount, 0U);
  EXPECT_EQ(recording.lines, 7U);
}

TEST(RecordingText, SkipsTheMarkOfUtf8) {
  EXPECT_EQ(readRecording("\xEF\xBB\xBF" + kRow + "\n").rows.size(), 1U);
}

TEST(RecordingText, RefusesARowThatWasCutOff) {
  const Recording recording = readRecording(kRow + "\r\\\n1\t0.}");  // as MENISK_SLOW_2 ends

  EXPECT_EQ(recording.rows.size(), 1U);
  ASSERT_EQ(recording.refusedCount, 1U);
  EXPECT_EQ(recording.refusedLines[0].number, 2U);
  EXPECT_EQ(recording.refusedLines[0].reason, "2 numbers instead of 5");
}

TEST(RecordingText, RefusesALastRowWhoseTimeWasCutOff) {
  const Recording recording = readRecording(kRow + "\n145\t99.90\t452.00\t0.51\t1920");

  EXPECT_EQ(recording.rows.size(), 1U);
  ASSERT_EQ(recording.refusedCount, 1U);
  EXPECT_TRUE(says(recording.refusedLines[0].reason, "cut off"));
}

TEST(RecordingText, SaysWhyItRefusedALine) {
  const std::string text = kRow +
                           "\n"
                           "144,5\t99.23\t451.00\t0.25\t192037.00\n"
                           "144\t99.23\tnan\t0.25\t192037.00\n"
                           "144\t99.23\t451.00\tinf\t192037.00\n"
                           "144\t99.23\t451.00\t1e999\t192037.00\n"
                           "144\t99.23\t0x1F\t0.25\t192037.00\n"
                           "1024\t99.23\t451.00\t0.25\t192037.00\n"
                           "-1\t99.23\t451.00\t0.25\t192037.00\n"
                           "144\t99.23\t451.00\t1e6\t192037.00\n"
                           "144\t99.23\t451.00\t0.25\t192037.00\t7\n"
                           "\x01\x02 a very long line of something else entirely\n";
  const Recording recording = readRecording(text);

  EXPECT_EQ(recording.rows.size(), 1U);
  ASSERT_EQ(recording.refusedCount, 10U);
  const auto reason = [&](std::size_t i) { return recording.refusedLines[i].reason; };
  EXPECT_EQ(reason(0), "'144,5' is no number");
  EXPECT_EQ(reason(1), "'nan' is no number");
  EXPECT_EQ(reason(2), "'inf' is no number");
  EXPECT_EQ(reason(3), "'1e999' is no number");
  EXPECT_EQ(reason(4), "'0x1F' is no number");
  EXPECT_EQ(reason(5), "force reading '1024' is outside 0 to 1023");
  EXPECT_EQ(reason(6), "force reading '-1' is outside 0 to 1023");
  EXPECT_EQ(reason(7), "travel '1e6' is outside -1000 to 1000");
  EXPECT_EQ(reason(8), "6 numbers instead of 5");
  EXPECT_EQ(reason(9), "'~~' is no number");
  EXPECT_EQ(recording.refusedLines[9].number, 11U);
}

TEST(RecordingText, CountsMoreRefusedLinesThanItKeeps) {
  std::string text = kRow + "\n";
  for (int i = 0; i < 1000; ++i) text += "one two\n";
  const Recording recording = readRecording(text);

  EXPECT_EQ(recording.refusedCount, 1000U);
  EXPECT_EQ(recording.refusedLines.size(), Recording::kMaxRefusedLines);
}

/// Writes 99,23 for 99.23, as a German desk does.
struct DecimalComma : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
};

TEST(RecordingText, ReadsADecimalPointInAnyLocale) {
  const std::locale before =
      std::locale::global(std::locale(std::locale::classic(), new DecimalComma));
  const double grams = readRecording(kRow).rows[0].grams;
  std::locale::global(before);
  EXPECT_EQ(grams, 99.23);
}

TEST(RecordingText, ReportsAnEmptyFile) {
  EXPECT_EQ(complaintAbout(""), "'cut.txt' is empty: copy or record it again.");
  EXPECT_EQ(complaintAbout("\n\t\n}"), "'cut.txt' has only empty lines: record it again.");
}

TEST(RecordingText, ReportsAFileThatIsNoText) {
  EXPECT_EQ(
      complaintAbout(std::string("PK\3\4\0\0", 6)),
      "'cut.txt' is no text (byte 5 is zero): choose the recorder's .txt file, saved as plain text "
      "and not as UTF-16.");
}

TEST(RecordingText, ReportsAFileWithoutARow) {
  EXPECT_EQ(
      complaintAbout("{\\rtf1\\ansi}\nwhatever\n"),
      "No line of 'cut.txt' is a row of five numbers (force reading, grams, potentiometer, travel, "
      "time in ms); line 1: '{\\rtf1\\ansi' is no number. Only the punch's recorder writes such "
      "rows: for any other table, give a columns file that says which column is the time, the "
      "travel and the force (docs/protocol-format.md, \"Columns files\"; --columns on the command "
      "line).");
}

TEST(RecordingText, ReportsAMissingPotentiometer) {
  EXPECT_EQ(
      complaintAbout("144\t99.23\t0.25\t192037.00\t\n145\t99.90\t0.51\t192040.00\t\n1\t0."),
      "'cut.txt' has four columns: the raw potentiometer (column 3) is missing. The recorder "
      "sketch in the authors' repository prints it so; record with a version that prints five.");
}

TEST(RecordingText, TellsWhereTimeRunsBackwards) {
  EXPECT_EQ(
      complaintAbout(kNextRow + "\n\n" + kRow + "\n"),
      "Time runs backwards in 'cut.txt' at line 3: two recordings in one file? Split it before "
      "that line and import the parts.");
}

TEST(RecordingText, SaysThatAnotherTableNeedsAColumnsFile) {
  const auto complaint =
      tests::complaintOf([] { readRecording("t_ms,jaw_mm,load_N\n0,0.1,0.2\n", "mine.csv"); });
  for (const auto* words : {"'mine.csv'", "columns file", "--columns"}) {
    EXPECT_TRUE(says(complaint, words));
  }
}

}  // namespace recording_text_test
}  // namespace haptics::recordings

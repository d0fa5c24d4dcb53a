#include "analysis/data/csv_table.h"

#include <gtest/gtest.h>

#include "tests/support/complaint.h"

namespace csv_table_test {

using analysis::readCsv;
using Cells = std::vector<std::string>;

std::string errorOf(std::string_view csv) {
  return tests::complaintOf([&] { readCsv(csv); });
}

TEST(CsvTable, HasColumnsAndRows) {
  const auto table = readCsv("g,x\na,1\nb,2\n");

  EXPECT_EQ(table.columns, (Cells{"g", "x"}));
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[1].cells, (Cells{"b", "2"}));
  EXPECT_EQ(table.rows[1].line, 3U);
}

TEST(CsvTable, NeedsNoFinalLineEnd) {
  EXPECT_EQ(readCsv("g,x\na,1").rows.size(), 1U);
}

TEST(CsvTable, ReadsEveryKindOfLineEnd) {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    std::string csv;
    for (const char* row : {"g,x", "a,1", "b,2"}) csv.append(row).append(end);
    const auto table = readCsv(csv);

    ASSERT_EQ(table.rows.size(), 2U);
    EXPECT_EQ(table.rows[1].cells, (Cells{"b", "2"}));
    EXPECT_EQ(table.rows[1].line, 3U);
  }
}

TEST(CsvTable, FindsItsSeparatorInTheHeader) {
  EXPECT_EQ(readCsv("g,x\na;b,1\n").separator, ',');
  EXPECT_EQ(readCsv("g;x\na;1,5\n").separator, ';');
  EXPECT_EQ(readCsv("g\tx\na\t1\n").separator, '\t');
  EXPECT_EQ(readCsv("\"g, of the group\";x\na;1\n").separator, ';');
}

TEST(CsvTable, MayHaveOneColumnOnly) {
  EXPECT_EQ(readCsv("p\n0.01\nNA\n").rows[1].cells, Cells{"NA"});
}

TEST(CsvTable, ReadsQuotationMarks) {
  const auto table = readCsv("g,x\n\"a, \"\"the\"\" first\",\" 1\"\n\"two\nlines\",2\nb,3\n");

  EXPECT_EQ(table.rows[0].cells, (Cells{"a, \"the\" first", " 1"}));
  EXPECT_EQ(table.rows[1].cells, (Cells{"two\nlines", "2"}));
  EXPECT_EQ(table.rows[2].line, 5U);
}

TEST(CsvTable, CountsLinesWithinQuotationMarksByAnyLineEnd) {
  EXPECT_EQ(readCsv("g,x\r\n\"1\r\n2\r3\n4\",1\r\nb,2\r\n").rows[1].line, 6U);
}

TEST(CsvTable, IgnoresAByteOrderMark) {
  EXPECT_EQ(readCsv("\xEF\xBB\xBFg,x\na,1\n").columns.front(), "g");
}

TEST(CsvTable, SkipsRowsWithoutText) {
  const auto table = readCsv("\n\ng;x\n\na;1\n;\n  ; \nb;2\n\n");

  EXPECT_EQ(table.separator, ';');
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[1].line, 8U);
}

TEST(CsvTable, TrimsSpacesOutsideQuotationMarks) {
  EXPECT_EQ(readCsv("g , x\n a\t,  1 \n").rows[0].cells, (Cells{"a", "1"}));
  EXPECT_EQ(readCsv("g , x\n").columns, (Cells{"g", "x"}));
}

TEST(CsvTable, KeepsNonAsciiTextAndEmptyCells) {
  EXPECT_EQ(readCsv("Größe,x,y\nä,,1\n").rows[0].cells, (Cells{"ä", "", "1"}));
}

TEST(CsvTable, RefusesAnEmptyFile) {
  EXPECT_EQ(errorOf(""), "the file is empty");
  EXPECT_EQ(errorOf("\xEF\xBB\xBF"), "the file is empty");
  EXPECT_EQ(errorOf("\n\r\n \n"), "the file is empty");
}

TEST(CsvTable, RefusesUtf16) {
  EXPECT_EQ(
      errorOf(std::string_view("\xFF\xFEg\0,\0x\0", 8)),
      "the file is in UTF-16: save it as CSV in UTF-8");
}

TEST(CsvTable, NamesTheLineOfAQuotationMarkThatIsNeverClosed) {
  EXPECT_EQ(
      errorOf("g,x\na,1\nb,\"2\nc,3\n"),
      "line 3: a quotation mark is opened here and never closed");
}

TEST(CsvTable, NamesTheLineOfTextAfterAQuotationMark) {
  EXPECT_EQ(
      errorOf("g,x\n\"a\"b,1\n"),
      "line 2: there is text after a closing quotation mark; within quotation marks, write \"\" "
      "for \"");
}

TEST(CsvTable, NamesAllRowsOfTheWrongLength) {
  EXPECT_EQ(
      errorOf("g,x\na,1,2\nb,1\nc\n"),
      "line 2 has 3 cells, and the header has 2 columns\n"
      "line 4 has 1 cell, and the header has 2 columns");
}

TEST(CsvTable, NamesNoMoreThanTenProblems) {
  std::string csv = "g,x\n";
  for (int i = 0; i < 12; ++i) csv += "a\n";

  const std::string error = errorOf(csv);
  EXPECT_NE(error.find("line 11 has 1 cell"), std::string::npos);
  EXPECT_EQ(error.find("line 12"), std::string::npos);
  EXPECT_TRUE(error.ends_with("\nand 2 more")) << error;
}

TEST(CsvTable, FindsColumnsByName) {
  const auto table = readCsv("method,score,note,note\na,1,,\n");
  const auto errorFor = [&](const char* column) {
    return tests::complaintOf([&] { table.columnIndex(column); });
  };

  EXPECT_EQ(table.columnIndex("score"), 1U);
  EXPECT_EQ(errorFor("note"), "there are two columns 'note'");
  EXPECT_EQ(
      errorFor("Scores"),
      "there is no column 'Scores'; the columns are 'method', 'score', 'note' and 'note'; did you "
      "mean 'score'?");
}

}  // namespace csv_table_test

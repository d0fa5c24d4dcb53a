// CSV files, read back by an independent reader.
#include "study/model/data_table.h"

#include <stdexcept>

#include <gtest/gtest.h>

namespace study {
namespace data_table_test {

using Lines = std::vector<std::vector<std::string>>;

/// A reader that accepts only RFC 4180 with LF as line ending.
class StrictReader {
 public:
  explicit StrictReader(std::string text) : text_(std::move(text)) {}

  /// @throws std::runtime_error  if the text is not valid CSV.
  Lines read() {
    Lines lines;
    while (at_ < text_.size()) {
      auto& line = lines.emplace_back();
      do {
        line.push_back(take('"') ? quotedCell() : plainCell());
      } while (take(','));
      if (!take('\n')) throw std::runtime_error("a line goes on after the end of a cell");
    }
    return lines;
  }

 private:
  bool take(char c) {
    const bool isThere = at_ < text_.size() && text_[at_] == c;
    if (isThere) ++at_;
    return isThere;
  }

  std::string plainCell() {
    std::string cell;
    while (at_ < text_.size() && text_[at_] != ',' && text_[at_] != '\n') {
      const char c = text_[at_++];
      if (c == '"' || c == '\r') throw std::runtime_error("a bare quote or carriage return");
      cell += c;
    }
    return cell;
  }

  std::string quotedCell() {
    std::string cell;
    for (;;) {
      if (at_ == text_.size()) throw std::runtime_error("a quote is not closed");
      if (!take('"')) {
        cell += text_[at_++];
      } else if (take('"')) {
        cell += '"';
      } else {
        return cell;
      }
    }
  }

  std::string text_;
  std::size_t at_ = 0;
};

DataTable tableOf(const std::vector<std::vector<std::string>>& rows) {
  DataTable table{
      .name = "made",
      .description = "",
      .columns = {{"written", "", true}, {"coded", ""}, {"last", ""}},
      .rows = {}};
  for (const auto& row : rows) table.rows.emplace_back(row.begin(), row.end());
  return table;
}

TEST(DataTable, IsReadBackByAnIndependentReaderWithAnyCells) {
  const Lines cells{
      {"plain", "two words", "æøå → 🦴"},
      {"one, two", "a \"quoted\" word", "\""},
      {"\"all quoted\"", "\"\"", ","},
      {"two\nlines", "\n", "ends with\n"},
      {"carriage\rreturn", "\r", "both\r\nof them"},
      {"a\ttab", "\t", "'"},
      {"\"a\",\"b\"\r\n\"c\"", "a,b\nc", " spaces "},
      {"", "", ""}};
  Lines expected{{"written", "coded", "last"}};
  expected.insert(expected.end(), cells.begin(), cells.end());
  EXPECT_EQ(StrictReader(asCsv(tableOf(cells))).read(), expected);
}

TEST(DataTable, PutsAnApostropheBeforeFreeTextThatLooksLikeAFormula) {
  for (const auto* begin : {"=", "+", "-", "@", "\t", "\r"}) {
    for (const auto* rest : {"", "1+1", "cmd|' /C calc'!A0", "HYPERLINK(\"x\", \"y\")"}) {
      const std::string text = std::string(begin) + rest;
      const auto line = StrictReader(asCsv(tableOf({{text, text, "x" + text}}))).read().at(1);
      EXPECT_EQ(line[0], "'" + text);
      EXPECT_EQ(line[1], text) << "codes and ids stay as they are";
      EXPECT_EQ(line[2], "x" + text);
    }
  }
}

TEST(DataTable, DistinguishesTheTypesOfCells) {
  DataTable table = tableOf({});
  table.rows = {
      {std::int64_t{-7}, 0.1, true},
      {Cell(), false, -1e-300},
      {std::string("3"), 1e22, std::int64_t{9'007'199'254'740'993}}};
  const Lines expected{
      {"written", "coded", "last"},
      {"-7", "0.1", "true"},
      {"", "false", "-1e-300"},
      {"3", "1e+22", "9007199254740993"}};
  EXPECT_EQ(StrictReader(asCsv(table)).read(), expected);
}

TEST(DataTable, IsQuotedAsRfc4180Asks) {
  EXPECT_EQ(
      asCsv(tableOf({{"a \"b\"", "c,d", "e\rf"}})),
      "written,coded,last\n\"a \"\"b\"\"\",\"c,d\",\"e\rf\"\n");
}

TEST(DataTable, QuotesItsHeadingsAsItsCells) {
  DataTable table = tableOf({{"a", "b", "c"}});
  table.columns[0].name = "=1+1";
  table.columns[1].name = "Power, simulated";
  table.columns[2].name = "say \"x\"";
  const Lines expected{{"'=1+1", "Power, simulated", "say \"x\""}, {"a", "b", "c"}};
  EXPECT_EQ(StrictReader(asCsv(table)).read(), expected);
}

}  // namespace data_table_test
}  // namespace study

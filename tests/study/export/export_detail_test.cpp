// What an export tells by default, and what on request only.
#include <algorithm>
#include <map>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "analysis/data/csv_table.h"
#include "study/export/export.h"
#include "tests/study/everything_instrument.h"
#include "tests/study/made_study.h"
#include "tests/study/walk.h"

namespace study {
namespace export_detail_test {

constexpr double kCount = 31.4;  // the item has 0 to 70 in steps of 0.1: bands of five
constexpr const char* kStory = "It felt like my first meniscus";
constexpr const char* kNote = "came with a colleague";

class ExportDetailTest : public testing::Test {
 protected:
  void takePart() {
    auto session = Session::enrol(*study_, {.cohort = "surgeons"});
    tests::walkTo(session, StepKind::Form);
    session.record({.item = "agree", .response = std::int64_t{1}, .itemOrder = 1});
    session.record({.item = "count", .response = kCount, .itemOrder = 2});
    session.record({.item = "story", .response = std::string(kStory), .itemOrder = 4});
    session.record({.item = "name", .response = std::string("Kari"), .itemOrder = 5});
    session.finishStep();
    session.note(kNote);
    tests::walkToTheEnd(session);
  }

  /// The cells of a column, from all rows of a table; no table: std::nullopt.
  std::optional<std::map<std::string, int>> cells(
      const ExportOptions& options, const std::string& table, const std::string& column) {
    for (const auto& each : exportTables(*study_, options)) {
      if (each.name != table) continue;
      const auto csv = analysis::readCsv(asCsv(each));
      const auto& names = csv.columns;
      if (std::find(names.begin(), names.end(), column) == names.end()) return std::nullopt;
      std::map<std::string, int> found;
      for (const auto& row : csv.rows) ++found[row.cells[csv.columnIndex(column)]];
      return found;
    }
    return std::nullopt;
  }

  bool isAnywhere(const ExportOptions& options, const std::string& text) {
    for (const auto& table : exportTables(*study_, options)) {
      if (asCsv(table).find(text) != std::string::npos) return true;
    }
    return false;
  }

  tests::MadeStudy study_{tests::protocolFrom(
      tests::protocolWithEverything(), {{"everything.json", tests::everythingInstrument()}})};
};

TEST_F(ExportDetailTest, IsABandOfANumberAboutAPerson) {
  takePart();
  EXPECT_EQ(cells({}, "responses", "response")->count("30 to <35"), 1U);
  EXPECT_FALSE(isAnywhere({}, "31.4"));
  EXPECT_FALSE(isAnywhere({.isBlinded = false}, "31.4"));
  EXPECT_EQ(cells({.isExact = true}, "responses", "response")->count("31.4"), 1U);
}

TEST_F(ExportDetailTest, IsTheDayOfTheStudyNotTheDate) {
  takePart();
  study_.clock.advance(49.0 * 3600.0);
  takePart();
  EXPECT_EQ(*cells({}, "sessions", "day"), (std::map<std::string, int>{{"1", 1}, {"3", 1}}));
  EXPECT_FALSE(isAnywhere({}, "2000-01-0"));
  for (const auto* table : {"sessions", "responses", "events"}) {
    for (const auto* column : {"started_utc", "ended_utc", "saved_utc", "utc"}) {
      EXPECT_FALSE(cells({.isBlinded = false}, table, column)) << table << ": " << column;
    }
  }
  EXPECT_TRUE(cells({.isExact = true}, "sessions", "started_utc"));
  EXPECT_TRUE(cells({.isBlinded = false, .isExact = true}, "events", "utc"));
}

TEST_F(ExportDetailTest, HasWhatPeopleWroteOnRequestInATableOfItsOwn) {
  takePart();
  const ExportOptions open{.isBlinded = false};
  for (const auto* text : {kStory, kNote}) EXPECT_FALSE(isAnywhere(open, text)) << text;
  const ExportOptions withTexts{.isBlinded = false, .hasTexts = true};
  EXPECT_EQ(cells(withTexts, "texts", "response_text")->count(kStory), 1U);
  EXPECT_EQ(cells(withTexts, "responses", "response")->count(kStory), 0U);
  EXPECT_TRUE(isAnywhere(withTexts, kNote));
  EXPECT_EQ(cells({.hasTexts = true}, "texts", "response_text")->count(kStory), 1U)
      << "blinded, too";
  EXPECT_FALSE(isAnywhere({.hasTexts = true}, kNote)) << "notes describe trials";
}

TEST_F(ExportDetailTest, IsWrittenInTheReadmeAndTheCodebook) {
  takePart();
  const auto coarse = study_.scratch() / "coarse";
  exportStudy(*study_, coarse, {.runMode = RunMode::Live});
  EXPECT_NE(tests::contentOf(coarse + "/README.md").find("- Coarse: "), std::string::npos);
  EXPECT_NE(
      tests::contentOf(coarse + "/codebook.json").find("\"coarse\": true"), std::string::npos);
  const auto exact = study_.scratch() / "exact";
  exportStudy(*study_, exact, {.runMode = RunMode::Live, .isExact = true, .hasTexts = true});
  EXPECT_EQ(tests::contentOf(exact + "/README.md").find("- Coarse: "), std::string::npos);
  EXPECT_EQ(tests::contentOf(exact + "/README.md").find("`--texts`"), std::string::npos);
}

}  // namespace export_detail_test
}  // namespace study

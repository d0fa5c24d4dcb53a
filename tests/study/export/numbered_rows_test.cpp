// One row of the tables of answers, sessions, events and items, with a different value in every
// field, so that exchanged fields are detected. The other tables: export_columns_test.cpp, and
// tests/study/report/exported_results_test.cpp.
#include <algorithm>
#include <cctype>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "questionnaires/model/answer.h"
#include "study/export/codebook.h"
#include "study/export/condition_codes.h"
#include "study/export/study_tables.h"
#include "tests/study/everything_instrument.h"
#include "tests/study/exported_rows.h"
#include "tests/study/made_study.h"
#include "tests/study/walk.h"

namespace study {
namespace numbered_rows_test {

using Row = tests::ExportedRow;

/// The second session of this study, in its second attempt to answer about the second alternative.
class NumberedRows : public testing::Test {
 protected:
  NumberedRows() {
    tests::walkToTheEnd(earlier_);
    study_.clock.advance(4.0 * 86'400.0);
    session_.emplace(
        Session::enrol(*study_, {.cohort = "students", .language = "de", .code = "S17"}));
    for (int trial = 0; trial < 2; ++trial) {
      tests::walkTo(*session_, StepKind::Trial);
      felt_ = session_->step();
      tests::passStep(*session_);
    }
    tests::passStep(*session_);
    session_->repeatStep("answered for another alternative");
  }

  std::string stepNumber() const { return std::to_string(session_->stepIndex() + 1); }

  tests::MadeStudy study_;
  Session earlier_ = Session::enrol(*study_, {.cohort = "students", .code = "S16"});
  std::optional<Session> session_;
  Step felt_;
};

TEST_F(NumberedRows, AreOneForEachAlternativeInAWideTable) {
  const StudyRows rows(*study_, {.isBlinded = false});
  const auto answers = rows.answers();
  const auto wide = wideRows(study_->protocol(), answers);
  std::set<std::tuple<std::string_view, std::string_view, int>> alternatives;
  std::size_t points = 0;
  for (const auto& answer : answers) {
    const bool isAsked = answer.record->step.kind == StepKind::Questionnaire;
    if (!answer.excluded.empty() || !answer.alternative || !isAsked) continue;
    alternatives.emplace(answer.owner.participant, answer.block, *answer.alternative);
    ++points;
  }
  EXPECT_EQ(wide.size(), 3U);
  EXPECT_EQ(wide.size(), alternatives.size());
  std::size_t cells = 0;
  std::size_t scores = 0;
  for (const auto& row : wide) {
    for (const auto& [column, cell] : row.cells) {
      (column.find("__score_") == std::string::npos ? cells : scores) += 1;
    }
  }
  EXPECT_EQ(cells, points);
  EXPECT_EQ(scores, wide.size());
  const auto table = wideTable(study_->protocol());
  for (const auto& [name, cell] : wide.front().cells) {
    const std::string& column = name;
    EXPECT_TRUE(std::ranges::any_of(table.columns, [&](const auto& one) {
      return one.name() == column;
    })) << column;
  }
}

TEST_F(NumberedRows, OfAWideTableHaveAColumnForIdsThatDifferInPunctuationOrCase) {
  auto loaded = study_->protocol();
  for (auto& instrument : loaded.instruments) {
    auto items = instrument.items;
    for (auto& item : items) item.id += "-b";
    const auto others = instrument.items.size();
    instrument.items.insert(instrument.items.end(), items.begin(), items.end());
    for (auto& item : items) item.id.back() = 'B';
    instrument.items.insert(instrument.items.end(), items.begin(), items.end());
    for (auto& item : items) std::ranges::replace(item.id, '-', '.');
    instrument.items.insert(instrument.items.end(), items.begin(), items.end());
    EXPECT_EQ(instrument.items.size(), 4 * others);
  }
  const auto plain = wideTable(study_->protocol()).columns;
  std::set<std::string> names;
  const auto columns = wideTable(loaded).columns;
  for (const auto& column : columns) {
    std::string name = column.name();
    std::ranges::transform(name, name.begin(), [](char c) {
      return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    });
    EXPECT_TRUE(names.insert(name).second) << column.name();
  }
  EXPECT_GT(columns.size(), plain.size() + 3);
}

TEST_F(NumberedRows, OfAnAnswerHasEachNumberInTheColumnThatIsNamedAfterIt) {
  const auto items = session_->items();
  const auto item = *std::ranges::find(items, "cutting-through", &questionnaires::Item::id);
  ASSERT_EQ(item.key, -1);
  for (const auto& other : items) {
    if (other.id != item.id) session_->record(tests::answerTo(*session_, other));
  }
  session_->record(
      {.item = item.id,
       .response = std::int64_t{4},
       .itemOrder = 3,
       .firstTouch = 5.5,
       .responseTime = 6.5,
       .changes = 7,
       .language = "de"});
  const Row expected{
      {"participant_id", "S17"},
      {"session_num", "1"},
      {"cohort", "students"},
      {"run_mode", "live"},
      {"step_num", stepNumber()},
      {"attempt", "2"},
      {"block", "felt"},
      {"position", "2"},
      {"alternative", std::to_string(felt_.label)},
      {"condition_code", conditionCodes(*study_, RunMode::Live).at(felt_.condition)},
      {"condition", felt_.condition},
      {"instrument", "realism-cuts"},
      {"item_id", "cutting-through"},
      {"item_order", "3"},
      {"item_type", "likert"},
      {"key", "-1"},
      {"response", "4"},
      {"response_keyed", "2"},
      {"response_label", "stimme eher zu"},
      {"first_touch_s", "5.5"},
      {"response_time_s", "6.5"},
      {"n_changes", "7"},
      {"language", "de"},
      {"included", "true"},
      {"exclude_reason", ""}};
  session_->finishStep();
  tests::walkToTheEnd(*session_);
  std::vector<Row> rows;
  for (const auto& row : tests::rowsOf(*study_, "responses", {.isBlinded = false})) {
    const bool isIt = row.at("participant_id") == "S17" && row.at("item_order") == "3" &&
                      row.at("attempt") == "2";
    if (isIt && row.at("item_id") == item.id) rows.push_back(row);
  }
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0], expected);
}

TEST_F(NumberedRows, OfASessionHasEachFieldInItsColumn) {
  study_.clock.advance(86'400.0);
  session_->withdraw("has to leave");
  const auto rows =
      tests::rowsOf(*study_, "sessions", {.isBlinded = false, .isExact = true, .hasTexts = true});
  ASSERT_EQ(rows.size(), 2U);
  const Row expected{
      {"participant_id", "S17"},
      {"session_num", "1"},
      {"cohort", "students"},
      {"run_mode", "live"},
      {"status", "withdrawn"},
      {"end_reason", "has to leave"},
      {"included", "false"},
      {"session_language", "de"},
      {"place", "2"},
      {"day", "5"},
      {"started_utc", "2000-01-05T10:00:00.000Z"},
      {"ended_utc", "2000-01-06T10:00:00.000Z"},
      {"protocol_hash", rows[1].at("protocol_hash")},
      {"app_version", std::string(appVersion())}};
  EXPECT_EQ(rows[1], expected);
  EXPECT_EQ(rows[1].at("protocol_hash").size(), 64U);
}

TEST_F(NumberedRows, OfAnEventHasEachFieldInItsColumn) {
  study_.clock.advance(12.25);
  session_->pause("a telephone call");
  const auto rows =
      tests::rowsOf(*study_, "events", {.isBlinded = false, .isExact = true, .hasTexts = true});
  const Row expected{
      {"participant_id", "S17"},
      {"session_num", "1"},
      {"step_num", stepNumber()},
      {"attempt", "2"},
      {"utc", "2000-01-05T10:00:12.250Z"},
      {"onset_s", "12.25"},
      {"actor", "operator"},
      {"event", "paused_session"},
      {"detail", "a telephone call"}};
  ASSERT_FALSE(rows.empty());
  EXPECT_EQ(rows.back(), expected);
}

/// Many tests walk through this instrument to try every type of item.
TEST(NumberedItems, OfTheInstrumentOfAllTestsAreOfEveryType) {
  tests::MadeStudy study(tests::protocolFrom(
      tests::protocolWithEverything(), {{"everything.json", tests::everythingInstrument()}}));
  std::set<std::string> types;
  for (const auto& row : tests::rowsOf(itemsTable(*study, {}))) {
    if (row.at("instrument") == "everything") types.insert(row.at("item_type"));
  }
  std::set<std::string> expected;
  for (const auto& type : questionnaires::kItemTypes) expected.emplace(type.name);
  EXPECT_EQ(types, expected);
}

TEST(NumberedItems, HaveEachFieldInItsColumn) {
  auto text = tests::everythingInstrument();
  const std::string words = R"("right_label": {"en": "hard", "de": "hart", "nb": "hard"}, )";
  text.insert(
      text.find(words) + words.size(),
      R"("key": -1, "text": {"en": "how", "de": "wie", "nb": "hvordan"}, )");
  tests::MadeStudy study(
      tests::protocolFrom(tests::protocolWithEverything(), {{"everything.json", text}}));
  std::vector<Row> rows;
  for (const auto& row : tests::rowsOf(itemsTable(*study, {}))) {
    if (row.at("item_id") == "words" && row.at("language") == "de") rows.push_back(row);
  }
  const Row expected{
      {"instrument", "everything"},
      {"instrument_version", "1"},
      {"item_id", "words"},
      {"item_num", "2"},
      {"item_type", "semantic_differential"},
      {"key", "-1"},
      {"relative_to", ""},
      {"lowest", "1"},
      {"highest", "5"},
      {"language", "de"},
      {"text", "wie"},
      {"left_text", "weich"},
      {"right_text", "hart"},
      {"scale", "1=weich; 2; 3; 4; 5=hart"}};
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0], expected);
}

}  // namespace numbered_rows_test
}  // namespace study

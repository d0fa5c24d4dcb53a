// The content of every column of every exported table, and the tables and columns of blinded
// exports.
#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "analysis/data/csv_table.h"
#include "study/cohort/simulated_participant.h"
#include "study/export/condition_codes.h"
#include "study/export/export.h"
#include "study/export/export_parts.h"
#include "study/storage/records.h"
#include "tests/study/exported_rows.h"
#include "tests/study/made_study.h"
#include "tests/study/walk.h"
#include "tests/support/scratch_folder.h"

namespace study {
namespace export_columns_test {

namespace fs = std::filesystem;

using Names = std::vector<std::string>;
using Row = tests::ExportedRow;

std::vector<Row> rowsOf(Study& study, const std::string& table) {
  return tests::rowsOf(study, table, {.isBlinded = false});
}

/// A trial with a different number in every field, so that exchanged fields are detected.
TrialRecord numberedTrial() {
  using Cut = TrialRecord::Cut;
  TrialRecord trial{
      .device = "a punch",
      .travelUnit = "travel_unit",
      .duration = 1.5,
      .ticks = 2001,
      .nominalRate = 1003.0,
      .achievedRate = 1004.25,
      .latenessMedian = 5.5,
      .latenessP99 = 6.5,
      .latenessLargest = 7.5,
      .lateTicks = 8,
      .hostPauses = 9,
      .lostSamples = 10,
      .invalidTicks = 11,
      .saturated = 12.5,
      .slewed = 13.5,
      .undefined = 14.5,
      .contact = 15.5,
      .largestForce = 16.5,
      .traceSamples = 17};
  Cut cut;
  cut.interception = {.travel = 21.5, .force = 22.5, .found = true};
  cut.yield = {.travel = 23.5, .force = 24.5, .found = true};
  cut.bottomOut = {.travel = 25.5, .force = 26.5, .found = true};
  cut.opening = {.travel = 27.5, .force = 28.5, .found = true};
  cut.peakForce = 29.5;
  trial.cuts = {cut, Cut{}, Cut{}};
  trial.cuts[1].peakForce = 30.5;
  return trial;
}

/// The second trial of one participant.
class ExportedTrial : public testing::Test {
 protected:
  ExportedTrial() {
    tests::walkTo(session_, StepKind::Trial);
    tests::passStep(session_);
    tests::walkTo(session_, StepKind::Trial);
    step_ = session_.step();
    visit_ = session_.visit();
    session_.beginTrial();
    session_.finishTrial(trial_);
  }

  std::string code() { return conditionCodes(*study_, RunMode::Live).at(step_.condition); }
  std::string stepNumber() const { return std::to_string(visit_.step + 1); }

  tests::MadeStudy study_;
  Session session_ = Session::enrol(*study_, {.cohort = "students", .code = "S17"});
  TrialRecord trial_ = numberedTrial();
  Step step_;
  VisitKey visit_;
};

TEST_F(ExportedTrial, HasEachNumberInTheColumnThatIsNamedAfterIt) {
  const auto judgement = trial_.judgement();
  const Row expected{
      {"participant_id", "S17"},
      {"session_num", "1"},
      {"cohort", "students"},
      {"run_mode", "live"},
      {"step_num", stepNumber()},
      {"attempt", "1"},
      {"block", "felt"},
      {"position", "2"},
      {"alternative", std::to_string(step_.label)},
      {"condition_code", code()},
      {"condition", step_.condition},
      {"device", "a punch"},
      {"travel_unit", "travel_unit"},
      {"ending", "finished"},
      {"qc_status", "FAIL"},
      {"qc_reason", base::describe(judgement.reasons)},
      {"duration_s", "1.5"},
      {"cuts", "3"},
      {"contact_s", "15.5"},
      {"saturation_s", "12.5"},
      {"slewed_s", "13.5"},
      {"undefined_s", "14.5"},
      {"ticks", "2001"},
      {"nominal_rate_hz", "1003"},
      {"loop_rate_hz", "1004.25"},
      {"lateness_p50_us", "5.5"},
      {"lateness_p99_us", "6.5"},
      {"lateness_max_us", "7.5"},
      {"deadline_misses", "8"},
      {"lost_samples", "10"},
      {"invalid_ticks", "11"},
      {"trace_samples", "17"}};
  const auto rows = rowsOf(*study_, "trials");
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[1], expected);
}

TEST_F(ExportedTrial, HasEachLandmarkOfACutInItsOwnColumns) {
  const Row expected{
      {"participant_id", "S17"},
      {"session_num", "1"},
      {"step_num", stepNumber()},
      {"attempt", "1"},
      {"cut_num", "1"},
      {"interception_travel", "21.5"},
      {"interception_n", "22.5"},
      {"yield_travel", "23.5"},
      {"yield_n", "24.5"},
      {"bottom_out_travel", "25.5"},
      {"bottom_out_n", "26.5"},
      {"opening_travel", "27.5"},
      {"opening_n", "28.5"},
      {"peak_n", "29.5"}};
  std::vector<Row> rows;
  for (const auto& row : rowsOf(*study_, "cuts")) {
    if (row.at("step_num") == stepNumber()) rows.push_back(row);
  }
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0], expected);
  EXPECT_EQ(rows[1].at("cut_num"), "2");
  EXPECT_EQ(rows[1].at("peak_n"), "30.5");
  EXPECT_EQ(rows[1].at("yield_travel"), "") << "a landmark that was not found is missing";
}

TEST_F(ExportedTrial, IsReadBackFromTheDatabaseAsItWasRecorded) {
  const auto rows = storage::Records(study_->database()).trials();
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[1].travelUnit, "travel_unit");
  EXPECT_EQ(rows[1].largestForce, 16.5);
}

TEST(Export, MarksAnswersThatDoNotCountWithTheReason) {
  tests::MadeStudy study;
  auto completed = Session::enrol(*study, {.cohort = "surgeons", .code = "A1"});
  tests::walkTo(completed, StepKind::Questionnaire);
  const auto questions = std::to_string(completed.stepIndex() + 1);
  tests::passStep(completed);
  completed.repeatStep("somebody else had answered");
  tests::walkToTheEnd(completed);
  auto withdrawn = Session::enrol(*study, {.cohort = "surgeons", .code = "A2"});
  tests::walkTo(withdrawn, StepKind::Questionnaire);
  tests::answerStep(withdrawn);
  withdrawn.withdraw("has to leave");
  auto skipped = Session::enrol(*study, {.cohort = "surgeons", .code = "A3"});
  tests::walkTo(skipped, StepKind::Questionnaire);
  tests::answerStep(skipped);
  skipped.skipStep("answered for another alternative");
  tests::walkToTheEnd(skipped);

  std::map<std::string, std::set<std::string>> said;
  for (const auto& row : rowsOf(*study, "responses")) {
    if (row.at("step_num") != questions) continue;
    said[row.at("participant_id") + ", attempt " + row.at("attempt")].insert(
        row.at("included") + " " + row.at("exclude_reason"));
  }
  const std::map<std::string, std::set<std::string>> expected{
      {"A1, attempt 1", {"false repeated"}},
      {"A1, attempt 2", {"true "}},
      {"A2, attempt 1", {"false withdrawn"}},
      {"A3, attempt 1", {"false skipped"}}};
  EXPECT_EQ(said, expected);
}

TEST(Export, LabelsAnAnswerInTheLanguageInWhichItWasGiven) {
  tests::MadeStudy study;
  auto session = Session::enrol(*study, {.cohort = "surgeons", .language = "en", .code = "A1"});
  tests::walkTo(session, StepKind::Questionnaire);
  tests::answerStep(session);
  session.setLanguage("de");
  session.finishStep();
  tests::walkToTheEnd(session);
  std::set<std::string> english;
  std::set<std::string> german;
  for (const auto& row : rowsOf(*study, "responses")) {
    if (row.at("item_id") != "resistance") continue;
    (row.at("language") == "en" ? english : german).insert(row.at("response_label"));
  }
  ASSERT_EQ(english.size(), 1U);
  ASSERT_FALSE(german.empty());
  EXPECT_FALSE(german.contains(*english.begin())) << *english.begin();
}

/// How often each condition, or code, was voted for, by the labels of answers.
std::map<std::string, int> votesByLabel(Study& study, bool isBlinded) {
  std::map<std::string, int> votes;
  const ExportOptions options{.runMode = RunMode::Simulated, .isBlinded = isBlinded};
  for (const auto& row : tests::rowsOf(study, "responses", options)) {
    if (row.at("block") == "choice") ++votes[row.at("response_label")];
  }
  return votes;
}

/// … by the votes table.
std::map<std::string, int> votesByTable(Study& study) {
  std::map<std::string, int> votes;
  const ExportOptions options{.runMode = RunMode::Simulated, .isBlinded = false};
  for (const auto& table : tablesFor(study, options)) {
    if (table.name != "votes") continue;
    for (const auto& row : tests::rowsOf(table)) {
      const auto count = std::stoi(row.at("votes"));
      if (count > 0) votes[row.at("condition_code")] += count;
    }
  }
  return votes;
}

TEST(Export, LabelsAVoteWithTheConditionThatTheVotesTableCounts) {
  tests::MadeStudy study;
  simulateCohorts(*study, study.clock, 4, 3, [](const auto&) {});
  const auto byCode = votesByLabel(*study, true);
  EXPECT_EQ(byCode, votesByTable(*study));
  std::map<std::string, int> byCondition;
  for (const auto& [condition, code] : conditionCodes(*study, RunMode::Simulated)) {
    if (byCode.contains(code)) byCondition[condition] = byCode.at(code);
  }
  EXPECT_EQ(votesByLabel(*study, false), byCondition);
}

TEST(Export, GivesNoCodeOfAVoteIfBlindedWhereNoOtherAnswerHasIt) {
  tests::MadeStudy study(tests::protocolFrom(tests::shortProtocol({.questionnaire = ""})));
  simulateCohorts(*study, study.clock, 2, 3, [](const auto&) {});
  EXPECT_EQ(votesByLabel(*study, true), (std::map<std::string, int>{{"", 2}}));
  EXPECT_FALSE(votesByLabel(*study, false).contains(""));
}

/// Conditions in the order of their codes: C1, C2, …
Names codedConditions(Study& study, RunMode mode) {
  std::map<std::string, std::string> byCode;
  for (const auto& [condition, code] : conditionCodes(study, mode)) byCode[code] = condition;
  Names conditions;
  for (const auto& [code, condition] : byCode) conditions.push_back(code + " " + condition);
  return conditions;
}

// Computed in Python independently of base/random.cpp: the sorted ids, shuffled by Fisher–Yates
// with xoshiro256**; its state is filled by SplitMix64 from the seed, 0 and FNV-1a("blinding").
TEST(ConditionCodes, OfSimulatedSessionsAreShuffledByTheSeedOfTheStudy) {
  const auto codes = [](std::uint64_t seed) {
    tests::MadeStudy study(tests::protocolFrom(tests::shortProtocol()), seed);
    return codedConditions(*study, RunMode::Simulated);
  };
  EXPECT_EQ(codes(1), (Names{"C1 kalman", "C2 finite-elements", "C3 interpolation"}));
  EXPECT_EQ(codes(2), (Names{"C1 finite-elements", "C2 kalman", "C3 interpolation"}));
  EXPECT_EQ(codes(3), (Names{"C1 interpolation", "C2 finite-elements", "C3 kalman"}));
  EXPECT_EQ(codes(8), (Names{"C1 interpolation", "C2 kalman", "C3 finite-elements"}));
}

TEST(ConditionCodes, StayWhenALaterVersionAddsConditions) {
  tests::MadeStudy study;
  study->amend(
      tests::protocolFrom(tests::shortProtocol(
          {.conditions = {"another", "finite-elements", "interpolation", "kalman"}})),
      "for a test");
  EXPECT_EQ(
      codedConditions(*study, RunMode::Simulated),
      (Names{"C1 kalman", "C2 finite-elements", "C3 interpolation", "C4 another"}));
}

using Tables = std::map<std::string, Names>;  ///< columns by the table's name

const Tables& blindedTables() {
  static const Tables kTables{
      {"sessions",
       {"participant_id",
        "session_num",
        "cohort",
        "run_mode",
        "status",
        "included",
        "session_language",
        "day",
        "protocol_hash",
        "app_version"}},
      {"responses",
       {"participant_id", "session_num",    "cohort",         "run_mode",      "step_num",
        "attempt",        "block",          "position",       "alternative",   "condition_code",
        "instrument",     "item_id",        "item_order",     "item_type",     "key",
        "response",       "response_keyed", "response_label", "first_touch_s", "response_time_s",
        "n_changes",      "language",       "included",       "exclude_reason"}},
      {"items",
       {"instrument",
        "instrument_version",
        "item_id",
        "item_num",
        "item_type",
        "key",
        "relative_to",
        "lowest",
        "highest",
        "language",
        "text",
        "left_text",
        "right_text",
        "scale"}}};
  return kTables;
}

/// Those of a study that asks 'realism-common' about its conditions.
const Names& wideColumns() {
  static const Names kColumns{
      "participant_id",
      "session_num",
      "cohort",
      "run_mode",
      "block",
      "position",
      "alternative",
      "condition_code",
      "realism_common__resistance",
      "realism_common__cutting_through",
      "realism_common__end_of_travel",
      "realism_common__unlike_benchmark",
      "realism_common__overall",
      "realism_common__usefulness",
      "realism_common__score_realism"};
  return kColumns;
}

/// The keys of each source of scenes in the head of a JSON export.
const Names kSources{"kind", "synthetic"};

const Names kColumnsTable{
    "table", "column", "type", "unit_symbol", "description", "value", "label"};

/// The text from @p begin to the next @p end.
std::string between(const std::string& text, const std::string& begin, const std::string& end) {
  const auto from = text.find(begin);
  if (from == std::string::npos) return {};
  const auto start = from + begin.size();
  return text.substr(start, text.find(end, start) - start);
}

/// The content of a folder: its tables, and the names of all other files.
struct Content {
  Tables tables;
  std::set<std::string> others;
};

/// The table that a file of a BIDS folder holds.
std::string bidsTable(const fs::path& file) {
  const std::string stem = file.stem().string();
  const auto acquisition = between(stem, "_acq-", "_");
  if (!acquisition.empty()) return acquisition;
  return stem.substr(stem.rfind('_') + 1);
}

void readJsonTables(const fs::path& file, Tables& tables) {
  const auto json = nlohmann::ordered_json::parse(tests::contentOf(file));
  for (const auto& [name, table] : json.items()) {
    if (!table.is_array()) continue;
    for (const auto& [column, cell] : table.front().items()) tables[name].push_back(column);
  }
}

Content contentOf(const fs::path& folder) {
  Content content;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    const auto& path = entry.path();
    const auto text = tests::contentOf(path);
    const auto name = path.stem().string();
    if (path.extension() == ".csv") {
      const auto psychDs = between(name, "_description-", "_data");
      content.tables[psychDs.empty() ? name : psychDs] = analysis::readCsv(text).columns;
    } else if (path.extension() == ".tsv") {
      auto& columns = content.tables[bidsTable(path)];
      columns.clear();
      std::istringstream head(text.substr(0, text.find('\n')));
      for (std::string column; std::getline(head, column, '\t');) columns.push_back(column);
    } else if (name == "study") {
      readJsonTables(path, content.tables);
    } else {
      content.others.insert(fs::relative(path, folder).generic_string());
    }
  }
  return content;
}

class BlindedExport : public testing::Test {
 protected:
  void take(int people) {
    simulateCohorts(*study_, study_.clock, people, 3, [](const auto&) {});
  }

  Content exported(ExportFormat format, std::optional<std::size_t> publicClassSize = std::nullopt) {
    const auto folder = folder_ / ("out" + std::to_string(++exports_));
    exportStudy(
        *study_,
        folder,
        {.format = format, .runMode = RunMode::Simulated, .publicClassSize = publicClassSize});
    return contentOf(folder);
  }

  tests::ScratchFolder folder_;
  tests::MadeStudy study_{tests::libraryProtocol("punch-counterbalanced.json"), 1};
  int exports_ = 0;
};

TEST_F(BlindedExport, HasTheseTablesAndColumnsAndNoOthersAsCsvAndJson) {
  take(2);
  const std::set<std::string> others{"README.md", "codebook.json"};
  const auto csv = exported(ExportFormat::Csv);
  auto inCsv = blindedTables();
  inCsv["wide"] = wideColumns();
  EXPECT_EQ(csv.tables, inCsv);
  EXPECT_EQ(csv.others, others);
  auto expected = blindedTables();
  expected["felt_from"] = kSources;
  const auto json = exported(ExportFormat::Json);
  EXPECT_EQ(json.tables, expected);
  EXPECT_EQ(json.others, others);
}

TEST_F(BlindedExport, HasTheseTablesAndColumnsAndNoOthersForRAndPython) {
  take(2);
  auto expected = blindedTables();
  expected["columns"] = kColumnsTable;
  const auto forR = exported(ExportFormat::R);
  EXPECT_EQ(forR.tables, expected);
  EXPECT_EQ(forR.others, (std::set<std::string>{"README.md", "codebook.json", "read_tables.R"}));
  const auto forPython = exported(ExportFormat::Python);
  EXPECT_EQ(forPython.tables, expected);
  EXPECT_EQ(
      forPython.others, (std::set<std::string>{"README.md", "codebook.json", "read_tables.py"}));
}

TEST_F(BlindedExport, HasTheseTablesAndColumnsAndNoOthersAsPsychDs) {
  take(2);
  const auto content = exported(ExportFormat::PsychDs);
  EXPECT_EQ(content.tables, blindedTables());
  std::set<std::string> expected{"README.md", "CHANGES.md", "dataset_description.json"};
  for (const auto& [table, columns] : blindedTables()) {
    expected.insert("data/study-punchcounterbalanced_description-" + table + "_data.json");
  }
  EXPECT_EQ(content.others, expected);
}

/// Without the columns that are part of a BIDS file's path.
Names withoutWhose(const Names& columns) {
  return {columns.begin() + 2, columns.end()};
}

TEST_F(BlindedExport, HasTheseTablesAndColumnsAndNoOthersAsBids) {
  take(2);
  auto expected = blindedTables();
  for (const auto* table : {"sessions", "responses"}) {
    expected[table] = withoutWhose(expected[table]);
  }
  auto& sessions = expected["sessions"];
  sessions.insert(sessions.begin(), "session_id");
  expected["participants"] = {"participant_id", "cohort", "run_mode"};
  const auto content = exported(ExportFormat::Bids);
  EXPECT_EQ(content.tables, expected);
  for (const auto& file : content.others) {
    EXPECT_TRUE(file.ends_with(".json") || file == "README.md") << file;
  }
}

TEST_F(BlindedExport, ThatIsPublicHasParticipantsResponsesAndItemsOnly) {
  take(12);
  for (const auto format :
       {ExportFormat::Csv,
        ExportFormat::Json,
        ExportFormat::PsychDs,
        ExportFormat::R,
        ExportFormat::Python}) {
    auto tables = exported(format, kSmallestPublicClassSize).tables;
    tables.erase("columns");
    if (format == ExportFormat::Json) {
      EXPECT_EQ(tables["felt_from"], kSources);
      tables.erase("felt_from");
    }
    Names names;
    for (const auto& [name, columns] : tables) names.push_back(name);
    EXPECT_EQ(names, (Names{"items", "participants", "responses"})) << static_cast<int>(format);
    auto& responses = tables["responses"];
    std::erase_if(responses, [](const auto& column) {
      // released if enough people share the value
      return column == "cohort" || column == "position";
    });
    EXPECT_EQ(
        responses,
        (Names{
            "participant_id",
            "block",
            "condition_code",
            "instrument",
            "item_id",
            "item_type",
            "key",
            "response",
            "response_keyed",
            "response_label"}));
  }
}

TEST_F(BlindedExport, LacksWhatTheRenderingMakesMeasurableAndEverythingThatNamesACondition) {
  take(2);
  const auto folder = folder_ / "open";
  exportStudy(*study_, folder, {.runMode = RunMode::Simulated, .isBlinded = false}, "for a test");
  auto tables = contentOf(folder).tables;
  for (const auto* table : {"trials", "cuts", "events", "statistics", "votes"}) {
    EXPECT_EQ(tables.erase(table), 1U) << table;
  }
  EXPECT_EQ(std::erase(tables["sessions"], "place"), 1U);
  EXPECT_EQ(std::erase(tables["responses"], "condition"), 1U);
  EXPECT_EQ(std::erase(tables["wide"], "condition"), 1U);
  auto expected = blindedTables();
  expected["wide"] = wideColumns();
  EXPECT_EQ(tables, expected);
}

/// The codebook of a blinded export.
nlohmann::json codebookOf(Study& study, const fs::path& folder) {
  exportStudy(study, folder, {.runMode = RunMode::Simulated});
  return nlohmann::json::parse(tests::contentOf(folder / "codebook.json"));
}

TEST_F(BlindedExport, SaysThatItIsBlinded) {
  take(1);
  const auto head = codebookOf(*study_, folder_ / "out");
  EXPECT_EQ(head["blinded"], true);
  EXPECT_FALSE(head.contains("not_blinded_because"));
  EXPECT_EQ(blindingInWords(*study_, {}), "blinded");
  EXPECT_EQ(blindingInWords(*study_, {.isBlinded = false}), "NOT blinded");
  EXPECT_NE(tests::contentOf(folder_ / "out/README.md").find("- Blinded: "), std::string::npos);
}

TEST(ExportWithCodes, IsNotCalledBlindedWhereTheProtocolTellsTheConditions) {
  tests::ScratchFolder scratch;
  tests::MadeStudy study(tests::protocolFrom(tests::shortProtocol({.order = "fixed"})));
  const auto head = codebookOf(*study, scratch / "out");
  EXPECT_EQ(head["blinded"], false);
  EXPECT_EQ(head["not_blinded_because"], "the position in 'felt' says which condition it is");
  const auto readme = tests::contentOf(scratch / "out/README.md");
  EXPECT_EQ(readme.find("- Blinded"), std::string::npos);
  EXPECT_NE(readme.find("- Not blinded, although conditions have codes."), std::string::npos);
  EXPECT_EQ(
      blindingInWords(*study, {}),
      "with codes for conditions but NOT blinded (the position in 'felt' says which condition it "
      "is)");
}

TEST(ExportWithCodes, StaysNotBlindedAfterAnAmendmentThatWouldBe) {
  tests::MadeStudy study(tests::protocolFrom(tests::shortProtocol({.order = "fixed"})));
  study->amend(tests::protocolFrom(tests::shortProtocol()), "for a test");
  EXPECT_EQ(disclosuresOf(*study).size(), 1U);
}

}  // namespace export_columns_test
}  // namespace study

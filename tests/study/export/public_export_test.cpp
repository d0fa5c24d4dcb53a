// Public exports: every person is like others in them, and cannot be linked to the study.
#include <filesystem>
#include <map>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "analysis/data/csv_table.h"
#include "study/cohort/simulated_participant.h"
#include "study/export/condition_codes.h"
#include "study/export/export.h"
#include "study/export/public_tables.h"
#include "study/storage/records.h"
#include "tests/study/everything_instrument.h"
#include "tests/study/made_study.h"
#include "tests/study/walk.h"
#include "tests/support/scratch_folder.h"

namespace study {
namespace public_export_test {

namespace fs = std::filesystem;

std::map<std::string, std::string> filesOf(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    files[fs::relative(entry.path(), folder).generic_string()] = tests::contentOf(entry.path());
  }
  return files;
}

std::vector<std::string> columnOf(const analysis::CsvTable& table, const std::string& name) {
  std::vector<std::string> cells;
  for (const auto& row : table.rows) cells.push_back(row.cells[table.columnIndex(name)]);
  return cells;
}

class PublicExportTest : public testing::Test {
 protected:
  void take(int people) {
    simulateCohorts(*study_, study_.clock, people, 3, [](const auto&) {});
  }

  std::map<std::string, std::string> exported(
      const std::string& name,
      ExportFormat format = ExportFormat::Csv,
      std::size_t k = kSmallestPublicClassSize) {
    exportStudy(
        *study_,
        folder_ / name,
        {.format = format, .runMode = RunMode::Simulated, .publicClassSize = k});
    return filesOf(folder_ / name);
  }

  tests::ScratchFolder folder_;
  tests::MadeStudy study_{tests::libraryProtocol("punch-counterbalanced.json"), 1};
};

/// The number of people in the smallest class of a table.
std::size_t smallestClassIn(const analysis::CsvTable& participants) {
  std::map<std::vector<std::string>, std::size_t> classes;
  for (const auto& row : participants.rows) {
    ++classes[{row.cells.begin() + 1, row.cells.end()}];
  }
  std::size_t smallest = participants.rows.size();
  for (const auto& [said, count] : classes) smallest = std::min(smallest, count);
  return smallest;
}

TEST_F(PublicExportTest, HasNoClassSmallerThanK) {
  take(20);
  for (const std::size_t k : {5U, 8U}) {
    auto files = exported("out" + std::to_string(k), ExportFormat::Csv, k);
    const auto participants = analysis::readCsv(files.at("participants.csv"));
    EXPECT_EQ(participants.rows.size(), 20U);
    EXPECT_GT(participants.columns.size(), 2U);  // at least one quasi-identifier is released
    EXPECT_GE(smallestClassIn(participants), k);
    EXPECT_NE(files.at("README.md").find("k = " + std::to_string(k)), std::string::npos);
  }
}

TEST_F(PublicExportTest, HoldsNoIdAndNoDate) {
  take(6);
  std::set<std::string> secrets{study_->uuid()};
  const storage::Records records(study_->database());
  for (const auto& session : records.sessions()) {
    secrets.insert({session.participant, session.startedUtc.substr(0, 10)});
  }
  ASSERT_GE(secrets.size(), 8U);
  for (const auto format : {ExportFormat::Csv, ExportFormat::Json, ExportFormat::PsychDs}) {
    for (const auto& [name, content] :
         exported("out" + std::to_string(static_cast<int>(format)), format)) {
      for (const auto& secret : secrets) {
        EXPECT_EQ(content.find(secret), std::string::npos) << name << ": " << secret;
        EXPECT_EQ(name.find(secret), std::string::npos) << name;
      }
      EXPECT_EQ(content.find("_utc"), std::string::npos) << name;
    }
  }
}

/// Live participants with unique texts and numbers.
TEST(PublicExport, HasNoFreeTextAndNoUniqueNumbers) {
  tests::MadeStudy study(tests::protocolFrom(
      tests::protocolWithEverything(), {{"everything.json", tests::everythingInstrument()}}));
  for (int person = 0; person < 6; ++person) {
    auto session = Session::enrol(*study, {.cohort = person % 2 == 0 ? "surgeons" : "students"});
    tests::walkTo(session, StepKind::Form);
    session.record({.item = "agree", .response = std::int64_t{1}, .itemOrder = 1});
    session.record({.item = "count", .response = 31.4 + person, .itemOrder = 2});
    session.record({.item = "line", .response = std::string("sentinel one"), .itemOrder = 3});
    session.record({.item = "story", .response = std::string("sentinel two"), .itemOrder = 4});
    session.record({.item = "name", .response = std::string("sentinel three"), .itemOrder = 5});
    session.finishStep();
    tests::walkToTheEnd(session);
  }
  const tests::ScratchFolder folder;
  exportStudy(*study, folder / "out", {.publicClassSize = kSmallestPublicClassSize});
  const auto files = filesOf(folder / "out");
  for (const auto& [name, content] : files) {
    for (const auto* secret : {"sentinel", "31.4", "33.4", "P001", "surgeons,", "PILOT"}) {
      EXPECT_EQ(content.find(secret), std::string::npos) << name << ": " << secret;
    }
  }
  EXPECT_NE(files.at("responses.csv").find("agree"), std::string::npos);
}

/// Live participants who are all alike, and publish again and again.
class SecondReleaseTest : public testing::Test {
 protected:
  void takePart(int people) {
    for (int i = 0; i < people; ++i) {
      auto session = Session::enrol(*study_, {.cohort = "surgeons"});
      tests::walkToTheEnd(session);
    }
  }
  /// The refusal; empty if it was written.
  std::string publish(const std::string& name, std::size_t k = kSmallestPublicClassSize) {
    try {
      exportStudy(*study_, folder_ / name, {.publicClassSize = k});
      return "";
    } catch (const storage::StorageError& error) {
      EXPECT_FALSE(fs::exists(folder_ / name));
      return error.what();
    }
  }

  tests::ScratchFolder folder_;
  tests::MadeStudy study_{tests::protocolFrom(tests::shortProtocol({.order = "fixed"}))};
};

TEST_F(SecondReleaseTest, IsRefusedWhereSubtractionLeavesFewerThanK) {
  takePart(12);
  EXPECT_EQ(publish("first"), "");
  takePart(1);
  const auto refused = publish("second");
  EXPECT_NE(refused.find("1 of them new"), std::string::npos) << refused;
  takePart(3);
  EXPECT_NE(publish("third"), "");
  takePart(1);
  EXPECT_EQ(publish("fourth"), "") << "five people came";
}

TEST_F(SecondReleaseTest, OfTheSamePeopleIsAllowed) {
  takePart(12);
  EXPECT_EQ(publish("first"), "");
  EXPECT_EQ(publish("second"), "");
}

TEST_F(SecondReleaseTest, WithoutAFirstOneIsNotCompared) {
  takePart(13);  // control: as many as are refused after 12
  EXPECT_EQ(publish("first"), "");
}

TEST_F(SecondReleaseTest, OfPilotsSaysNothingOfLiveSessions) {
  takePart(5);
  for (int i = 0; i < 5; ++i) {
    auto session = Session::enrol(*study_, {.cohort = "surgeons", .runMode = RunMode::Pilot});
    tests::walkToTheEnd(session);
  }
  exportStudy(*study_, folder_ / "pilots", {.runMode = RunMode::Pilot, .publicClassSize = 5});
  takePart(1);
  EXPECT_EQ(publish("live"), "");
}

TEST_F(PublicExportTest, HasNewIdsAndANewOrderEachTime) {
  take(6);
  const auto first = analysis::readCsv(exported("first").at("participants.csv"));
  const auto second = analysis::readCsv(exported("second").at("participants.csv"));
  const auto ids = columnOf(first, "participant_id");
  const auto others = columnOf(second, "participant_id");
  EXPECT_EQ(std::set<std::string>(ids.begin(), ids.end()).size(), 6U);
  for (const auto& id : ids) EXPECT_EQ(std::count(others.begin(), others.end(), id), 0) << id;
  const auto one = analysis::readCsv(tests::contentOf(folder_ / "first/responses.csv"));
  const auto two = analysis::readCsv(tests::contentOf(folder_ / "second/responses.csv"));
  EXPECT_NE(columnOf(one, "item_id"), columnOf(two, "item_id"));
}

TEST_F(PublicExportTest, ReleasesOpinionsUnchanged) {
  take(6);
  const auto responses = analysis::readCsv(exported("out").at("responses.csv"));
  std::map<std::string, int> told;
  for (const auto& row : responses.rows) {
    const auto cell = [&](const char* name) { return row.cells[responses.columnIndex(name)]; };
    if (cell("item_type") == "likert")
      ++told[cell("condition_code") + " " + cell("item_id") + " " + cell("response")];
  }
  std::map<std::string, int> given;
  const auto codes = conditionCodes(*study_, RunMode::Simulated);
  for (const auto& answer : storage::Records(study_->database()).answers()) {
    const auto* point = std::get_if<std::int64_t>(&answer.answer.response);
    if (point == nullptr || answer.step.kind == StepKind::Benchmark) continue;
    const auto code = codes.find(answer.step.condition);
    ++given
        [(code == codes.end() ? "" : code->second) + " " + answer.answer.item + " " +
         std::to_string(*point)];
  }
  EXPECT_EQ(told, given);
  EXPECT_FALSE(told.empty());
}

TEST_F(PublicExportTest, NamesThePreferredRenderingByItsCode) {
  take(6);
  const auto responses = analysis::readCsv(exported("out").at("responses.csv"));
  int votes = 0;
  for (const auto& row : responses.rows) {
    if (row.cells[responses.columnIndex("item_id")] != "preferred") continue;
    ++votes;
    EXPECT_EQ(row.cells[responses.columnIndex("response")].front(), 'C');
  }
  EXPECT_GE(votes, 6);
}

TEST_F(PublicExportTest, NeedsAsManyPeopleAsAClass) {
  take(4);
  try {
    exported("out");
    FAIL() << "four people were told";
  } catch (const storage::StorageError& error) {
    const std::string words = error.what();
    EXPECT_NE(words.find("4 people have completed"), std::string::npos) << words;
    EXPECT_NE(words.find("Publish the report's tables"), std::string::npos) << words;
  }
  EXPECT_FALSE(fs::exists(folder_ / "out"));
}

TEST_F(PublicExportTest, HasNoSmallerClassesAndNoTraces) {
  take(6);
  EXPECT_THROW(exported("small", ExportFormat::Csv, 4), storage::StorageError);
  EXPECT_THROW(
      exportStudy(
          *study_,
          folder_ / "traces",
          {.runMode = RunMode::Simulated,
           .isBlinded = false,
           .hasTraces = true,
           .publicClassSize = kSmallestPublicClassSize},
          "for a test"),
      storage::StorageError);
}

TEST_F(PublicExportTest, IsWrittenIntoTheAuditTrail) {
  take(6);
  exported("out");
  const auto last = study_->events().read().rbegin()[1];  // before its signature
  EXPECT_EQ(last.name(), "public_export");
  EXPECT_EQ(storage::describe(last).substr(0, 15), "k = 5, 6 people");
}

TEST_F(PublicExportTest, ReportsTheSizesOfClasses) {
  take(12);
  const auto words = describe(publicRelease(
      *study_, {.runMode = RunMode::Simulated, .publicClassSize = kSmallestPublicClassSize}));
  EXPECT_NE(
      words.find("As answered: 12 of 12 people in classes of fewer than 5"), std::string::npos)
      << words;
  EXPECT_NE(words.find("background_arthroscopies: by it alone 5"), std::string::npos) << words;
  EXPECT_NE(words.find("As told: "), std::string::npos) << words;
}

TEST_F(PublicExportTest, ExplainsItsColumns) {
  take(8);
  const auto files = exported("out");
  const auto codebook = nlohmann::json::parse(files.at("codebook.json"));
  EXPECT_EQ(codebook["k"], 5);
  EXPECT_FALSE(codebook.contains("study_uuid"));
  const auto participants = analysis::readCsv(files.at("participants.csv"));
  const auto& columns = codebook["tables"]["participants"]["columns"];
  ASSERT_EQ(columns.size(), participants.columns.size());
  for (std::size_t i = 0; i < columns.size(); ++i) {
    std::set<std::string> levels{""};
    if (!columns[i].contains("levels")) continue;
    for (const auto& level : columns[i]["levels"]) levels.insert(level["value"]);
    for (const auto& cell : columnOf(participants, participants.columns[i])) {
      EXPECT_EQ(levels.count(cell), 1U) << participants.columns[i] << " " << cell;
    }
  }
}

}  // namespace public_export_test
}  // namespace study

// Exports of a study at several sites.
#include <filesystem>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "analysis/data/csv_table.h"
#include "study/cohort/simulated_participant.h"
#include "study/export/export.h"
#include "tests/study/made_study.h"
#include "tests/support/scratch_folder.h"

namespace study {
namespace sites_test {

namespace fs = std::filesystem;

class ExportedSites : public testing::Test {
 protected:
  /// Every @p period-th session was in Bergen, all others in Oslo.
  void take(int people, int period) {
    simulateCohorts(*study_, study_.clock, people, 3, [](const auto&) {});
    study_->database().execute(
        "UPDATE session SET site = CASE WHEN id % " + std::to_string(period) +
        " = 0 THEN 'bergen' ELSE 'oslo' END");
  }

  analysis::CsvTable exported(const std::string& file, ExportOptions options) {
    options.runMode = RunMode::Simulated;
    exportStudy(*study_, folder_ / "out", options, "to test");
    return analysis::readCsv(tests::contentOf(folder_ / "out/" + file));
  }

  /// How often each value is in a column; empty: there is no such column.
  static std::map<std::string, int> countsOf(
      const analysis::CsvTable& table, const std::string& column) {
    std::map<std::string, int> counts;
    const auto& names = table.columns;
    if (std::find(names.begin(), names.end(), column) == names.end()) return counts;
    for (const auto& row : table.rows) ++counts[row.cells[table.columnIndex(column)]];
    return counts;
  }

  tests::ScratchFolder folder_;
  /// Two trials a session: simulating them takes most of the time of these tests.
  static protocols::LoadedProtocol protocol() {
    return tests::protocolFrom(tests::shortProtocol(
        {.conditions = {"interpolation", "finite-elements"},
         .form = "background-knee",
         .hasPreference = false}));
  }

  tests::MadeStudy study_{protocol(), 1};
};

TEST_F(ExportedSites, AreAColumnOfEveryTableThatHasCohorts) {
  take(4, 2);
  for (const bool isBlinded : {true, false}) {
    for (const auto& table : exportTables(*study_, {.isBlinded = isBlinded})) {
      const auto has = [&](const char* name) {
        return std::any_of(table.columns.begin(), table.columns.end(), [&](const auto& column) {
          return column.name == name;
        });
      };
      EXPECT_EQ(has("site"), has("cohort")) << table.name;
    }
  }
  const auto sessions = exported("sessions.csv", {.format = ExportFormat::R});
  EXPECT_EQ(countsOf(sessions, "site"), (std::map<std::string, int>{{"bergen", 2}, {"oslo", 2}}));
  const auto columns = tests::contentOf(folder_ / "out/columns.csv");
  EXPECT_NE(columns.find("bergen"), std::string::npos) << columns;
}

TEST_F(ExportedSites, AreNoColumnWhereThereIsOne) {
  take(2, 100);
  for (const auto& table : exportTables(*study_, {.isBlinded = false})) {
    for (const auto& column : table.columns) EXPECT_NE(column.name, "site") << table.name;
  }
}

TEST_F(ExportedSites, AreInTheParticipantsOfBids) {
  take(2, 2);
  exportStudy(
      *study_, folder_ / "bids", {.format = ExportFormat::Bids, .runMode = RunMode::Simulated});
  const auto participants = tests::contentOf(folder_ / "bids/participants.tsv");
  EXPECT_TRUE(participants.starts_with("participant_id\tcohort\tsite\trun_mode\n")) << participants;
  EXPECT_NE(participants.find("\tbergen\t"), std::string::npos);
}

TEST_F(ExportedSites, OfStrangersAreToldWhereEnoughPeopleShareThem) {
  take(20, 2);
  const auto participants = exported("participants.csv", {.publicClass = 5});
  EXPECT_EQ(
      countsOf(participants, "site"), (std::map<std::string, int>{{"bergen", 10}, {"oslo", 10}}));
  std::map<std::vector<std::string>, int> classes;
  for (const auto& row : participants.rows) {
    ++classes[{row.cells.begin() + 1, row.cells.end()}];
  }
  for (const auto& [said, people] : classes) EXPECT_GE(people, 5);
}

/// Of two people at a site, each would be one of two.
TEST_F(ExportedSites, OfFewPeopleAreNotToldStrangers) {
  take(20, 8);
  const auto participants = exported("participants.csv", {.publicClass = 5});
  EXPECT_EQ(participants.rows.size(), 20U);
  EXPECT_EQ(countsOf(participants, "site").count("bergen"), 0U);
  const auto responses = analysis::readCsv(tests::contentOf(folder_ / "out/responses.csv"));
  EXPECT_GT(responses.rows.size(), 20U);
  EXPECT_EQ(countsOf(responses, "site").count("bergen"), 0U);
}

TEST_F(ExportedSites, OfOneStationAreInTheNamesOfPsychDs) {
  Study::create(
      folder_ / "oslo",
      protocol(),
      study_.clock,
      1,
      std::nullopt,
      {.site = "oslo", .label = "oslo-2", .uuid = "7"});
  auto study = Study::open(folder_ / "oslo", study_.clock);
  simulateCohorts(study, study_.clock, 2, 3, [](const auto&) {});
  exportStudy(
      study, folder_ / "ds", {.format = ExportFormat::PsychDs, .runMode = RunMode::Simulated});
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder_ / "ds/data")) {
    names.insert(entry.path().filename().string());
  }
  EXPECT_FALSE(names.empty());
  for (const auto& name : names) EXPECT_NE(name.find("_site-oslo_description-"), name.npos) << name;
}

}  // namespace sites_test
}  // namespace study

// Exports of a study at several sites.
#include <filesystem>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "analysis/data/csv_table.h"
#include "study/cohort/simulated_participant.h"
#include "study/export/export.h"
#include "study/export/export_parts.h"
#include "tests/study/made_study.h"
#include "tests/support/child_process.h"
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

  /// Two trials a session: simulating them takes most of the time of these tests.
  static protocols::LoadedProtocol protocol(bool hasPreference) {
    return tests::protocolFrom(tests::shortProtocol(
        {.conditions = {"interpolation", "finite-elements"},
         .form = "background-knee",
         .hasPreference = hasPreference}));
  }

  explicit ExportedSites(bool hasPreference = false) : study_(protocol(hasPreference), 1) {}

  tests::ScratchFolder folder_;
  tests::MadeStudy study_;
};

class VotesAtSites : public ExportedSites {
 protected:
  VotesAtSites() : ExportedSites(true) {}

  /// Expects that @p script of the exported folder finds the exported numbers again.
  void expectToComputeAgain(const std::string& program, const std::string& script) const {
    const auto out = folder_ / "out";
    const auto finished = tests::run({program, out + "/" + script, out});
    EXPECT_EQ(finished.status, 0) << finished.out << finished.error;
    EXPECT_NE(finished.out.find("votes share "), std::string::npos) << finished.out;
  }
};

TEST_F(VotesAtSites, AreCountedOfAllSitesAndOfEach) {
  take(6, 3);
  const auto votes = exported("votes.csv", {.isBlinded = false});
  std::map<std::string, int> bySite;
  std::map<std::string, int> total;
  for (const auto& row : votes.rows) {
    const auto cell = [&](const char* column) { return row.cells[votes.columnIndex(column)]; };
    bySite[cell("site")] += std::stoi(cell("votes"));
    if (cell("condition_code") == "C1") total[cell("site")] += std::stoi(cell("votes_total"));
  }
  const std::map<std::string, int> expected{{"", 6}, {"bergen", 2}, {"oslo", 4}};
  EXPECT_EQ(bySite, expected);
  EXPECT_EQ(total, expected);
}

TEST_F(VotesAtSites, AreComputedAgainInR) {
  if (!tests::isInstalled({"Rscript", "-e", "0"})) GTEST_SKIP() << "needs R: ./setup --check";
  take(6, 3);
  exported("votes.csv", {.isBlinded = false});
  expectToComputeAgain("Rscript", "analysis.R");
}

TEST_F(VotesAtSites, AreComputedAgainInPython) {
  const std::string python = "/usr/bin/python3";
  if (!tests::isInstalled({python, "-c", "import scipy"})) {
    GTEST_SKIP() << "needs SciPy: ./setup --check";
  }
  take(6, 3);
  exported("votes.csv", {.isBlinded = false});
  expectToComputeAgain(python, "analysis.py");
}

TEST_F(ExportedSites, AreAColumnOfEveryTableOfWhatHappened) {
  take(4, 2);
  for (const bool isBlinded : {true, false}) {
    const ExportOptions options{.runMode = RunMode::Simulated, .isBlinded = isBlinded};
    for (const auto& table : tablesFor(*study_, options)) {
      const auto has =
          std::any_of(table.columns.begin(), table.columns.end(), [](const auto& column) {
            return column.name == "site";
          });
      EXPECT_EQ(has, table.name != "items") << table.name;
    }
  }
  const auto sessions = exported("sessions.csv", {.format = ExportFormat::R});
  EXPECT_EQ(countsOf(sessions, "site"), (std::map<std::string, int>{{"bergen", 2}, {"oslo", 2}}));
  const auto columns = tests::contentOf(folder_ / "out/columns.csv");
  EXPECT_NE(columns.find("bergen"), std::string::npos) << columns;
}

TEST_F(ExportedSites, AreNoColumnWhereThereIsOne) {
  take(2, 100);
  const ExportOptions options{.runMode = RunMode::Simulated, .isBlinded = false};
  for (const auto& table : tablesFor(*study_, options)) {
    for (const auto& column : table.columns) {
      EXPECT_NE(column.name, "site") << table.name;
    }
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
  const auto participants = exported("participants.csv", {.publicClassSize = 5});
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
  const auto participants = exported("participants.csv", {.publicClassSize = 5});
  EXPECT_EQ(participants.rows.size(), 20U);
  EXPECT_EQ(countsOf(participants, "site").count("bergen"), 0U);
  const auto responses = analysis::readCsv(tests::contentOf(folder_ / "out/responses.csv"));
  EXPECT_GT(responses.rows.size(), 20U);
  EXPECT_EQ(countsOf(responses, "site").count("bergen"), 0U);
}

TEST_F(ExportedSites, OfOneStationAreInTheNamesOfPsychDs) {
  Study::create(
      folder_ / "oslo",
      protocol(false),
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

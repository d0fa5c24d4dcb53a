// The scripts of an export: where they can be started, and what they say at the end.
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "study/cohort/simulated_participant.h"
#include "study/export/export.h"
#include "tests/study/made_study.h"
#include "tests/support/child_process.h"
#include "tests/support/scratch_folder.h"

namespace study {
namespace scripts_test {

namespace fs = std::filesystem;

struct Language {
  std::string program;
  std::string ending;
  std::vector<std::string> needs;  ///< a command that succeeds where the script can run
};

void PrintTo(const Language& language, std::ostream* out) {
  *out << language.program;
}

class ExportScripts : public testing::TestWithParam<Language> {
 protected:
  void SetUp() override {
    if (!tests::isInstalled(GetParam().needs)) GTEST_SKIP() << "./setup --check says what to get";
  }

  static void SetUpTestSuite() {
    made = std::make_unique<tests::MadeStudy>(tests::libraryProtocol("punch-counterbalanced.json"));
    simulateCohorts(**made, made->clock, 6, 3, [](const auto&) {});
    small =
        std::make_unique<tests::MadeStudy>(tests::libraryProtocol("punch-counterbalanced.json"));
    simulateCohorts(**small, small->clock, 1, 3, [](const auto&) {});
  }
  static void TearDownTestSuite() {
    made.reset();
    small.reset();
  }

  /// An export in a folder whose name has a space.
  fs::path exported(ExportFormat format) const { return exported(**made, format); }
  fs::path exported(Study& study, ExportFormat format) const {
    const fs::path folder = scratch_ / "my data";
    exportStudy(
        study,
        folder.string(),
        {.format = format, .runMode = RunMode::Simulated, .isBlinded = false},
        "for a test");
    return folder;
  }

  /// Starts a script of the language by its path as it is written in @p folder.
  static tests::Finished runIn(const fs::path& folder, const std::string& script) {
    const auto command = "cd '" + folder.string() + "' && exec " + GetParam().program + " '" +
                         script + GetParam().ending + "'";
    return tests::run({"sh", "-c", command});
  }

  static std::string lastLineOf(const std::string& text) {
    const auto end = text.find_last_not_of('\n');
    const auto begin = text.rfind('\n', end);
    return text.substr(begin + 1, end - begin);
  }

  inline static std::unique_ptr<tests::MadeStudy> made;
  /// Of one person: R fits no models to it, which take most of its time.
  inline static std::unique_ptr<tests::MadeStudy> small;
  tests::ScratchFolder scratch_;
};

TEST_P(ExportScripts, OfCsvRunFromTheirFolderAndFromAnyOther) {
  const auto folder = exported(**small, ExportFormat::Csv);
  for (const auto& [from, script] :
       {std::pair(folder, std::string("analysis")),
        std::pair(folder.parent_path(), std::string("my data/analysis")),
        std::pair(fs::path("/"), (folder / "analysis").string())}) {
    const auto finished = runIn(from, script);
    EXPECT_EQ(finished.status, 0) << from << finished.out << finished.error;
  }
}

TEST_P(ExportScripts, OfPsychDsRunFromTheirFolderAndFromAnyOther) {
  const auto folder = exported(**small, ExportFormat::PsychDs);
  for (const auto& [from, script] :
       {std::pair(folder, std::string("analysis/analysis")),
        std::pair(folder / "analysis", std::string("analysis")),
        std::pair(fs::path("/"), (folder / "analysis" / "analysis").string())}) {
    const auto finished = runIn(from, script);
    EXPECT_EQ(finished.status, 0) << from << finished.out << finished.error;
  }
}

TEST_P(ExportScripts, ThatReadTablesFindThemFromAnyFolder) {
  const auto isR = GetParam().ending == ".R";
  const auto folder = exported(isR ? ExportFormat::R : ExportFormat::Python);
  const auto finished = runIn("/", (folder / "read_tables").string());
  EXPECT_EQ(finished.status, 0) << finished.error;
  EXPECT_NE(finished.out.find("responses : "), std::string::npos) << finished.out;
}

TEST_P(ExportScripts, NameATableThatIsMissing) {
  const auto folder = exported(ExportFormat::Csv);
  fs::remove(folder / "votes.csv");
  const auto finished = runIn(folder, "analysis");
  EXPECT_EQ(finished.status, 2) << finished.out << finished.error;
  EXPECT_NE(finished.error.find("the table 'votes' is not in"), std::string::npos)
      << finished.error;
  EXPECT_EQ(finished.error.find("Traceback"), std::string::npos) << finished.error;
}

TEST_P(ExportScripts, OfOnePersonEndWithAVerdictThatAgreesWithTheExitStatus) {
  const auto folder = exported(**small, ExportFormat::Csv);
  const auto agreed = runIn(folder, "analysis");
  EXPECT_EQ(agreed.status, 0) << agreed.out << agreed.error;
  EXPECT_TRUE(lastLineOf(agreed.out).starts_with("AGREE: all ")) << lastLineOf(agreed.out);
  auto votes = tests::contentOf(folder / "votes.csv");
  const std::string level = ",0.95,";
  const auto share = votes.rfind(',', votes.find(level) - 1) + 1;
  votes.replace(share, votes.find(level) - share, "0.123");
  std::ofstream(folder / "votes.csv") << votes;
  const auto differs = runIn(folder, "analysis");
  EXPECT_EQ(differs.status, 1);
  EXPECT_TRUE(lastLineOf(differs.out).starts_with("DIFFER: 1 of ")) << lastLineOf(differs.out);
  EXPECT_NE(lastLineOf(differs.out).find("votes share"), std::string::npos);
}

TEST_P(ExportScripts, AgreeWhereAFamilyComparesSomeOfTheConditions) {
  tests::MadeStudy study;  // three conditions, two of which are compared
  simulateCohorts(*study, study.clock, 6, 3, [](const auto&) {});
  const auto finished = runIn(exported(*study, ExportFormat::Csv), "analysis");
  EXPECT_EQ(finished.status, 0) << finished.out << finished.error;
}

TEST_P(ExportScripts, OfPsychDsAgree) {
  const auto finished = runIn(exported(ExportFormat::PsychDs) / "analysis", "analysis");
  EXPECT_EQ(finished.status, 0) << finished.out << finished.error;
}

// Two suites, which can run side by side.
INSTANTIATE_TEST_SUITE_P(
    InR, ExportScripts, testing::Values(Language{"Rscript", ".R", {"Rscript", "-e", "0"}}));
INSTANTIATE_TEST_SUITE_P(
    InPython,
    ExportScripts,
    testing::Values(Language{
        "/usr/bin/python3", ".py", {"/usr/bin/python3", "-c", "import scipy"}}));

}  // namespace scripts_test
}  // namespace study

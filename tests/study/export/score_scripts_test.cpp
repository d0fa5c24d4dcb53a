// The scripts of an export on a study whose family compares a score.
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "study/cohort/simulated_participant.h"
#include "study/export/export.h"
#include "tests/study/made_study.h"
#include "tests/support/child_process.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_data.h"

namespace study {
namespace score_scripts_test {

namespace fs = std::filesystem;

class ScoreScripts : public testing::Test {
 protected:
  ScoreScripts() {
    simulateCohorts(*study_, study_.clock, 6, 3, [](const auto&) {});
    exportStudy(
        *study_,
        folder_.string(),
        {.format = ExportFormat::Csv, .runMode = RunMode::Simulated, .isBlinded = false},
        "for a test");
  }

  static protocols::LoadedProtocol protocol() {
    auto json = tests::libraryProtocol("punch-counterbalanced.json").text;
    const std::string instrument = R"("instrument": "realism-common",)";
    json.insert(json.find(instrument, json.find("\"families\"")), R"("score": "realism", )");
    return tests::protocolFrom(json);
  }

  /// Expects that a script finds the exported numbers again, and no more after a score has changed.
  void expectToComputeAgain(const std::string& program, const std::string& script) const {
    const auto file = (folder_ / script).string();
    const auto finished = tests::run({program, file, folder_.string()});
    EXPECT_EQ(finished.status, 0) << finished.out << finished.error;
    EXPECT_NE(finished.out.find("paired_t p_adj"), std::string::npos) << finished.out;
    auto wide = tests::contentOf(folder_ / "wide.csv");
    const auto end = wide.find('\n', wide.find('\n') + 1);
    wide.replace(wide.rfind(',', end) + 1, 1, "9");
    std::ofstream(folder_ / "wide.csv") << wide;
    EXPECT_EQ(tests::run({program, file, folder_.string()}).status, 1);
  }

  tests::ScratchFolder scratch_;
  fs::path folder_ = scratch_ / "out";
  tests::MadeStudy study_{protocol()};
};

TEST_F(ScoreScripts, ComputeItsTestsAgainInR) {
  if (!tests::isInstalled({"Rscript", "-e", "0"})) GTEST_SKIP() << "needs R: ./setup --check";
  expectToComputeAgain("Rscript", "analysis.R");
}

TEST_F(ScoreScripts, ComputeItsTestsAgainInPython) {
  const std::string python = "/usr/bin/python3";
  if (!tests::isInstalled({python, "-c", "import scipy"}))
    GTEST_SKIP() << "needs SciPy: ./setup --check";
  expectToComputeAgain(python, "analysis.py");
}

}  // namespace score_scripts_test
}  // namespace study

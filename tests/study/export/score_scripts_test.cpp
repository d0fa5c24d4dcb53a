// The scripts of an export on studies whose families compare a score, or some of the items.
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "study/cohort/simulated_participant.h"
#include "study/export/export.h"
#include "tests/study/everything_instrument.h"
#include "tests/study/made_study.h"
#include "tests/support/child_process.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_data.h"

namespace study {
namespace score_scripts_test {

namespace fs = std::filesystem;

/// The counterbalanced protocol with @p instrument in both blocks; its family has also the keys
/// @p what.
std::string familyOf(const std::string& instrument, const std::string& what) {
  auto json = tests::libraryProtocol("punch-counterbalanced.json").text;
  const std::string library = "realism-common";
  const std::string asked = "\"instrument\": \"" + library + "\",";
  json.insert(json.find(asked, json.find("\"families\"")), what);
  if (instrument == library) return json;
  for (auto at = json.find(library); at != std::string::npos; at = json.find(library)) {
    json.replace(at, library.size(), instrument);
  }
  return json;
}

class ComputedAgain : public testing::Test {
 protected:
  explicit ComputedAgain(const protocols::LoadedProtocol& protocol) : study_(protocol) {
    simulateCohorts(*study_, study_.clock, 6, 3, [](const auto&) {});
    exportStudy(
        *study_,
        folder_.string(),
        {.format = ExportFormat::Csv, .runMode = RunMode::Simulated, .isBlinded = false},
        "for a test");
  }

  /// Expects that a script finds the exported numbers again.
  void expectAgreement(const std::string& program, const std::string& script) const {
    const auto finished = run(program, script);
    EXPECT_EQ(finished.status, 0) << finished.out << finished.error;
    EXPECT_NE(finished.out.find("paired_t p_adj"), std::string::npos) << finished.out;
  }

  tests::Finished run(const std::string& program, const std::string& script) const {
    return tests::run({program, (folder_ / script).string(), folder_.string()});
  }

  static bool hasR() { return tests::isInstalled({"Rscript", "-e", "0"}); }
  static bool hasSciPy() { return tests::isInstalled({kPython, "-c", "import scipy"}); }

  inline static const std::string kPython = "/usr/bin/python3";
  tests::ScratchFolder scratch_;
  fs::path folder_ = scratch_ / "out";
  tests::MadeStudy study_;
};

class ScoreScripts : public ComputedAgain {
 protected:
  ScoreScripts()
      : ComputedAgain(tests::protocolFrom(familyOf("realism-common", R"("score": "realism", )"))) {}

  /// Expects that a script finds the exported numbers again, and no more after a score has changed.
  void expectToReadScores(const std::string& program, const std::string& script) const {
    expectAgreement(program, script);
    auto wide = tests::contentOf(folder_ / "wide.csv");
    const auto end = wide.find('\n', wide.find('\n') + 1);
    wide.replace(wide.rfind(',', end) + 1, 1, "9");
    std::ofstream(folder_ / "wide.csv") << wide;
    EXPECT_EQ(run(program, script).status, 1);
  }
};

TEST_F(ScoreScripts, ComputeItsTestsAgainInR) {
  if (!hasR()) GTEST_SKIP() << "needs R: ./setup --check";
  expectToReadScores("Rscript", "analysis.R");
}

TEST_F(ScoreScripts, ComputeItsTestsAgainInPython) {
  if (!hasSciPy()) GTEST_SKIP() << "needs SciPy: ./setup --check";
  expectToReadScores(kPython, "analysis.py");
}

/// One round of answers to a reversed slider, which no other item of the questionnaire joins.
class ItemScripts : public ComputedAgain {
 protected:
  ItemScripts() : ComputedAgain(protocol()) {}

  static protocols::LoadedProtocol protocol() {
    auto questions = tests::everythingInstrument();
    const std::string naming = "\"identifying\": true";
    questions.replace(questions.find(naming), naming.size(), "\"required\": false");
    auto json = familyOf("everything", R"("items": ["slide"], "blocks": ["seen"], )");
    json.insert(json.find("\"conditions\""), R"("instrument_files": ["everything.json"], )");
    return tests::protocolFrom(json, {{.name = "everything.json", .text = questions}});
  }
};

TEST_F(ItemScripts, ComputeItsTestsAgainInR) {
  if (!hasR()) GTEST_SKIP() << "needs R: ./setup --check";
  expectAgreement("Rscript", "analysis.R");
}

TEST_F(ItemScripts, ComputeItsTestsAgainInPython) {
  if (!hasSciPy()) GTEST_SKIP() << "needs SciPy: ./setup --check";
  expectAgreement(kPython, "analysis.py");
}

}  // namespace score_scripts_test
}  // namespace study

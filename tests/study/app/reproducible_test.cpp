// The same seed gives the same bytes for every user, folder and language. Blinded exports reveal no
// condition.
#include <filesystem>
#include <map>

#include <gtest/gtest.h>

#include "protocols/load_protocol.h"
#include "tests/study/made_study.h"
#include "tests/support/child_process.h"
#include "tests/support/programs.h"

namespace reproducible_test {

namespace fs = std::filesystem;

/// Every file under a folder, by name.
std::map<std::string, std::string> contentsOf(const std::string& folder) {
  std::map<std::string, std::string> contents;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    contents[fs::relative(entry.path(), folder).string()] = tests::contentOf(entry.path());
  }
  return contents;
}

class ReproducibleTest : public testing::Test {
 protected:
  /// Makes a study, simulates it, exports it.
  std::map<std::string, std::string> exported(
      const std::string& name,
      const std::string& seed,
      const std::string& format,
      const std::vector<std::string>& environment = {}) {
    const std::string study = folder_ / name;
    const std::string out = folder_ / (name + "-export");
    run({"study", "create", study, "--protocol", "punch-counterbalanced", "--seed", seed},
        environment);
    run({"study", "simulate", study, "--participants", "4"}, environment);
    run({"export", study, "--run-mode", "simulated", "--format", format, "--out", out},
        environment);
    return contentsOf(out);
  }

  static void run(std::vector<std::string> call, const std::vector<std::string>& environment) {
    call.insert(call.begin(), tests::program());
    const auto finished = tests::run(call, environment);
    ASSERT_EQ(finished.status, 0) << finished.error;
  }

  tests::ScratchFolder folder_;
};

TEST_F(ReproducibleTest, GivesTheSameBytesForTheSameSeed) {
  for (const std::string format : {"csv", "json"}) {
    const auto here = exported("here-" + format, "42", format);
    ASSERT_FALSE(here.empty());
    const auto there = exported(
        "there-" + format,
        "42",
        format,
        {"TZ=Asia/Kathmandu", "LC_ALL=C.utf8", "LANG=de_DE.UTF-8"});
    EXPECT_EQ(here, there);
    EXPECT_NE(here, exported("other-" + format, "43", format));
  }
}

TEST_F(ReproducibleTest, RevealsNoConditionInABlindedExport) {
  const auto protocol = tests::libraryProtocol("punch-counterbalanced.json").protocol;
  ASSERT_FALSE(protocol.conditions.empty());
  for (const std::string format : {"csv", "json"}) {
    for (const auto& [name, content] : exported("blinded-" + format, "42", format)) {
      for (const auto& condition : protocol.conditions) {
        EXPECT_EQ(content.find(condition.id), std::string::npos) << name << ": " << condition.id;
        for (const auto* title : {"Interpolation", "FEM", "Kalman"}) {
          EXPECT_EQ(content.find(title), std::string::npos) << name << ": " << title;
        }
      }
    }
  }
}

TEST_F(ReproducibleTest, RevealsConditionsOnRequestAndRecordsIt) {
  exported("study", "42", "csv");
  const std::string study = folder_ / "study";
  const std::string out = folder_ / "unblinded";
  std::vector<std::string> call{
      tests::program(), "export", study, "--run-mode", "simulated", "--out", out, "--unblind"};
  EXPECT_EQ(tests::run(call).status, 2);  // a reason is needed
  call.insert(call.end(), {"--reason", "the analysis is written"});
  ASSERT_EQ(tests::run(call).status, 0);
  EXPECT_NE(contentsOf(out).at("responses.csv").find("kalman"), std::string::npos);
  study::SimulatedClock clock;
  auto opened = study::Study::open(study, clock);
  const auto last = opened.events().read().rbegin()[1];  // before its signature
  EXPECT_EQ(last.name(), "unblinded_export");
  EXPECT_EQ(last.detail, "the analysis is written");
}

}  // namespace reproducible_test

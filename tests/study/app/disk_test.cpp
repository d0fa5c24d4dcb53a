// A disk that is full or read-only.
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "tests/study/app/simulation.h"
#include "tests/study/made_study.h"
#include "tests/support/child_process.h"
#include "tests/support/programs.h"

namespace study {
namespace disk_test {

namespace fs = std::filesystem;

std::string asShell(const std::vector<std::string>& call) {
  std::string text;
  for (const auto& word : call) text += "'" + word + "' ";
  return text;
}

class DiskTest : public testing::Test {
 protected:
  void SetUp() override {
    study_.close();
    fs::create_directory(disk_);
    if (onItsOwn("mount -t tmpfs none '" + disk_ + "'").status != 0) {
      GTEST_SKIP() << "no disk can be mounted here";
    }
  }

  /// Runs @p script in its own namespace, in which it may mount disks.
  static tests::Finished onItsOwn(const std::string& script) {
    return tests::run({"unshare", geteuid() == 0 ? "-m" : "-rm", "sh", "-c", script});
  }

  tests::Finished onASmallDisk(const std::string& size, const std::string& script) const {
    return onItsOwn("mount -t tmpfs -o size=" + size + " none '" + disk_ + "' && " + script);
  }

  tests::Finished onAReadOnlyDisk(const std::vector<std::string>& command) const {
    std::vector<std::string> call{tests::releaseProgram()};
    call.insert(call.end(), command.begin(), command.end());
    return onItsOwn(
        "mount --bind '" + study_.folder() + "' '" + disk_ + "' && mount -o remount,ro,bind '" +
        disk_ + "' && " + asShell(call));
  }

  void simulateOne() { ASSERT_EQ(tests::run(tests::simulation(study_.folder(), 1)).status, 0); }

  tests::MadeStudy study_;
  std::string disk_ = study_.scratch() / "disk";
};

class FullDiskTest : public DiskTest, public testing::WithParamInterface<const char*> {};

TEST_P(FullDiskTest, LosesNoAcknowledgedAnswerAndContinuesWhenThereIsSpaceAgain) {
  const std::string after = study_.scratch() / "after";
  const auto finished = onASmallDisk(
      GetParam(),
      "cp -r '" + study_.folder() + "' '" + disk_ + "/study'; " +
          asShell(tests::simulation(disk_ + "/study", 500)) + "; status=$?; cp -r '" + disk_ +
          "/study' '" + after + "'; exit $status");
  EXPECT_EQ(finished.status, 1);
  EXPECT_NE(finished.error.find("the disk is full. Free some space"), std::string::npos)
      << finished.error;
  const auto acknowledged = tests::acknowledgedIn(finished.out);
  EXPECT_GE(std::count_if(acknowledged.begin(), acknowledged.end(), tests::isAnswer), 20);
  EXPECT_EQ(tests::whatIsLost(after, acknowledged), "");
  EXPECT_LE(tests::keptBeyond(after, acknowledged), 1U);
  ASSERT_EQ(tests::run(tests::simulation(after, 1)).status, 0);
  EXPECT_EQ(tests::whatIsLost(after, acknowledged), "");
}

INSTANTIATE_TEST_SUITE_P(
    Of, FullDiskTest, testing::Values("4600k", "4900k", "5m", "5500k"), [](const auto& size) {
      return std::string(size.param);
    });

TEST_F(DiskTest, ThatIsFullHoldsNoUnfinishedExport) {
  simulateOne();
  const auto exported = [&](const std::string& size) {
    return onASmallDisk(
        size,
        asShell(
            {tests::releaseProgram(),
             "export",
             study_.folder(),
             "--run-mode",
             "simulated",
             "--out",
             disk_ + "/out"}) +
            "; status=$?; ls -A '" + disk_ + "' >&2; exit $status");
  };
  const auto refused = exported("8k");
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(refused.error.find("the room on the disk"), std::string::npos) << refused.error;
  EXPECT_EQ(refused.error.substr(refused.error.size() - 2), ".\n") << "something was left there";
  const auto done = exported("1m");
  EXPECT_EQ(done.status, 0);
  EXPECT_EQ(done.error, "out\n");
}

TEST_F(DiskTest, ThatIsReadOnlyAllowsToVerifyAndExport) {
  simulateOne();
  const std::string out = study_.scratch() / "out";
  EXPECT_EQ(onAReadOnlyDisk({"study", "verify", disk_}).status, 0);
  EXPECT_EQ(onAReadOnlyDisk({"study", "status", disk_}).status, 0);
  EXPECT_EQ(onAReadOnlyDisk({"export", disk_, "--run-mode", "simulated", "--out", out}).status, 0);
  EXPECT_TRUE(fs::exists(out));
}

TEST_F(DiskTest, ThatIsReadOnlyIsRefusedBeforeASession) {
  const auto refused = onAReadOnlyDisk({"study", "simulate", disk_, "--verbose"});
  EXPECT_EQ(refused.status, 1);
  EXPECT_EQ(refused.out, "");
  EXPECT_NE(refused.error.find("may not be written"), std::string::npos) << refused.error;
  const auto unmade =
      onAReadOnlyDisk({"study", "create", disk_ + "/new", "--protocol", "punch-face-validity"});
  EXPECT_EQ(unmade.status, 1);
  EXPECT_NE(unmade.error.find("cannot be made"), std::string::npos) << unmade.error;
}

}  // namespace disk_test
}  // namespace study

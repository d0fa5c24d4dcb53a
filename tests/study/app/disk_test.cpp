// What happens when the disk has no room: reliability.md, F4.
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "tests/study/app/simulation.h"
#include "tests/study/made_study.h"
#include "tests/support/child_process.h"

namespace study {
namespace {

/// Runs @p script where a disk of five megabytes can be mounted that nobody else sees.
tests::Finished onASmallDisk(const std::string& folder, const std::string& script) {
  const std::string mount = "mount -t tmpfs -o size=5m none '" + folder + "' || exit 99; ";
  const std::string separate = geteuid() == 0 ? "-m" : "-rm";
  return tests::run({"unshare", separate, "sh", "-c", mount + script});
}

std::string asShell(const std::vector<std::string>& call) {
  std::string text;
  for (const auto& word : call) text += "'" + word + "' ";
  return text;
}

TEST(Disk, MayBeFullAndLosesNothingThatWasAcknowledged) {
  tests::MadeStudy study;
  study.close();
  const std::string disk = study.scratch() / "disk";
  const std::string after = study.scratch() / "after";
  std::filesystem::create_directory(disk);
  const auto finished = onASmallDisk(
      disk,
      "cp -r '" + study.folder() + "' '" + disk + "/study'; " +
          asShell(tests::simulation(disk + "/study", 500)) + "; status=$?; cp -r '" + disk +
          "/study' '" + after + "'; exit $status");
  if (finished.status == 99 || finished.status == 127) {
    GTEST_SKIP() << "no small disk can be mounted here";
  }
  EXPECT_EQ(finished.status, 1);
  EXPECT_NE(finished.error.find("full"), std::string::npos) << finished.error;
  const auto acknowledged = tests::acknowledgedIn(finished.out);
  EXPECT_GE(std::count_if(acknowledged.begin(), acknowledged.end(), tests::isAnswer), 20);
  EXPECT_EQ(tests::whatIsLost(after, acknowledged), "");
  EXPECT_LE(tests::keptBeyond(after, acknowledged), 1U);
}

}  // namespace
}  // namespace study

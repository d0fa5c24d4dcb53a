// What the disk has when the program says "saved", and what happens when it has no room.
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "study/storage/records.h"
#include "study/verification.h"
#include "tests/study/made_study.h"
#include "tests/support/child_process.h"

namespace study {
namespace {

namespace fs = std::filesystem;

class DiskTest : public testing::Test {
 protected:
  void SetUp() override { study_.close(); }

  std::vector<std::string> simulation(const std::string& folder, const std::string& participants) {
    return {
        PALPATE_PROGRAM, "study", "simulate", folder, "--participants", participants, "--verbose"};
  }

  tests::MadeStudy study_;
};

/// What strace saw of a program that writes into a study: in order, what matters.
struct Seen {
  int acknowledgements = 0;
  int tooEarly = 0;  ///< something was in the log, not on the disk, when it was acknowledged
};

Seen readTrace(const std::string& file) {
  Seen seen;
  bool isUnsynced = false;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    const bool isLog = line.find("study.db-wal>") != std::string::npos;
    if (isLog && line.find("pwrite64(") != std::string::npos) isUnsynced = true;
    const bool isSync =
        line.find("fdatasync(") != std::string::npos || line.find("fsync(") != std::string::npos;
    if (isLog && isSync) isUnsynced = false;
    if (line.find("write(1<") == std::string::npos) continue;
    if (line.find("\"saved ") == std::string::npos) continue;
    ++seen.acknowledgements;
    seen.tooEarly += isUnsynced ? 1 : 0;
  }
  return seen;
}

TEST_F(DiskTest, HasEveryAnswerBeforeItIsAcknowledged) {
  const std::string trace = study_.scratch() / "trace";
  std::vector<std::string> call{
      "strace", "-f", "-y", "-e", "trace=write,pwrite64,fsync,fdatasync", "-o", trace};
  const auto simulate = simulation(study_.folder(), "1");
  call.insert(call.end(), simulate.begin(), simulate.end());
  tests::Finished finished;
  try {
    finished = tests::run(call);
  } catch (const std::runtime_error&) {
    GTEST_SKIP() << "strace is not installed";
  }
  if (finished.status != 0) GTEST_SKIP() << "strace may not look here: " << finished.error;
  const auto seen = readTrace(trace);
  EXPECT_GE(seen.acknowledgements, 30);
  EXPECT_EQ(seen.tooEarly, 0);
}

TEST_F(DiskTest, WouldNoticeAnAcknowledgementThatComesTooEarly) {
  const auto trace = study_.scratch().write(
      "made-up",
      "1 pwrite64(3</s/study.db-wal>, \"\", 4096, 0) = 4096\n"
      "1 write(1</dev/pts/0>, \"saved P001 consent/ consent\\n\", 27) = 27\n"
      "1 fdatasync(3</s/study.db-wal>) = 0\n");
  EXPECT_EQ(readTrace(trace).tooEarly, 1);
}

/// Runs @p script where a disk of five megabytes can be mounted that nobody else sees.
tests::Finished onASmallDisk(const std::string& folder, const std::string& script) {
  const std::string mount = "mount -t tmpfs -o size=5m none '" + folder + "' || exit 99; ";
  const std::string separate = geteuid() == 0 ? "-m" : "-rm";
  return tests::run({"unshare", separate, "sh", "-c", mount + script});
}

TEST_F(DiskTest, MayBeFullAndLosesNothingThatWasAcknowledged) {
  const std::string disk = study_.scratch() / "disk";
  const std::string after = study_.scratch() / "after";
  fs::create_directory(disk);
  const std::string program = PALPATE_PROGRAM;
  const auto finished = onASmallDisk(
      disk,
      "cp -r '" + study_.folder() + "' '" + disk + "/study' && '" + program + "' study simulate '" +
          disk + "/study' --participants 500 --verbose; status=$?; cp -r '" + disk + "/study' '" +
          after + "'; exit $status");
  if (finished.status == 99 || finished.status == 127) {
    GTEST_SKIP() << "no small disk can be mounted here";
  }
  EXPECT_EQ(finished.status, 1);
  EXPECT_NE(finished.error.find("full"), std::string::npos) << finished.error;

  SimulatedClock clock;
  auto study = Study::open(after, clock);
  const auto result = verify(study);
  for (const auto& check : result.checks) EXPECT_TRUE(check.problems.empty()) << check.what;
  std::size_t answers = 0;
  std::istringstream lines(finished.out);
  for (std::string line; std::getline(lines, line);) {
    const bool isAnswer = line.find('/') != std::string::npos;
    const bool isIdentifying = line.find(" signature") != std::string::npos;
    answers += isAnswer && !isIdentifying ? 1 : 0;
  }
  const auto kept = storage::Records(study.database()).answers().size();
  EXPECT_GE(answers, 20U);
  EXPECT_GE(kept, answers);
  EXPECT_LE(kept, answers + 1);
}

}  // namespace
}  // namespace study

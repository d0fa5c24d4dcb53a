// The program is killed while it creates, converts or exports a study: unfinished results never
// pass for finished ones.
#include <filesystem>
#include <iostream>

#include <gtest/gtest.h>

#include "study/session/verification.h"
#include "study/storage/records.h"
#include "study/storage/study_schema.h"
#include "tests/study/made_study.h"
#include "tests/study/storage/sql.h"
#include "tests/support/child_process.h"
#include "tests/support/long_form.h"
#include "tests/support/programs.h"
#include "tests/support/test_data.h"

namespace study {
namespace kill_in_between_test {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

class KilledInBetweenTest : public testing::Test {
 protected:
  static constexpr int kKilled = -9;

  void SetUp() override {
    const auto tried = tests::run({"strace", "-o", folder_ / "tried", "true"});
    if (tried.status != 0) GTEST_SKIP() << "strace is missing or not permitted: " << tried.error;
  }

  static tests::Finished palpate(const Words& command) {
    Words call{tests::releaseProgram()};
    call.insert(call.end(), command.begin(), command.end());
    return tests::run(call);
  }

  /// Kills the program at every call that changes a file, each time in a fresh folder. The short
  /// form tries the first three calls of a kind, then every fifth. Returns how often it was killed.
  static int killEverywhere(
      const Words& command,
      const std::function<void()>& prepare,
      const std::function<void()>& look,
      int most = 100) {
    int points = 0;
    for (const std::string call :
         {"pwrite64",
          "write",
          "ftruncate",
          "fallocate",
          "fsync",
          "fdatasync",
          "unlink",
          "rename",
          "mkdir"}) {
      bool isKilled = true;
      for (int n = 1; isKilled && n <= most; n += n < 3 ? 1 : tests::inLongForm(1, 5)) {
        SCOPED_TRACE(call + " " + std::to_string(n));
        prepare();
        isKilled = isKilledAt(call, n, command);
        points += isKilled ? 1 : 0;
        look();
        if (HasFailure()) return points;
      }
    }
    return points;
  }

  static bool isKilledAt(const std::string& name, int n, const Words& command) {
    const std::string what = name + ":signal=KILL:when=" + std::to_string(n);
    Words call{"strace", "-o", "/dev/null", "-e", "inject=" + what, tests::releaseProgram()};
    call.insert(call.end(), command.begin(), command.end());
    const auto finished = tests::run(call, {"ASAN_OPTIONS=detect_leaks=0"});
    EXPECT_TRUE(finished.status == kKilled || finished.status == 0) << finished.error;
    return finished.status == kKilled;
  }

  /// Whether the study is complete and verifies; an unfinished one must be refused in words.
  static bool isThere(const std::string& folder) {
    SimulatedClock clock;
    try {
      auto study = Study::open(folder, clock);
      EXPECT_TRUE(verify(study).isSound());
      EXPECT_EQ(study.protocols().all().size(), 1U);
      return true;
    } catch (const storage::StorageError& error) {
      EXPECT_GT(std::string(error.what()).size(), 40U);
      return false;
    }
  }

  tests::ScratchFolder folder_;
};

TEST_F(KilledInBetweenTest, HasCreatedACompleteStudyOrNoneThatOpens) {
  const std::string made = folder_ / "study";
  int whole = 0;
  const int points = killEverywhere(
      {"study", "create", made, "--protocol", "punch-face-validity"},
      [&] { fs::remove_all(made); },
      [&] { whole += isThere(made) ? 1 : 0; });
  std::cout << points << " points; " << whole << " times with a whole study\n";
  EXPECT_GE(points, tests::inLongForm(80, 16));
  EXPECT_GT(whole, 5);  // each kind of call was also tried until the program finished
  EXPECT_LT(whole, points / tests::inLongForm(2, 1));
}

TEST_F(KilledInBetweenTest, LosesNoDataOfAnOlderFormat) {
  const std::string old = folder_ / "old";
  const std::string copy = folder_ / "copy";
  fs::create_directory(old);
  tests::Sql study(old + "/study.db");
  study.run(
      tests::contentOf((tests::repository() / "tests/study/data/study-format-1.sql").string()));
  study.run("PRAGMA application_id = 0x50616c53; PRAGMA user_version = 1");
  storage::Database::create(old + "/traces.db", storage::traceSchema());
  const auto identities = storage::identitySchema();
  storage::Database::create(
      old + "/identity.db", {identities.applicationId, identities.name, identities.steps.first(1)});
  constexpr int kMost = 40;  // later calls belong to sessions, which another test kills
  const int points = killEverywhere(
      {"study", "simulate", copy, "--participants", "1"},
      [&] {
        fs::remove_all(copy);
        tests::forgetWhatWasSigned();
        fs::copy(old, copy, fs::copy_options::recursive);
      },
      [&] {
        ASSERT_TRUE(isThere(copy));
        SimulatedClock clock;
        auto present = Study::open(copy, clock);
        EXPECT_GE(storage::Records(present.database()).answers().size(), 2U);
      },
      kMost);
  std::cout << points << " points\n";
  EXPECT_GE(points, kMost / tests::inLongForm(1, 5));
}

TEST_F(KilledInBetweenTest, LeavesNoUnfinishedExportUnderItsName) {
  const std::string made = folder_ / "study";
  const std::string out = folder_ / "out";
  ASSERT_EQ(palpate({"study", "create", made, "--protocol", "punch-face-validity"}).status, 0);
  ASSERT_EQ(palpate({"study", "simulate", made, "--participants", "1"}).status, 0);
  const auto files = [](const std::string& folder) {
    return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
  };
  const Words exported{"export", made, "--run-mode", "simulated", "--out"};
  Words first = exported;
  first.push_back(folder_ / "first");
  ASSERT_EQ(palpate(first).status, 0);
  const auto all = files(folder_ / "first");
  Words again = exported;
  again.push_back(out);
  const int points = killEverywhere(
      again,
      [&] { fs::remove_all(out); },
      [&] { EXPECT_EQ(fs::exists(out) ? files(out) : all, all); });
  std::cout << points << " points\n";
  EXPECT_GE(points, tests::inLongForm(15, 5));
}

TEST_F(KilledInBetweenTest, LeavesNoUnfinishedBackupUnderItsNameOrForOthers) {
  const std::string made = folder_ / "study";
  const std::string out = folder_ / "out";
  ASSERT_EQ(palpate({"study", "create", made, "--protocol", "punch-face-validity"}).status, 0);
  ASSERT_EQ(palpate({"study", "simulate", made, "--participants", "1"}).status, 0);
  // As release 0.1 made them: everybody on the computer may read.
  constexpr auto kForAll = fs::perms(0755);
  fs::permissions(made, kForAll);
  for (const auto& entry : fs::directory_iterator(made)) fs::permissions(entry.path(), kForAll);
  int unfinished = 0;
  const int points = killEverywhere(
      {"study", "backup", made, "--out", out},
      [&] {
        for (const auto& entry : fs::directory_iterator(folder_.path())) {
          if (entry.path().filename().string().starts_with("out")) fs::remove_all(entry.path());
        }
      },
      [&] {
        if (fs::exists(out)) {
          SimulatedClock clock;
          auto copy = Study::open(out, clock, storage::Database::Access::ReadOnly);
          EXPECT_TRUE(verify(copy, {}, {.isOlderCopy = true}).isSound());
        }
        for (const auto& entry : fs::directory_iterator(folder_.path())) {
          if (!entry.path().filename().string().starts_with("out.")) continue;
          ++unfinished;
          EXPECT_EQ(entry.status().permissions(), fs::perms::owner_all);
        }
      });
  std::cout << points << " points; " << unfinished << " times something unfinished\n";
  EXPECT_GE(points, tests::inLongForm(20, 5));
  EXPECT_GT(unfinished, 0) << "control";
}

}  // namespace kill_in_between_test
}  // namespace study

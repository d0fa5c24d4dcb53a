// A disk that is full or read-only.
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "study/session/unblinding.h"
#include "study/session/verification.h"
#include "tests/study/app/simulation.h"
#include "tests/study/made_study.h"
#include "tests/study/walk.h"
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

/// What a folder takes on a disk [KiB]. Of each file, whole blocks.
std::uintmax_t kibibytesOf(const fs::path& folder) {
  constexpr std::uintmax_t kBlock = 4096;
  std::uintmax_t blocks = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) blocks += (entry.file_size() + kBlock - 1) / kBlock;
  }
  return blocks * kBlock / 1024;
}

/// The parameter: how much larger than the new study the disk is [KiB]. The opened databases need
/// shared memory and logs besides.
class FullDiskTest : public DiskTest, public testing::WithParamInterface<unsigned> {};

TEST_P(FullDiskTest, LosesNoAcknowledgedAnswerAndContinuesWhenThereIsSpaceAgain) {
  const std::string after = study_.scratch() / "after";
  const auto finished = onASmallDisk(
      std::to_string(kibibytesOf(study_.folder()) + GetParam()) + "k",
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
    By, FullDiskTest, testing::Values(320U, 620U, 840U, 1220U), [](const auto& size) {
      return std::to_string(size.param) + "KiB";
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

/// A study on a disk without any free space, and a command on it.
class NoSpaceTest : public DiskTest {
 protected:
  void SetUp() override {
    DiskTest::SetUp();
    if (!IsSkipped()) simulateOne();
  }

  tests::Finished withoutSpace(
      const std::string& before,
      const std::vector<std::string>& command,
      const std::string& after = {}) {
    std::vector<std::string> call{tests::program()};
    call.insert(call.end(), command.begin(), command.end());
    return onASmallDisk(
        "16m",
        "cp -r '" + study_.folder() + "' '" + disk_ + "/study'; " + before + " cat /dev/zero > '" +
            disk_ + "/zeros' 2> /dev/null; if echo x > '" + disk_ +
            "/one-more' 2> /dev/null; then exit 99; fi; " + asShell(call) + after);
  }

  /// Commands that read a study, and write elsewhere.
  std::vector<std::vector<std::string>> reading() const {
    const std::string study = disk_ + "/study";
    const auto out = [&](const char* name) { return study_.scratch() / name; };
    return {
        {"study", "status", study},
        {"study", "verify", study},
        {"stats", "run", study, "--run-mode", "simulated"},
        {"export", study, "--run-mode", "simulated", "--out", out("export")},
        {"report", study, "--run-mode", "simulated", "--out", out("report.html")},
        {"study", "backup", study, "--out", out("backup")}};
  }
};

TEST_F(NoSpaceTest, CanBeReadExportedAndBackedUp) {
  for (const auto& command : reading()) {
    const auto finished = withoutSpace("", command);
    EXPECT_EQ(finished.status, 0) << command.front() << "\n" << finished.error;
  }
  EXPECT_EQ(
      tests::run({tests::program(), "study", "verify", study_.scratch() / "backup"}).status, 0);
}

TEST_F(NoSpaceTest, CanBeReadAlsoWhereTheReservedSpaceIsUsedUp) {
  const std::string useUp = "rm '" + disk_ + "/study/ballast';";
  for (const auto& command : reading()) {
    const auto finished = withoutSpace(useUp, command);
    EXPECT_EQ(finished.status, 0) << command.front() << "\n" << finished.error;
  }
}

TEST_F(NoSpaceTest, RefusesAStudyWhoseLogCannotBeRead) {
  // Without shared memory the log is not read. What a crash left there must not be passed over.
  const std::string crash =
      "rm '" + disk_ + "/study/ballast'; echo log > '" + disk_ + "/study/study.db-wal';";
  const auto refused = withoutSpace(crash, {"study", "verify", disk_ + "/study"});
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(refused.error.find("the disk is full"), std::string::npos) << refused.error;
}

/// A study with a participant, on a disk without any free space: what names its conditions
/// writes an event first.
class NoSpaceForAnEventTest : public NoSpaceTest {
 protected:
  void SetUp() override {
    {
      auto session = Session::enrol(*study_, {.cohort = "surgeons"});
      tests::walkToTheEnd(session);
    }
    // Closes the study, without a simulated session.
    DiskTest::SetUp();  // NOLINT(bugprone-parent-virtual-call)
  }

  struct Unblinding {
    std::vector<std::string> command;
    std::string event;
    std::string out;  ///< a file or folder that it writes
  };
  std::vector<Unblinding> unblindings() const {
    const auto of = [&](std::vector<std::string> words, const std::string& out) {
      for (const std::string word : {"--run-mode", "live", "--reason", "a full disk"}) {
        words.push_back(word);
      }
      if (!out.empty()) words.insert(words.end(), {"--out", out});
      return words;
    };
    const std::string study = disk_ + "/study";
    const std::string out = study_.scratch() / "out";
    const std::string page = study_.scratch() / "page.html";
    return {
        {of({"export", study, "--unblind"}, out), "unblinded_export", out},
        {of({"report", study}, page), "unblinded_report", page},
        {of({"stats", "run", study}, {}), "unblinded_results", {}}};
  }

  /// Runs a command, and keeps the study until the next call.
  tests::Finished tried(const std::string& before, const Unblinding& unblinding) {
    tests::forgetWhatWasSigned();  // each call goes on with the same study
    fs::remove_all(after_);
    fs::remove_all(unblinding.out);
    return withoutSpace(
        before,
        unblinding.command,
        "; status=$?; rm '" + disk_ + "/zeros'; cp -r '" + disk_ + "/study' '" + after_ +
            "'; exit $status");
  }

  /// How many events of that kind the kept study has; -1 if it is damaged.
  int eventsAfterwards(const std::string& kind) const {
    auto study = Study::open(after_);
    if (!verify(study).isSound()) return -1;
    const auto events = study.events().read();
    return static_cast<int>(std::count_if(
        events.begin(), events.end(), [&](const auto& event) { return event.name() == kind; }));
  }

  std::string after_ = study_.scratch() / "after";
};

TEST_F(NoSpaceForAnEventTest, IsUnblindedFromTheReservedSpace) {
  for (const auto& unblinding : unblindings()) {
    const auto done = tried("", unblinding);
    EXPECT_EQ(done.status, 0) << unblinding.event << "\n" << done.error;
    EXPECT_EQ(eventsAfterwards(unblinding.event), 1) << unblinding.event;
    EXPECT_TRUE(unblinding.out.empty() || fs::exists(unblinding.out)) << unblinding.out;
  }
}

TEST_F(NoSpaceForAnEventTest, IsNotUnblindedWhereTheEventHasNoRoomAndSaysWhatToDo) {
  const std::string useUp = "rm '" + disk_ + "/study/ballast';";
  for (const auto& unblinding : unblindings()) {
    const auto refused = tried(useUp, unblinding);
    EXPECT_EQ(refused.status, 1) << unblinding.event;
    EXPECT_EQ(refused.out.find("Kalman"), std::string::npos) << refused.out;
    EXPECT_NE(
        refused.error.find("the disk is full. Free some space and try again"), std::string::npos)
        << refused.error;
    EXPECT_EQ(eventsAfterwards(unblinding.event), 0) << unblinding.event;
    EXPECT_FALSE(fs::exists(unblinding.out)) << unblinding.out;
  }
}

TEST_F(NoSpaceForAnEventTest, IsExportedBlindedAndSaysIfThisIsNotNoted) {
  const std::string out = study_.scratch() / "out";
  const Unblinding blinded{
      {"export", disk_ + "/study", "--run-mode", "live", "--out", out}, "exported", out};
  const auto noted = tried("", blinded);
  EXPECT_EQ(noted.status, 0) << noted.error;
  EXPECT_EQ(noted.out.find(kCopyNotNoted), std::string::npos) << noted.out;
  EXPECT_EQ(eventsAfterwards("exported"), 1);
  const auto unnoted = tried("rm '" + disk_ + "/study/ballast';", blinded);
  EXPECT_EQ(unnoted.status, 0) << unnoted.error;
  EXPECT_NE(unnoted.out.find(kCopyNotNoted), std::string::npos) << unnoted.out;
  EXPECT_EQ(eventsAfterwards("exported"), 0);
  EXPECT_TRUE(fs::exists(out));
}

/// Other file systems cannot be mounted here: a list of mounts is put before the kernel's.
class NetworkDriveTest : public DiskTest {
 protected:
  tests::Finished on(const std::string& type, const std::vector<std::string>& command) {
    std::vector<std::string> call{tests::program()};
    call.insert(call.end(), command.begin(), command.end());
    const std::string mounts = study_.scratch() / "mounts";
    return onItsOwn(
        "set -- $(stat -c '%Hd %Ld' '" + study_.folder() + "'); echo \"36 35 $1:$2 / / rw - " +
        type + " server:/home rw\" > '" + mounts + "' && mount --bind '" + mounts +
        "' /proc/$$/mountinfo && exec " + asShell(call));
  }
};

TEST_F(NetworkDriveTest, IsRefusedWhenAStudyIsOpenedForWriting) {
  for (const std::string type : {"nfs4", "cifs", "9p", "ceph", "fuse.sshfs"}) {
    const auto refused = on(type, {"study", "simulate", study_.folder(), "--participants", "1"});
    EXPECT_EQ(refused.status, 1) << type;
    EXPECT_NE(refused.error.find("network drive (" + type + ")"), std::string::npos)
        << refused.error;
  }
}

TEST_F(NetworkDriveTest, IsNotNamedWhereTheKindOfDriveIsUnknown) {
  const auto refused = on("fuse", {"study", "simulate", study_.folder(), "--participants", "1"});
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(refused.error.find("drive of unknown kind (fuse)"), std::string::npos) << refused.error;
}

TEST_F(NetworkDriveTest, IsNotTakenForOneWhereItIsADiskOfThisComputer) {
  int participants = 0;
  for (const std::string type : {"ext4", "btrfs", "tmpfs", "fuseblk", "fuse.gocryptfs"}) {
    const auto count = std::to_string(++participants);
    const auto done = on(type, {"study", "simulate", study_.folder(), "--participants", count});
    EXPECT_EQ(done.status, 0) << type << "\n" << done.error;
  }
}

TEST_F(NetworkDriveTest, KeepsABackupThatCanBeVerifiedAndCopied) {
  EXPECT_EQ(on("nfs", {"study", "verify", study_.folder()}).status, 0);
  const auto copied =
      on("nfs", {"study", "backup", study_.folder(), "--out", study_.scratch() / "copy"});
  EXPECT_EQ(copied.status, 0) << copied.error;
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

// The program with windows: what it opens, also on a computer without a display.
#include <signal.h>
#include <unistd.h>

#include <filesystem>

#include <gtest/gtest.h>

#include "tests/study/made_study.h"
#include "tests/support/child_process.h"
#include "tests/support/programs.h"

namespace studio_test {

tests::Finished studioWithoutAScreen(const std::string& argument) {
  return tests::run(
      {"env",
       "-u",
       "DISPLAY",
       "-u",
       "WAYLAND_DISPLAY",
       "-u",
       "QT_QPA_PLATFORM",
       tests::studio(),
       argument});
}

/// A command that is started where new files would be readable and writable for everybody.
std::vector<std::string> underOpenUmask(const std::vector<std::string>& command) {
  std::vector<std::string> call{"sh", "-c", "umask 000; exec \"$0\" \"$@\""};
  call.insert(call.end(), command.begin(), command.end());
  return call;
}

constexpr auto kRightsOfOthers =
    std::filesystem::perms::group_all | std::filesystem::perms::others_all;

/// What others may read, write or search in a folder.
std::vector<std::string> openToOthers(const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  std::vector<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const auto rights = entry.symlink_status().permissions();
    const bool isOpen = (rights & kRightsOfOthers) != fs::perms::none;
    if (isOpen && !entry.is_symlink()) names.push_back(entry.path().string());
  }
  return names;
}

TEST(Studio, ReportsThatThereIsNoScreen) {
  const auto finished = studioWithoutAScreen("some-study");
  EXPECT_EQ(finished.status, 1);
  EXPECT_NE(finished.error.find("there is no screen"), std::string::npos) << finished.error;
  EXPECT_EQ(finished.error.find("qt.qpa"), std::string::npos) << finished.error;
}

TEST(Studio, HelpsWithoutAScreen) {
  const auto finished = studioWithoutAScreen("--help");
  EXPECT_EQ(finished.status, 0) << finished.error;
  EXPECT_NE(finished.out.find("--devices"), std::string::npos) << finished.out;
}

TEST(Studio, OpensTheStudyWhoseDatabaseAFileManagerHandsOver) {
  tests::MadeStudy study;
  study.close();
  for (const auto& open : openToOthers(study.folder())) {  // this test program made them
    std::filesystem::permissions(open, kRightsOfOthers, std::filesystem::perm_options::remove);
  }
  const std::string settings = study.scratch() / "settings";
  tests::ChildProcess studio(
      underOpenUmask({tests::studio(), study.file("study.db")}),
      {"QT_QPA_PLATFORM=offscreen", "XDG_CONFIG_HOME=" + settings});
  // The studio remembers a study, by its folder, once it has opened it.
  const auto isRemembered = [&] {
    if (!std::filesystem::exists(settings)) return false;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(settings)) {
      if (!entry.is_regular_file()) continue;
      const auto text = tests::contentOf(entry.path().string());
      if (text.find(study.folder() + "\n") != std::string::npos) return true;
    }
    return false;
  };
  while (!isRemembered() && !studio.hasEnded()) usleep(20'000);
  EXPECT_TRUE(isRemembered());
  EXPECT_EQ(openToOthers(settings), std::vector<std::string>{});
  EXPECT_EQ(openToOthers(study.folder()), std::vector<std::string>{});
  studio.kill(SIGTERM);
  studio.finish();
}

TEST(Studio, WritesFilesForTheirOwnerAlone) {
  const tests::ScratchFolder folder;
  const auto written =
      tests::run(underOpenUmask({tests::studio(), "--write-knee", folder / "knee.obj"}));
  ASSERT_EQ(written.status, 0) << written.error;
  EXPECT_EQ(openToOthers(folder.path()), std::vector<std::string>{});
  // Control: the same look finds a file that another program writes under that umask.
  ASSERT_EQ(tests::run(underOpenUmask({"touch", folder / "control"})).status, 0);
  EXPECT_EQ(openToOthers(folder.path()), std::vector<std::string>{folder / "control"});
}

}  // namespace studio_test

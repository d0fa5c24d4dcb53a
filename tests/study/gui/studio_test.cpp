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
  const std::string settings = study.scratch() / "settings";
  tests::ChildProcess studio(
      {tests::studio(), study.file("study.db")},
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
  studio.kill(SIGTERM);
  studio.finish();
}

}  // namespace studio_test

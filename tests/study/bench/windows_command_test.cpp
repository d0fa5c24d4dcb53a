// palpate-bench windows: under OpenGL where an X server is installed.
#include <filesystem>

#include <gtest/gtest.h>

#include <QImage>
#include <QStandardPaths>

#include "tests/support/child_process.h"
#include "tests/support/programs.h"
#include "tests/support/scratch_folder.h"

namespace windows_command_test {

class WindowsCommand : public testing::Test {
 protected:
  tests::Finished run(std::vector<std::string> how, const std::vector<std::string>& more = {}) {
    how.insert(
        how.end(),
        {tests::releaseProgram(), "bench", "windows", "--seconds", "0.5", "--spheres", "2000"});
    how.insert(how.end(), {"--out", folder_ / "pictures"});
    std::filesystem::remove_all(folder_ / "pictures");  // from the previous run
    how.insert(how.end(), more.begin(), more.end());
    return tests::run(how);
  }

  /// The share of a picture that is brighter than its background [%].
  int bright(const std::string& name) const {
    const QImage picture(QString::fromStdString(folder_ / "pictures/" + name));
    EXPECT_EQ(picture.size(), size_);
    int count = 0;
    for (int y = 0; y < picture.height(); ++y) {
      for (int x = 0; x < picture.width(); ++x) count += qGray(picture.pixel(x, y)) > 45 ? 1 : 0;
    }
    return picture.isNull() ? 0 : 100 * count / (picture.width() * picture.height());
  }

  tests::ScratchFolder folder_;
  QSize size_{1280, 800};
};

TEST_F(WindowsCommand, DrawsOnTheProcessorWithoutADisplay) {
  const auto finished = run({"env", "QT_QPA_PLATFORM=offscreen"});
  EXPECT_LE(finished.status, 1) << finished.error;  // with a small cup all bytes may change
  EXPECT_NE(finished.out.find("software rasteriser"), std::string::npos) << finished.out;
  EXPECT_NE(finished.out.find("this display has no OpenGL"), std::string::npos) << finished.out;
  EXPECT_NE(finished.out.find("three channels at 1 kHz"), std::string::npos) << finished.out;
  EXPECT_NE(
      tests::contentOf(folder_ / "pictures/windows-pages.csv").find("\n260,"), std::string::npos);
  EXPECT_NE(
      tests::contentOf(folder_ / "pictures/windows-home.csv").find("\n200,"), std::string::npos);
  EXPECT_GT(bright("knee-1.png"), 30);
  EXPECT_GT(bright("hip-1.png"), 15);
}

TEST_F(WindowsCommand, DrawsAtAGivenSizeAndWritesTheSizeOfAScaledPicture) {
  const auto finished =
      run({"env", "QT_QPA_PLATFORM=offscreen"}, {"--part", "simulations", "--size", "3840x2160"});
  EXPECT_LE(finished.status, 1) << finished.error;
  EXPECT_NE(finished.out.find("a window of 3840 × 2160"), std::string::npos) << finished.out;
  EXPECT_NE(finished.out.find("1920 × 1080"), std::string::npos) << finished.out;
  EXPECT_EQ(finished.out.find("Live plots"), std::string::npos) << finished.out;
  size_ = {3840, 2160};
  EXPECT_GT(bright("knee-1.png"), 30);
}

TEST_F(WindowsCommand, DrawsWithOpenGlOnADisplay) {
  if (QStandardPaths::findExecutable(QStringLiteral("xvfb-run")).isEmpty()) {
    GTEST_SKIP() << "needs xvfb-run: ./setup --check";
  }
  const auto knee = folder_ / "knee.obj";
  ASSERT_EQ(tests::run({tests::releaseStudio(), "--write-knee", knee}).status, 0);
  for (const char* renderer : {"best", "finest"}) {
    const auto finished =
        run({"env", "QT_QPA_PLATFORM=xcb", "xvfb-run", "-a", "-s", "-screen 0 1400x900x24"},
            {"--part", "simulations", "--renderer", renderer, "--anatomy", knee});
    ASSERT_NE(finished.out.find("reamer and cup"), std::string::npos) << finished.error;
    if (finished.out.find("software rasteriser") != std::string::npos) {
      GTEST_SKIP() << "no OpenGL 3.3 on this X server: " << finished.out;
    }
    EXPECT_GT(bright("knee-1.png"), 30) << renderer;
    EXPECT_GT(bright("hip-1.png"), 15) << renderer;
  }
}

TEST_F(WindowsCommand, DrawsAKneeFromAFile) {
  const auto written = tests::run({tests::releaseStudio(), "--write-knee", folder_ / "knee.obj"});
  ASSERT_EQ(written.status, 0) << written.error;
  EXPECT_EQ(tests::run({tests::releaseStudio(), "--write-knee", folder_ / "knee.obj"}).status, 1)
      << "nothing is ever overwritten";
  const auto finished =
      run({"env", "QT_QPA_PLATFORM=offscreen"},
          {"--part", "simulations", "--anatomy", folder_ / "knee.obj"});
  EXPECT_LE(finished.status, 1) << finished.error;
  EXPECT_GT(bright("knee-1.png"), 30);
}

TEST_F(WindowsCommand, RefusesOptionsOutOfRangeAndAKneeInMetres) {
  const auto finished =
      tests::run({tests::releaseProgram(), "bench", "windows", "--seconds", "no"});
  EXPECT_EQ(finished.status, 2);
  EXPECT_NE(finished.error.find("--seconds"), std::string::npos) << finished.error;
  for (const char* size : {"1280", "1280x100", "1280xhigh"}) {
    EXPECT_EQ(tests::run({tests::releaseProgram(), "bench", "windows", "--size", size}).status, 2)
        << size;
  }
  const auto metres =
      folder_.write("metres.obj", "o tibia\nv 0 0 0\nv 0.06 0 0\nv 0 0 0.06\nf 1 2 3\n");
  const auto knee = run({"env", "QT_QPA_PLATFORM=offscreen"}, {"--anatomy", metres});
  EXPECT_EQ(knee.status, 1);
  EXPECT_NE(knee.error.find("likely metres"), std::string::npos) << knee.error;
}

}  // namespace windows_command_test

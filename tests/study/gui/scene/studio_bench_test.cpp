// The measuring of pictures, by the program itself: under OpenGL where an X server can be had.
#include <gtest/gtest.h>

#include <QImage>
#include <QStandardPaths>

#include "tests/support/child_process.h"
#include "tests/support/programs.h"
#include "tests/support/scratch_folder.h"

namespace studio_bench_test {

class StudioBench : public testing::Test {
 protected:
  tests::Finished run(std::vector<std::string> how, const std::vector<std::string>& more = {}) {
    how.insert(
        how.end(), {tests::releaseStudio(), "--bench", "--seconds", "0.5", "--spheres", "2000"});
    how.insert(how.end(), {"--out", folder_ / "pictures"});
    how.insert(how.end(), more.begin(), more.end());
    return tests::run(how);
  }

  /// The share of a picture that is not as dark as its ground [%].
  int bright(const std::string& name) const {
    const QImage picture(QString::fromStdString(folder_ / "pictures/" + name));
    EXPECT_EQ(picture.size(), QSize(1280, 800));
    int count = 0;
    for (int y = 0; y < picture.height(); ++y) {
      for (int x = 0; x < picture.width(); ++x) count += qGray(picture.pixel(x, y)) > 45 ? 1 : 0;
    }
    return picture.isNull() ? 0 : 100 * count / (picture.width() * picture.height());
  }

  tests::ScratchFolder folder_;
};

TEST_F(StudioBench, DrawsOnTheProcessorWithoutADisplay) {
  const auto finished = run({"env", "QT_QPA_PLATFORM=offscreen"});
  EXPECT_LE(finished.status, 1) << finished.error;  // whether targets are met is the machine's
  EXPECT_NE(finished.out.find("drawn by software rasteriser"), std::string::npos) << finished.out;
  EXPECT_NE(finished.out.find("at least 25"), std::string::npos) << finished.out;
  EXPECT_NE(finished.out.find("this display has no OpenGL"), std::string::npos) << finished.out;
  EXPECT_NE(finished.out.find("Live plots, three channels"), std::string::npos) << finished.out;
  EXPECT_NE(finished.out.find("page changes            260"), std::string::npos) << finished.out;
  EXPECT_GT(bright("knee-1.png"), 30);
  EXPECT_GT(bright("hip-1.png"), 15);
}

TEST_F(StudioBench, DrawsWithOpenGlOnADisplay) {
  if (QStandardPaths::findExecutable(QStringLiteral("xvfb-run")).isEmpty()) {
    GTEST_SKIP() << "no xvfb-run";
  }
  const auto knee = folder_ / "knee.obj";
  ASSERT_EQ(tests::run({tests::releaseStudio(), "--write-knee", knee}).status, 0);
  for (const char* renderer : {"best", "finest"}) {
    const auto finished =
        run({"env", "QT_QPA_PLATFORM=xcb", "xvfb-run", "-a", "-s", "-screen 0 1400x900x24"},
            {"--renderer", renderer, "--anatomy", knee});
    ASSERT_NE(finished.out.find("Reamer and cup"), std::string::npos) << finished.error;
    if (finished.out.find("software rasteriser") != std::string::npos) {
      GTEST_SKIP() << "no OpenGL 3.3 on this X server: " << finished.out;
    }
    EXPECT_GT(bright("knee-1.png"), 30) << renderer;
    EXPECT_GT(bright("hip-1.png"), 15) << renderer;
  }
}

TEST_F(StudioBench, DrawsAKneeThatItWroteItself) {
  const auto written = tests::run({tests::releaseStudio(), "--write-knee", folder_ / "knee.obj"});
  ASSERT_EQ(written.status, 0) << written.error;
  EXPECT_EQ(tests::run({tests::releaseStudio(), "--write-knee", folder_ / "knee.obj"}).status, 1)
      << "nothing is ever overwritten";
  const auto finished =
      run({"env", "QT_QPA_PLATFORM=offscreen"}, {"--anatomy", folder_ / "knee.obj"});
  EXPECT_LE(finished.status, 1) << finished.error;
  EXPECT_GT(bright("knee-1.png"), 30);
}

TEST_F(StudioBench, RefusesWhatMakesNoSense) {
  const auto finished = tests::run(
      {"env", "QT_QPA_PLATFORM=offscreen", tests::releaseStudio(), "--bench", "--seconds", "no"});
  EXPECT_EQ(finished.status, 2);
  EXPECT_NE(finished.error.find("--seconds"), std::string::npos) << finished.error;
  const auto metres =
      folder_.write("metres.obj", "o tibia\nv 0 0 0\nv 0.06 0 0\nv 0 0 0.06\nf 1 2 3\n");
  const auto knee = run({"env", "QT_QPA_PLATFORM=offscreen"}, {"--anatomy", metres});
  EXPECT_EQ(knee.status, 2);
  EXPECT_NE(knee.error.find("likely metres"), std::string::npos) << knee.error;
}

}  // namespace studio_bench_test

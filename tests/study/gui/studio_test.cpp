// The program with the windows, where there is nowhere to open one.
#include <gtest/gtest.h>

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

TEST(Studio, SaysThatItHasNoScreen) {
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

}  // namespace studio_test

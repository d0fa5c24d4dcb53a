#include <cstdlib>

#include <gtest/gtest.h>

int main(int argc, char** argv) {
  // Windows are tested without a display; tests are also listed at build time.
  setenv("QT_QPA_PLATFORM", "offscreen", 0);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}

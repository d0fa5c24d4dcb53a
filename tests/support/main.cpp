#include <cstdlib>

#include <gtest/gtest.h>

#include "tests/support/scratch_folder.h"
#include "tests/support/standstill.h"

/// The C library never frees memory for LOCPATH; the leak sanitizer asks this function what to
/// suppress.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
  return "leak:argz_add_sep\n";
}

int main(int argc, char** argv) {
  // Windows are tested without a display; tests are also listed at build time.
  setenv("QT_QPA_PLATFORM", "offscreen", 0);
  // What a station keeps for itself stays out of the home folder of whoever runs the tests.
  const tests::ScratchFolder station;
  setenv("PALPATE_STATION", (station / "station").c_str(), 0);
  testing::InitGoogleTest(&argc, argv);
  return tests::runAllTests();
}

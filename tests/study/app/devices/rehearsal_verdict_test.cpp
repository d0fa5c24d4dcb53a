#include <chrono>

#include <gtest/gtest.h>

#include "study/app/devices/device_rehearse.h"

namespace study::app {
namespace rehearsal_verdict_test {

using std::chrono::milliseconds;

TEST(RehearsalVerdict, FailsOnlyIfTheMachineDidNotStandStill) {
  // The punch switches its force off 10 ms after the last command (docs/punch-protocol.md).
  EXPECT_EQ(verdictOf(false, milliseconds(0)), RehearsalVerdict::Failed);
  EXPECT_EQ(verdictOf(false, milliseconds(9)), RehearsalVerdict::Failed);
  EXPECT_EQ(verdictOf(false, milliseconds(10)), RehearsalVerdict::Inconclusive);
  EXPECT_EQ(verdictOf(false, milliseconds(500)), RehearsalVerdict::Inconclusive);
}

TEST(RehearsalVerdict, PassesEvenIfTheMachineStoodStill) {
  EXPECT_EQ(verdictOf(true, milliseconds(500)), RehearsalVerdict::Passed);
}

TEST(RehearsalVerdict, IsAnExitStatus) {
  EXPECT_EQ(static_cast<int>(RehearsalVerdict::Passed), 0);
  EXPECT_EQ(static_cast<int>(RehearsalVerdict::Failed), 1);
  EXPECT_EQ(static_cast<int>(RehearsalVerdict::Inconclusive), 3);
}

}  // namespace rehearsal_verdict_test
}  // namespace study::app

#include "haptics/engine/passivity.h"

#include <gtest/gtest.h>

namespace haptics::engine {
namespace passivity_test {

// The numbers that the punch paper prints below its eq. (25): K = 4.39 N/deg at 57 deg/s.
constexpr double kSpeed = 57.0;

Passivity at(double rate) {
  return {.stiffness = 4.39, .period = 1.0 / rate};
}

TEST(Passivity, GivesThePapersForceErrors) {
  EXPECT_NEAR(at(375.0).forceErrorAt(kSpeed), 0.334, 1e-3);
  EXPECT_NEAR(at(1000.0).forceErrorAt(kSpeed), 0.125, 1e-3);
  EXPECT_NEAR(at(25.0).forceErrorAt(kSpeed), 5.0, 0.01);
}

TEST(Passivity, GivesThePapersDamping) {
  EXPECT_NEAR(at(375.0).requiredDamping(), 5.9e-3, 5e-5);
  EXPECT_NEAR(at(1000.0).requiredDamping(), 2.2e-3, 5e-5);
  EXPECT_NEAR(at(4000.0).requiredDamping(), 5.5e-4, 5e-6);
}

TEST(Passivity, CountsEverythingThatMakesAForceOld) {
  auto late = at(1000.0);
  late.lateness = 0.0005;
  late.filterDelay = 0.0025;
  // A delay as often as Gil et al. 2009 have it, b > K (T/2 + τ): twice the paper's.
  EXPECT_DOUBLE_EQ(late.effectivePeriod(), 0.001 + 0.0005 + 2 * 0.0025);
  EXPECT_NEAR(late.requiredDamping(), late.stiffness * (0.0015 / 2 + 0.0025), 1e-12);
}

TEST(Passivity, AllowsTheStiffnessThatNeedsTheDampingThatThereIs) {
  const auto loop = at(1000.0);
  EXPECT_NEAR(loop.allowedStiffness(loop.requiredDamping()), loop.stiffness, 1e-12);
}

}  // namespace passivity_test
}  // namespace haptics::engine

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "haptics/engine/passivity.h"

namespace haptics::engine {
namespace energy_observer_test {

constexpr double kDt = 0.001;

/// In and out of a virtual wall at a speed, its force held over each step: the least energy.
double leastEnergyOfAWall(double stiffness, double speed, double damping, double dt) {
  EnergyObserver observer({.deviceDamping = damping});
  const double step = speed * dt;
  double travel = 0.0;
  double held = 0.0;
  double least = 0.0;
  const auto move = [&](double by) {
    observer.observe(held, by, by / dt, dt);
    travel += by;
    held = travel > 0.0 ? stiffness * travel : 0.0;
    least = std::min(least, observer.energy());
  };
  for (int i = 0; i < 1000; ++i) move(step);
  for (int i = 0; i < 1000; ++i) move(-step);
  return least;
}

TEST(EnergyObserver, CountsTheEnergyOfAHeldForce) {
  // Held too small on the way in and too large on the way out: K v T x in all, over x = 1000 v T.
  const double stiffness = 4.39;
  const double speed = 7.0;
  const double depth = 1000.0 * speed * kDt;
  EXPECT_NEAR(
      leastEnergyOfAWall(stiffness, speed, 0.0, kDt), -stiffness * speed * kDt * depth, 0.1);
}

TEST(EnergyObserver, AgreesWithEquation25OnHowMuchDampingThatTakes) {
  // b = K T / 2 of the punch paper: with a little more the wall is passive, with a little less not.
  for (const double stiffness : {0.5, 4.39, 18.86, 500.0}) {
    for (const double dt : {1.0 / 375, 0.001, 0.00025}) {
      const double needed = 0.5 * stiffness * dt;
      EXPECT_GE(leastEnergyOfAWall(stiffness, 20.0, 1.01 * needed, dt), -1e-9 * stiffness);
      EXPECT_LT(leastEnergyOfAWall(stiffness, 20.0, 0.9 * needed, dt), 0.0);
    }
  }
}

TEST(EnergyObserver, CountsEnergyForEachContactSeparately) {
  EnergyObserver observer({});
  for (int i = 0; i < 100; ++i) observer.observe(2.0, 0.1, 100.0, kDt);  // takes 20
  EXPECT_NEAR(observer.energy(), 20.0, 1e-9);
  observer.observe(0.0, 0.1, 100.0, kDt);
  EXPECT_EQ(observer.energy(), 0.0);
  observer.observe(2.0, -0.1, -100.0, kDt);
  EXPECT_TRUE(observer.isActive());
  EXPECT_NEAR(observer.least(), -0.2, 1e-12);
}

TEST(EnergyObserver, NeverDividesByZeroVelocity) {
  EnergyObserver observer({.mostDamping = 2.0, .leastVelocity = 1e-6});
  observer.observe(3.0, -1.0, -1000.0, kDt);
  ASSERT_TRUE(observer.isActive());
  for (const double v : {0.0, -0.0, 1e-300, -1e-7, std::numeric_limits<double>::denorm_min()}) {
    EXPECT_EQ(observer.damped(1.5, v, kDt), 1.5) << v;
  }
  // Elsewhere it damps, against the motion, and never by more than it may.
  EXPECT_NEAR(observer.damped(1.5, 10.0, kDt), 1.5 + 2.0 * 10.0, 1e-12);
  EXPECT_NEAR(observer.damped(1.5, -1000.0, kDt), 1.5 - 3.0 / (1e6 * kDt) * 1000.0, 1e-9);
  EXPECT_EQ(observer.damped(1.5, 10.0, 0.0), 1.5);
}

TEST(EnergyObserver, IgnoresNaN) {
  EnergyObserver observer({.deviceDamping = 0.1, .mostDamping = 1.0});
  for (const double bad : {std::nan(""), double{INFINITY}, -double{INFINITY}, 1e308}) {
    observer.observe(bad, 1e10, 1.0, kDt);
    observer.observe(1.0, bad, bad, kDt);
    EXPECT_TRUE(std::isfinite(observer.energy()));
    EXPECT_TRUE(std::isfinite(observer.damped(1.0, 1.0, kDt)));
  }
}

}  // namespace energy_observer_test
}  // namespace haptics::engine

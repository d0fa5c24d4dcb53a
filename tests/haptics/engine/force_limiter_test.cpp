#include "haptics/engine/force_limiter.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

namespace haptics::engine {
namespace force_limiter_test {

constexpr double kDt = 0.001;

TEST(ForceLimiter, LetsAHarmlessForcePass) {
  ForceLimiter limiter({.maxForce = 5.0, .maxRate = 1000.0});
  EXPECT_EQ(limiter.limit(0.5, kDt).force, 0.5);
  EXPECT_EQ(limiter.limit(0.5, kDt).interventions, ForceLimiter::None);
}

TEST(ForceLimiter, NeverExceedsTheMaximumForce) {
  ForceLimiter limiter({.maxForce = 5.0, .maxRate = 1e9});
  for (const double wild : {1e308, -1e308, 6.0, -7.0, 5.0001}) {
    const auto limited = limiter.limit(wild, kDt);
    EXPECT_LE(std::abs(limited.force), 5.0);
    EXPECT_TRUE((limited.interventions & ForceLimiter::Saturated) != 0);
  }
}

TEST(ForceLimiter, NeverChangesFasterThanAllowed) {
  ForceLimiter limiter({.maxForce = 5.0, .maxRate = 100.0});
  double last = 0.0;
  for (int i = 0; i < 200; ++i) {
    const double force = limiter.limit(i % 2 == 0 ? 5.0 : -5.0, kDt).force;
    EXPECT_LE(std::abs(force - last), 100.0 * kDt * (1.0 + 1e-12));
    last = force;
  }
}

TEST(ForceLimiter, HasNoForceForNaN) {
  ForceLimiter limiter({.maxForce = 5.0, .maxRate = 1e6});
  limiter.limit(4.0, kDt);
  for (const double bad : {std::nan(""), double{INFINITY}, -double{INFINITY}}) {
    const auto limited = limiter.limit(bad, kDt);
    EXPECT_EQ(limited.force, 0.0);
    EXPECT_EQ(limited.interventions, ForceLimiter::NotFinite);
  }
}

TEST(ForceLimiter, LimitsATorqueInSizeAndRate) {
  auto limiter = ForceLimiter::forTorque({.maxTorque = 2.0, .maxTorqueRate = 50.0});
  double last = 0.0;
  for (int i = 0; i < 200; ++i) {
    const auto limited = limiter.limit(i < 100 ? 9.0 : -9.0, kDt);
    EXPECT_LE(std::abs(limited.force), 2.0);
    EXPECT_LE(std::abs(limited.force - last), 50.0 * kDt * (1.0 + 1e-12));
    EXPECT_NE(limited.interventions & ForceLimiter::TorqueSaturated, 0);
    EXPECT_EQ(limited.interventions & (ForceLimiter::Saturated | ForceLimiter::Slewed), 0);
    last = limited.force;
  }
  EXPECT_EQ(last, -2.0);
  EXPECT_NE(limiter.limit(2.0, kDt).interventions & ForceLimiter::TorqueSlewed, 0);
}

TEST(ForceLimiter, RefusesLimitsThatAreNone) {
  EXPECT_THROW(ForceLimiter({.maxForce = 0.0}), std::invalid_argument);
  EXPECT_THROW(ForceLimiter({.maxForce = -1.0}), std::invalid_argument);
  EXPECT_THROW(ForceLimiter({.maxForce = INFINITY}), std::invalid_argument);
  EXPECT_THROW(ForceLimiter({.maxRate = std::nan("")}), std::invalid_argument);
  EXPECT_THROW(ForceLimiter::forTorque({.maxTorque = 0.0}), std::invalid_argument);
  EXPECT_THROW(ForceLimiter::forTorque({.maxTorqueRate = INFINITY}), std::invalid_argument);
}

}  // namespace force_limiter_test
}  // namespace haptics::engine

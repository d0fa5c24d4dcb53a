#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "haptics/timing/clock_statistics.h"

namespace haptics::timing {
namespace clock_drift_test {

TEST(ClockDrift, IsFoundUnderDelaysThatAreOftenLong) {
  for (const double ppm : {-200.0, -20.0, 0.0, 3.0, 150.0}) {
    ClockDrift drift;
    std::mt19937 random(5);
    std::exponential_distribution<double> delay(1.0 / 300e3);  // mean 300 µs
    for (std::int64_t i = 0; i < 60'000; ++i) {
      const std::int64_t device = 1'000'000 * i + 77;
      const double host = static_cast<double>(device) * (1.0 + 1e-6 * ppm) + 5e12 + 50e3;
      drift.add(device, static_cast<std::int64_t>(host + delay(random)));
    }
    ASSERT_TRUE(drift.partsPerMillion());
    EXPECT_NEAR(*drift.partsPerMillion(), ppm, 0.3);
    EXPECT_NEAR(static_cast<double>(drift.offset()), 5e12, 5e6);
  }
}

TEST(ClockDrift, IsUndefinedBeforeThreeWindows) {
  ClockDrift drift;
  EXPECT_FALSE(drift.partsPerMillion());
  for (std::int64_t i = 0; i < 1000; ++i) drift.add(1'000'000 * i, 1'000'000 * i);
  EXPECT_FALSE(drift.partsPerMillion());
}

TEST(ClockDrift, OutlivesAPause) {
  ClockDrift drift;
  const auto at = [](std::int64_t device) {
    return device + static_cast<std::int64_t>(1e-4 * static_cast<double>(device));
  };
  for (std::int64_t i = 0; i < 3000; ++i) drift.add(1'000'000 * i, at(1'000'000 * i));
  for (std::int64_t i = 3'600'000; i < 3'603'000; ++i) drift.add(1'000'000 * i, at(1'000'000 * i));
  EXPECT_NEAR(*drift.partsPerMillion(), 100.0, 0.1);
}

}  // namespace clock_drift_test
}  // namespace haptics::timing

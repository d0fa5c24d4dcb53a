#include <cmath>

#include <gtest/gtest.h>

#include "haptics/engine/bone_models.h"

namespace haptics::engine {
namespace jitter_noise_test {

constexpr reaming::Jitter kJitter{.rms = 1.5, .rate = 100.0};

TEST(JitterNoise, HasTheMeasuredStrengthAtTheMeasuredRate) {
  JitterNoise noise(kJitter, 0.5, 3);
  double sum = 0.0;
  constexpr int kSamples = 20'000;
  for (int i = 0; i < kSamples; ++i) sum += std::pow(noise.step(200.0, 0.01), 2.0);
  EXPECT_NEAR(std::sqrt(sum / kSamples), 0.75, 0.02);
}

TEST(JitterNoise, IsTheSameForASeedAndAfterAReset) {
  JitterNoise one(kJitter, 1.0, 3);
  JitterNoise same(kJitter, 1.0, 3);
  JitterNoise other(kJitter, 1.0, 4);
  double difference = 0.0;
  double first = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const double felt = one.step(100.0, 0.001);
    if (i == 0) first = felt;
    ASSERT_EQ(felt, same.step(100.0, 0.001));
    difference += std::abs(felt - other.step(100.0, 0.001));
  }
  EXPECT_GT(difference, 1.0);
  one.reset();
  EXPECT_EQ(one.step(100.0, 0.001), first);
}

TEST(JitterNoise, IsZeroWithoutForceAndNeverPulls) {
  JitterNoise noise(kJitter, 1.0, 9);
  for (int i = 0; i < 10'000; ++i) {
    EXPECT_EQ(noise.step(0.0, 0.001), 0.0);
    ASSERT_GE(0.5 + noise.step(0.5, 0.001), 0.0);
  }
  JitterNoise none({}, 1.0, 9);
  EXPECT_EQ(none.step(100.0, 0.001), 0.0);
}

}  // namespace jitter_noise_test
}  // namespace haptics::engine

#include "haptics/reaming/material/sampled_curve.h"

#include <gtest/gtest.h>

namespace haptics::reaming {
namespace sampled_curve_test {

/// 1000 samples of y = 3 x to x = 2.
SampledCurve ramp() {
  SampledCurve curve;
  for (int i = 0; i <= 1000; ++i) {
    curve.x.push_back(0.002 * i);
    curve.y.push_back(0.006 * i);
  }
  return curve;
}

TEST(SampledCurve, AtPlacesGoesAsFarAsItsOwnEnd) {
  const auto curve = resampled(ramp(), 5.0, 101);
  ASSERT_EQ(curve.size(), 41U);  // 0 to 2.0 of 5.0
  for (std::size_t i = 0; i < curve.size(); ++i) {
    EXPECT_NEAR(curve.x[i], 0.05 * static_cast<double>(i), 1e-12);
    if (i == 0 || i == 40) continue;
    EXPECT_NEAR(curve.y[i], 3.0 * curve.x[i], 1e-3);
  }
}

TEST(SampledCurve, AtPlacesThatAreFinerThanItsSamplesLiesBetweenThem) {
  const SampledCurve coarse{{0.0, 1.0, 2.0}, {0.0, 10.0, 0.0}};
  const auto curve = resampled(coarse, 2.0, 9);
  EXPECT_EQ(curve.y, (std::vector<double>{0.0, 2.5, 5.0, 7.5, 10.0, 7.5, 5.0, 2.5, 0.0}));
}

TEST(SampledCurve, NormalisedHasSharesOfItsOwnEnd) {
  const auto curve = normalised(ramp(), 11);
  EXPECT_EQ(curve.x.front(), 0.0);
  EXPECT_EQ(curve.x.back(), 1.0);
  EXPECT_NEAR(curve.y[5], 3.0, 0.01);
}

TEST(SampledCurve, EndsWithTheMeanOfItsLastSamples) {
  EXPECT_NEAR(endValueOf(ramp(), 0.0), 6.0, 1e-12);
  EXPECT_NEAR(endValueOf(ramp(), 0.0041), (6.0 + 5.994 + 5.988) / 3.0, 1e-12);
}

}  // namespace sampled_curve_test
}  // namespace haptics::reaming

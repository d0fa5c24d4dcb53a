#include "haptics/models/fixed_point.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "haptics/models/kalman_filter.h"

namespace haptics::models {
namespace fixed_point_test {

constexpr double kStep = 1.0 / 65536.0;

TEST(Fixed, HoldsNumbersToHalfAStep) {
  for (const double value : {0.0, 1.0, -1.0, 3.14159, -2.71828, 32767.5, -32768.0}) {
    EXPECT_NEAR(Fixed(value).asDouble(), value, kStep / 2);
  }
  EXPECT_EQ(Fixed(7).raw(), 7 * 65536);
}

TEST(Fixed, StaysAtItsEndsAndNeverTurnsItsSign) {
  const Fixed largest = Fixed::fromRaw(Fixed::kLargest);
  const Fixed smallest = Fixed::fromRaw(Fixed::kSmallest);
  EXPECT_EQ(largest + Fixed(1), largest);
  EXPECT_EQ(smallest - Fixed(1), smallest);
  EXPECT_EQ(largest * largest, largest);
  EXPECT_EQ(largest * smallest, smallest);
  EXPECT_EQ(smallest * smallest, largest);
  EXPECT_EQ(-smallest, largest);
  EXPECT_EQ(Fixed(1e300), largest);
  EXPECT_EQ(Fixed(-1e300), smallest);
  EXPECT_EQ(Fixed(40000), largest);
  EXPECT_EQ(Fixed(std::nan("")), Fixed());
  EXPECT_EQ(Fixed(1) / Fixed(), largest);
  EXPECT_EQ(Fixed(-1) / Fixed(), smallest);
}

TEST(Fixed, CalculatesAsExactArithmeticThatIsRoundedAndCutOff) {
  std::mt19937_64 random(11);
  for (int i = 0; i < 200'000; ++i) {
    const auto any = [&] {
      return Fixed::fromRaw(static_cast<int32_t>(random() >> (random() % 32)));
    };
    const Fixed a = any();
    const Fixed b = any();
    const auto cutOff = [](long double value) {
      return std::clamp<long double>(value, Fixed::kSmallest, Fixed::kLargest);
    };
    const auto ra = static_cast<long double>(a.raw());
    const auto rb = static_cast<long double>(b.raw());
    ASSERT_EQ((a + b).raw(), cutOff(ra + rb));
    ASSERT_EQ((a - b).raw(), cutOff(ra - rb));
    ASSERT_EQ((a * b).raw(), cutOff(std::floor(ra * rb / 65536.0L + 0.5L)));
    if (b != Fixed()) {
      ASSERT_EQ((a / b).raw(), cutOff(std::trunc(ra * 65536.0L / rb)));
    }
  }
}

TEST(UniformCurve, IsTheStraightLineBetweenItsPoints) {
  UniformCurve<5, 14> curve(Fixed(2));  // 2, 2.25, … 3
  for (int i = 0; i < 5; ++i) curve.set(i, Fixed(i * i));
  EXPECT_EQ(curve.at(Fixed(2)).force, Fixed(0));
  EXPECT_NEAR(curve.at(Fixed(2.375)).force.asDouble(), 2.5, kStep);
  EXPECT_NEAR(curve.at(Fixed(2.375)).stiffness.asDouble(), 12.0, kStep);
  EXPECT_FALSE(curve.at(Fixed(1.99)).isDefined);
  EXPECT_FALSE(curve.at(Fixed(3.01)).isDefined);
  EXPECT_FALSE(curve.at(Fixed::fromRaw(Fixed::kSmallest)).isDefined);
  EXPECT_FALSE(curve.at(Fixed::fromRaw(Fixed::kLargest)).isDefined);
}

TEST(SteadyStateFilter, HasTheGainsThatTheFilterSettlesTo) {
  const auto gains = SteadyStateFilter<double>::gainsOf(KalmanNoise<double>().factored());
  EXPECT_NEAR(gains.finiteElements, 0.9999, 1e-4);  // as the step goes to 0
  EXPECT_NEAR(gains.interpolation, 0.4758, 1e-4);
}

TEST(SteadyStateFilter, IsTheFilterItselfOnAHandThatRests) {
  const auto noise = KalmanNoise<double>().factored();
  KalmanFilter<double> filter(noise, KalmanScheme::AuthorsFirmware);
  SteadyStateFilter<double> steady(SteadyStateFilter<double>::gainsOf(noise));
  double difference = 1.0;
  for (int i = 0; i < 300; ++i) {
    difference = filter.step(0.0, 2.0, 3.0) - steady.step(0.0, 2.0, 3.0);
  }
  EXPECT_NEAR(difference, 0.0, 1e-6);
}

}  // namespace fixed_point_test
}  // namespace haptics::models

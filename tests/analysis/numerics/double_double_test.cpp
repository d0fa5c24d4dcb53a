#include <limits>

#include <gtest/gtest.h>

#include "analysis/numerics/exact_arithmetic.h"

namespace double_double_test {

using analysis::DoubleDouble;
using analysis::toDouble;

constexpr double kTolerance = 1e-31;

TEST(DoubleDouble, HoldsASumExactly) {
  const DoubleDouble sum = DoubleDouble::sum(1e16, 1.0);
  EXPECT_EQ((sum - 1e16).high, 1.0);
  EXPECT_EQ((DoubleDouble(1e16) + 1e-8 - 1e16).high, 1e-8);
}

TEST(DoubleDouble, HoldsAProductExactly) {
  const double third = 1.0 / 3.0;
  const DoubleDouble square = DoubleDouble::product(third, third);
  EXPECT_EQ(square.high, third * third);
  // Python: float(Fraction(1/3)**2 - Fraction((1/3)*(1/3)))
  EXPECT_EQ(square.low, -6.1679056923619804e-18);
}

TEST(DoubleDouble, DividesToThirtyOneDigits) {
  const DoubleDouble third = DoubleDouble(1.0) / 3.0;
  EXPECT_NEAR((third * 3.0 - 1.0).high, 0.0, kTolerance);
  EXPECT_EQ(third.high, 1.0 / 3.0);
  EXPECT_NE(third.low, 0.0);
}

TEST(DoubleDouble, TakesRootsToThirtyOneDigits) {
  const DoubleDouble root = squareRoot(DoubleDouble(2.0));
  EXPECT_NEAR((root * root - 2.0).high, 0.0, 4.0 * kTolerance);
  EXPECT_EQ(squareRoot(DoubleDouble(0.0)).high, 0.0);
  EXPECT_EQ(squareRoot(DoubleDouble(9.0)).high, 3.0);
}

TEST(DoubleDouble, ConvertsToADoubleOnlyWithinItsRange) {
  EXPECT_EQ(toDouble(0.75, 1), 1.5);
  EXPECT_EQ(toDouble(0.0, 5000), 0.0);
  EXPECT_EQ(toDouble(0.5, -1021), std::numeric_limits<double>::min());
  EXPECT_FALSE(toDouble(0.5, -1022).has_value());
  EXPECT_FALSE(toDouble(0.5, 1025).has_value());
}

}  // namespace double_double_test

#include <cmath>
#include <cstdint>
#include <random>

#include <gtest/gtest.h>

#include "analysis/numerics/exact_arithmetic.h"

namespace exact_quotient_test {

using analysis::exactQuotient;
using analysis::Int128;

TEST(ExactQuotient, RoundsAsADoubleDivisionDoes) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 20'000; ++i) {
    // Whole numbers below 2^53 are doubles, and a processor rounds their quotient exactly.
    const auto a = random() >> (11 + random() % 50);
    const auto b = (random() >> (11 + random() % 50)) + 1;
    const auto quotient = exactQuotient(static_cast<Int128>(a), static_cast<Int128>(b));
    ASSERT_EQ(quotient.high, static_cast<double>(a) / static_cast<double>(b)) << a << " / " << b;
    ASSERT_LE(std::abs(quotient.low), std::abs(quotient.high) * 0x1p-53);
  }
}

TEST(ExactQuotient, HasMoreDigitsThanADouble) {
  const auto third = exactQuotient(1, 3);
  EXPECT_NEAR((third * 3.0 - 1.0).high, 0.0, 1e-31);
}

TEST(ExactQuotient, HasTheSignOfItsNumerator) {
  EXPECT_EQ(exactQuotient(-7, 2).high, -3.5);
  EXPECT_EQ(exactQuotient(0, 2).high, 0.0);
}

TEST(ExactQuotient, AcceptsTheLargestNumbers) {
  const Int128 wide = Int128{1} << 126;
  EXPECT_EQ(exactQuotient(wide, 1).high, 0x1p126);
  EXPECT_EQ(exactQuotient(1, wide).high, 0x1p-126);
  EXPECT_EQ(exactQuotient(wide - 1 + wide, wide).high, 2.0);
  EXPECT_NEAR(exactQuotient(wide - 1, wide).low, 0.0, 0x1p-119);
}

TEST(ExactQuotient, RoundsUpJustAboveATie) {
  // (2^53 + 1) · 2^60 lies in the middle of two doubles; one more does not.
  const Int128 middle = ((Int128{1} << 53) + 1) << 60;
  EXPECT_EQ(exactQuotient(middle, 1).high, 0x1p113);
  EXPECT_EQ(exactQuotient(middle + 1, 1).high, 0x1p113 + 0x1p61);
}

}  // namespace exact_quotient_test

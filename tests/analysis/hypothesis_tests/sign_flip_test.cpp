#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/hypothesis_tests/sign_tests.h"
#include "analysis/numerics/exact_arithmetic.h"

namespace sign_flip_test {

using analysis::commonUnitOf;
using analysis::signFlipTest;
using Values = std::vector<double>;

/// By all 2ᴺ signs, sums that differ by less than 1e-9 being equal.
double slowP(const Values& differences) {
  double observed = 0.0;
  for (const double value : differences) observed += value;
  double twoSidedByDistance = 0.0;
  const unsigned all = 1U << differences.size();
  for (unsigned choice = 0; choice < all; ++choice) {
    double sum = 0.0;
    for (std::size_t i = 0; i < differences.size(); ++i) {
      sum += (choice >> i & 1U) != 0 ? differences[i] : -differences[i];
    }
    twoSidedByDistance += std::abs(sum) >= std::abs(observed) - 1e-9 ? 1.0 : 0.0;
  }
  return twoSidedByDistance / all;
}

// Fisher 1935, The Design of Experiments, § 21: Darwin's maize, crossed − self-fertilised, in
// eighths of an inch; 1726 of 32768 sums are as far from zero.
const Values kDarwin{49, -67, 8, 16, 6, 23, 28, 41, 14, 29, 56, 24, 75, 60, -48};

TEST(SignFlipTest, IsFishersOfDarwinsMaize) {
  const auto result = signFlipTest(kDarwin);
  EXPECT_EQ(result.p, 1726.0 / 32768.0);
  EXPECT_EQ(result.pGreater, 863.0 / 32768.0);
}

TEST(SignFlipTest, IsTheSameInInches) {
  Values inches = kDarwin;
  for (double& value : inches) value /= 8.0;
  EXPECT_EQ(signFlipTest(inches).p, 1726.0 / 32768.0);
}

TEST(SignFlipTest, TreatsMeansOfThreeAsThirds) {
  const Values thirds{1.0 / 3.0, 4.0 - 11.0 / 3.0, -2.0 / 3.0, 5.0 - 13.0 / 3.0, 1.0, 1.0 / 3.0};
  EXPECT_EQ(signFlipTest(thirds).p, slowP(thirds));
}

TEST(SignFlipTest, CountsMeasuredValuesExactly) {
  const Values measured{
      0.8414709848,
      -0.7568024953,
      0.6569865987,
      0.9893582466,
      0.4121184852,
      -0.5365729180,
      0.6502878401,
      0.2879033166,
      -0.0000271000,
      0.7128130112};
  const auto result = signFlipTest(measured);
  EXPECT_FALSE(commonUnitOf(measured).has_value());
  EXPECT_EQ(result.p, slowP(measured));
  // without ties P(≥) + P(≤) = 1 + P(=), and P(=) = 2^−N
  EXPECT_EQ(result.pLess.value() + result.pGreater.value(), 1.0 + std::ldexp(1.0, -10));
}

TEST(SignFlipTest, FlipsThirtySixMeasuredValues) {
  Values many;
  for (int i = 1; i <= 36; ++i) many.push_back(std::sqrt(i));
  EXPECT_EQ(signFlipTest(many).p, std::ldexp(1.0, -35));
}

TEST(SignFlipTest, ReportsDifferencesThatItCannotFlip) {
  Values many;
  for (int i = 1; i <= 60; ++i) many.push_back(std::sqrt(i));
  EXPECT_EQ(signFlipTest(many).reason.key(), "too_many_to_flip");
  EXPECT_EQ(
      signFlipTest(Values{std::sqrt(2.0) * 1e-30, std::sqrt(3.0) * 1e100, 7e99}).reason.key(),
      "sizes_too_unlike");
}

TEST(SignFlipTest, GivesAReasonIfThereIsNoSign) {
  EXPECT_EQ(signFlipTest(Values{}).reason.key(), "no_differences");
  EXPECT_EQ(signFlipTest(Values{0.0, 0.0}).reason.key(), "no_sign_to_flip");
  EXPECT_EQ(signFlipTest(Values{-3.0}).p, 1.0);
  EXPECT_EQ(signFlipTest(Values{-3.0}).pLess, 0.5);
  EXPECT_THROW(signFlipTest(Values{std::nan("")}), std::invalid_argument);
}

TEST(CommonUnit, IsTheSmallestThatFits) {
  EXPECT_EQ(commonUnitOf(Values{1.5, 2.0, -0.25}).value().denominator, 4);
  EXPECT_EQ(
      commonUnitOf(Values{0.1 + 0.2, -0.3}).value().multiples, (std::vector<std::int64_t>{3, -3}));
  EXPECT_FALSE(commonUnitOf(Values{std::sqrt(2.0)}).has_value());
  EXPECT_FALSE(commonUnitOf(Values{1e-200, 2e-200}).has_value());
}

TEST(CommonUnit, RestoresTiesLostByRounding) {
  const auto cleaned = analysis::withoutRoundingNoise(Values{0.1 + 0.2, 0.3, 4.0 / 3.0});
  EXPECT_EQ(cleaned[0], cleaned[1]);
  EXPECT_EQ(cleaned[2], 4.0 / 3.0);
  const Values measured{std::sqrt(2.0), std::sqrt(3.0)};
  EXPECT_EQ(analysis::withoutRoundingNoise(measured), measured);
}

}  // namespace sign_flip_test

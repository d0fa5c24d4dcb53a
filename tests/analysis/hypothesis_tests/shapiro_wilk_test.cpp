#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/hypothesis_tests/assumptions.h"
#include "tests/analysis/digits.h"

namespace shapiro_wilk_test {

using analysis::shapiroWilkTest;
using tests::correctDigits;
using Values = std::vector<double>;

// The weights of eleven men, the example of Shapiro & Wilk 1965.
const Values kWeights{148, 154, 158, 160, 161, 162, 166, 170, 182, 195, 236};

// R: mtcars$mpg
const Values kMilesPerGallon{21.0, 21.0, 22.8, 21.4, 18.7, 18.1, 14.3, 24.4, 22.8, 19.2, 17.8,
                             16.4, 17.3, 15.2, 10.4, 10.4, 14.7, 32.4, 30.4, 33.9, 21.5, 15.5,
                             15.2, 13.3, 19.2, 27.3, 26.0, 30.4, 15.8, 19.7, 15.0, 21.4};

TEST(ShapiroWilk, IsThatOfR) {
  // R: shapiro.test(mtcars$mpg)
  const auto miles = shapiroWilkTest(kMilesPerGallon);
  EXPECT_NEAR(miles.w.value(), 0.94756, 5e-6);
  EXPECT_NEAR(miles.p.value(), 0.1229, 5e-5);
  EXPECT_EQ(miles.n, 32U);

  // scipy.stats.shapiro
  const auto weights = shapiroWilkTest(kWeights);
  EXPECT_NEAR(weights.w.value(), 0.788815, 5e-7);
  EXPECT_NEAR(weights.p.value(), 0.00670381, 5e-9);
}

TEST(ShapiroWilk, HasAllDigitsOfItsFormulas) {
  // mpmath, 40 digits, the same formulas
  struct Known {
    Values values;
    const char* w;
    const char* p;
  };
  const Known known[] = {
      {{1, 2, 3, 5}, "0.97137366548270614", "0.84997081884826599"},
      {{1, 2, 4, 5, 9}, "0.9406192331534155", "0.67031956181788888"},
      {kWeights, "0.78881469483538743", "0.0067038140565030117"},
      {kMilesPerGallon, "0.94756472647927391", "0.12288135853944067"}};
  for (const auto& [values, w, p] : known) {
    EXPECT_GE(correctDigits(shapiroWilkTest(values).w.value(), w), 14.0) << values.size();
    EXPECT_GE(correctDigits(shapiroWilkTest(values).p.value(), p), 12.0) << values.size();
  }
}

TEST(ShapiroWilk, IsExactForThreeValues) {
  // evenly spaced: W = 1 and p = 1; two alike: W = 3/4, the least there is, and p = 0
  EXPECT_NEAR(shapiroWilkTest(Values{1, 2, 3}).w.value(), 1.0, 1e-15);
  EXPECT_NEAR(shapiroWilkTest(Values{1, 2, 3}).p.value(), 1.0, 1e-7);
  EXPECT_NEAR(shapiroWilkTest(Values{1, 1, 3}).w.value(), 0.75, 1e-15);
  EXPECT_NEAR(shapiroWilkTest(Values{1, 1, 3}).p.value(), 0.0, 1e-7);
  // 0, 1, 3: W = (3/√2)² / (14/3) = 27/28
  const auto uneven = shapiroWilkTest(Values{0, 1, 3});
  EXPECT_NEAR(uneven.w.value(), 27.0 / 28.0, 1e-15);
  EXPECT_NEAR(
      uneven.p.value(),
      6.0 / std::numbers::pi * (std::asin(std::sqrt(27.0 / 28.0)) - std::numbers::pi / 3.0),
      1e-14);
}

TEST(ShapiroWilk, DoesNotDependOnUnitsOrOrder) {
  Values moved;
  for (auto value = kWeights.rbegin(); value != kWeights.rend(); ++value) {
    moved.push_back(-1e6 + 0.25 * *value);
  }
  Values huge;
  for (const double value : kWeights) huge.push_back((value - 200.0) * 3e306);
  const auto plain = shapiroWilkTest(kWeights);

  EXPECT_NEAR(shapiroWilkTest(moved).w.value(), plain.w.value(), 1e-14);
  EXPECT_NEAR(shapiroWilkTest(huge).w.value(), plain.w.value(), 1e-14);
}

TEST(ShapiroWilk, RejectsABimodalSampleAndAcceptsNormalQuantiles) {
  Values heaps;
  for (int i = 0; i < 50; ++i) heaps.push_back(i < 25 ? 1.0 : 5.0);
  EXPECT_LT(shapiroWilkTest(heaps).p.value(), 1e-6);

  Values logistic;  // close to normal: ln(u / (1 − u)) of even u
  for (int i = 1; i < 30; ++i) logistic.push_back(std::log(i / (30.0 - i)));
  EXPECT_GT(shapiroWilkTest(logistic).p.value(), 0.5);
}

TEST(ShapiroWilk, IsUndefinedOutsideItsRange) {
  EXPECT_FALSE(shapiroWilkTest(Values{}).w.has_value());
  EXPECT_EQ(shapiroWilkTest(Values{1, 2}).reason.key(), "three_to_5000_values");
  Values many;
  for (int i = 0; i < 5001; ++i) many.push_back(i);
  EXPECT_FALSE(shapiroWilkTest(many).w.has_value());
  many.pop_back();
  EXPECT_TRUE(shapiroWilkTest(many).p.has_value());

  EXPECT_EQ(shapiroWilkTest(Values{4, 4, 4, 4}).reason.key(), "no_shape");
  EXPECT_THROW(shapiroWilkTest(Values{1, 2, NAN}), std::invalid_argument);
}

}  // namespace shapiro_wilk_test

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "analysis/hypothesis_tests/t_tests.h"
#include "tests/analysis/digits.h"

namespace welch_test {

using analysis::confidenceInterval;
using analysis::LikertCounts;
using analysis::welchTTest;
using Values = std::vector<double>;
using Counts = std::vector<std::uint64_t>;

// R: sleep (Cushny & Peebles 1905)
const Values kSleep1{0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7, 0.8, 0.0, 2.0};
const Values kSleep2{1.9, 0.8, 1.1, 0.1, -0.1, 4.4, 5.5, 1.6, 4.6, 3.4};

Values shifted(Values values, double by) {
  for (double& value : values) value += by;
  return values;
}

Values stretched(Values values, double by) {
  for (double& value : values) value *= by;
  return values;
}

TEST(WelchTest, IsThatOfR) {
  // R: t.test(extra ~ group, data = sleep)
  const auto result = welchTTest(kSleep1, kSleep2);
  const auto interval = confidenceInterval(result, 0.95).value();

  EXPECT_NEAR(result.t.value(), -1.8608, 5e-5);
  EXPECT_NEAR(result.degreesOfFreedom.value(), 17.776, 5e-4);
  EXPECT_NEAR(result.p.value(), 0.07939414018735818, 1e-15);
  EXPECT_NEAR(interval.low, -3.3654832, 5e-8);
  EXPECT_NEAR(interval.high, 0.2054832, 5e-8);
  EXPECT_NEAR(result.mean1.value(), 0.75, 1e-15);
  EXPECT_NEAR(result.mean2.value(), 2.33, 1e-15);
  EXPECT_EQ(result.reason.key(), "");
}

TEST(WelchTest, IsThatOfRosettaCode) {
  // rosettacode.org, "Welch's t-test": d3 and d4, d5 and d6, d7 and d8, x and y
  EXPECT_NEAR(
      welchTTest(
          Values{17.2, 20.9, 22.6, 18.1, 21.7, 21.4, 23.5, 24.2, 14.7, 21.8},
          Values{21.5, 22.8, 21.0, 23.0, 21.6, 23.6, 22.5, 20.7, 23.4, 21.8,
                 20.7, 21.7, 21.5, 22.5, 23.6, 21.5, 22.5, 23.5, 21.5, 21.8})
          .p.value(),
      0.148841696605327,
      1e-14);
  EXPECT_NEAR(
      welchTTest(
          Values{19.8, 20.4, 19.6, 17.8, 18.5, 18.9, 18.3, 18.9, 19.5, 22.0},
          Values{28.2, 26.6, 20.1, 23.3, 25.2, 22.1, 17.7, 27.6, 20.6, 13.7,
                 23.2, 17.5, 20.6, 18.0, 23.9, 21.6, 24.3, 20.4, 24.0, 13.2})
          .p.value(),
      0.0359722710297968,
      1e-14);
  EXPECT_NEAR(
      welchTTest(
          Values{30.02, 29.99, 30.11, 29.97, 30.01, 29.99},
          Values{29.89, 29.93, 29.72, 29.98, 30.02, 29.98})
          .p.value(),
      0.090773324285671,
      1e-14);
  EXPECT_NEAR(
      welchTTest(Values{3.0, 4.0, 1.0, 2.1}, Values{490.2, 340.0, 433.9}).p.value(),
      0.010751561149785,
      1e-14);
}

TEST(WelchTest, HasAClosedFormForTwoAgainstTwo) {
  // Equal variances: df = 2, P(|T| ≥ t) = 1 − t / √(2 + t²), t = 3 √2.
  const auto result = welchTTest(Values{5.0, 4.0}, Values{1.0, 2.0});

  EXPECT_DOUBLE_EQ(result.t.value(), 3.0 * std::sqrt(2.0));
  EXPECT_EQ(result.degreesOfFreedom, 2.0);
  EXPECT_NEAR(result.p.value(), 1.0 - std::sqrt(18.0 / 20.0), 1e-16);
}

TEST(WelchTest, ChangesOnlyItsSignIfTheGroupsAreSwapped) {
  const auto forth = welchTTest(kSleep1, kSleep2);
  const auto back = welchTTest(kSleep2, kSleep1);

  EXPECT_EQ(back.t.value(), -forth.t.value());
  EXPECT_EQ(back.difference.value(), -forth.difference.value());
  EXPECT_EQ(back.degreesOfFreedom, forth.degreesOfFreedom);
  EXPECT_EQ(back.p, forth.p);
  EXPECT_EQ(back.pLess, forth.pGreater);
  EXPECT_EQ(back.pGreater, forth.pLess);
}

TEST(WelchTest, DoesNotDependOnAnOffset) {
  // Halves and quarters survive an offset of 1e9 unrounded.
  const Values a{0.5, 1.75, 4.0, 2.25};
  const Values b{-1.0, 0.25, 0.5};
  const auto here = welchTTest(a, b);
  for (const double offset : {1e9, -1e9, 3e14}) {
    const auto there = welchTTest(shifted(a, offset), shifted(b, offset));
    EXPECT_EQ(there.t, here.t);
    EXPECT_EQ(there.degreesOfFreedom, here.degreesOfFreedom);
    EXPECT_EQ(there.difference, here.difference);
    EXPECT_EQ(there.p, here.p);
  }
}

TEST(WelchTest, DoesNotDependOnTheUnit) {
  const auto here = welchTTest(kSleep1, kSleep2);
  for (const double unit : {0x1p-700, 0x1p-40, 0x1p3, 0x1p900}) {
    const auto there = welchTTest(stretched(kSleep1, unit), stretched(kSleep2, unit));
    EXPECT_EQ(there.t, here.t);
    EXPECT_EQ(there.p, here.p);
    EXPECT_EQ(there.standardError.value(), here.standardError.value() * unit);
  }
}

TEST(WelchTest, ComputesTheDifferenceBeforeRoundingTheMeans) {
  const auto result =
      welchTTest(Values{1e15, 1e15, 1e15 + 1}, Values{1e15, 1e15, 1e15, 1e15, 1e15 + 1});
  EXPECT_DOUBLE_EQ(result.difference.value(), 1.0 / 3.0 - 1.0 / 5.0);
}

TEST(WelchTest, IsTheSameFromCountsAndFromValues) {
  const LikertCounts a(1, Counts{0, 1, 0, 2, 1});
  const LikertCounts b(1, Counts{2, 0, 1, 0, 0});
  const auto fromCounts = welchTTest(momentsOf(a), momentsOf(b));
  const auto fromValues = welchTTest(Values{4.0, 2.0, 5.0, 4.0}, Values{1.0, 3.0, 1.0});

  EXPECT_EQ(fromCounts.t, fromValues.t);
  EXPECT_EQ(fromCounts.degreesOfFreedom, fromValues.degreesOfFreedom);
  EXPECT_EQ(fromCounts.p, fromValues.p);
  EXPECT_EQ(fromCounts.variance2, 4.0 / 3.0);
}

TEST(WelchTest, SplitsItsPIntoTwoTails) {
  const auto result = welchTTest(kSleep1, kSleep2);
  EXPECT_DOUBLE_EQ(result.pLess.value(), result.p.value() / 2.0);
  EXPECT_DOUBLE_EQ(result.pLess.value() + result.pGreater.value(), 1.0);
}

TEST(WelchTest, FindsNoDifferenceBetweenEqualGroups) {
  const auto result = welchTTest(kSleep1, kSleep1);
  EXPECT_EQ(result.t, 0.0);
  EXPECT_EQ(result.p, 1.0);
  EXPECT_EQ(result.log10P, 0.0);
  EXPECT_EQ(result.pLess, 0.5);
  EXPECT_EQ(result.pGreater, 0.5);
}

TEST(WelchTest, HasALogarithmOfPBeyondADouble) {
  // Python: mpmath with 50 digits, as in student_distribution_test.cpp: p = 1.33e-2001
  const LikertCounts a(1, Counts{0, 0, 0, 1000, 1000});
  const LikertCounts b(1, Counts{1000, 1000, 0, 0, 0});
  const auto result = welchTTest(momentsOf(a), momentsOf(b));

  EXPECT_EQ(result.p, 0.0);
  EXPECT_GE(tests::correctDigits(result.log10P.value(), "-2000.8761418080075814"), 14.0);
  EXPECT_EQ(result.reason.key(), "");
}

TEST(WelchTest, RefusesNaNAndInfinity) {
  EXPECT_THROW(welchTTest(Values{1.0, std::nan("")}, kSleep2), std::invalid_argument);
}

TEST(ConfidenceInterval, IsWiderForMoreConfidence) {
  const auto result = welchTTest(kSleep1, kSleep2);
  const auto usual = confidenceInterval(result, 0.95).value();
  const auto strict = confidenceInterval(result, 1.0 - 0.05 / 3.0).value();

  EXPECT_LT(strict.low, usual.low);
  EXPECT_GT(strict.high, usual.high);
  EXPECT_DOUBLE_EQ((usual.low + usual.high) / 2.0, result.difference.value());
}

TEST(ConfidenceInterval, EndsAtZeroWhereItsLevelIsOneMinusP) {
  const auto result = welchTTest(kSleep1, kSleep2);
  EXPECT_NEAR(confidenceInterval(result, 1.0 - result.p.value()).value().high, 0.0, 1e-13);
}

TEST(ConfidenceInterval, RefusesInvalidLevels) {
  const auto result = welchTTest(kSleep1, kSleep2);
  for (const double level : {0.0, 1.0, 95.0, -0.5, std::nan("")}) {
    EXPECT_THROW(confidenceInterval(result, level), std::invalid_argument) << level;
  }
}

}  // namespace welch_test

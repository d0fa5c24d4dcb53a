// Welch's test where something is missing: too few values, constant groups, numbers beyond a
// double.
#include <cmath>

#include <gtest/gtest.h>

#include "analysis/hypothesis_tests/t_tests.h"

namespace welch_undefined_test {

using analysis::confidenceInterval;
using analysis::welchTTest;
using Values = std::vector<double>;

// R: sleep (Cushny & Peebles 1905)
const Values kSleep1{0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7, 0.8, 0.0, 2.0};
const Values kSleep2{1.9, 0.8, 1.1, 0.1, -0.1, 4.4, 5.5, 1.6, 4.6, 3.4};

Values stretched(Values values, double by) {
  for (double& value : values) value *= by;
  return values;
}

TEST(WelchTest, IsUndefinedForFewerThanTwo) {
  const auto none = welchTTest(Values{}, kSleep2);
  const auto one = welchTTest(kSleep1, Values{4.0});

  EXPECT_EQ(none.reason.key(), "group_empty_needs_two");
  EXPECT_FALSE(none.difference.has_value());
  EXPECT_EQ(one.reason.key(), "group_of_one_needs_two");
  EXPECT_EQ(one.mean2, 4.0);
  EXPECT_DOUBLE_EQ(one.difference.value(), -3.25);
  EXPECT_FALSE(one.variance2.has_value());
  EXPECT_FALSE(one.t.has_value());
  EXPECT_FALSE(one.p.has_value());
}

TEST(WelchTest, IsUndefinedForEqualConstantGroups) {
  const auto result = welchTTest(Values{6.0, 6.0, 6.0}, Values{6.0, 6.0});

  EXPECT_EQ(result.reason.key(), "constant_equal");
  EXPECT_EQ(result.difference, 0.0);
  EXPECT_EQ(result.standardError, 0.0);
  EXPECT_FALSE(result.t.has_value());
  EXPECT_FALSE(result.degreesOfFreedom.has_value());
  EXPECT_FALSE(result.p.has_value());
}

TEST(WelchTest, HasAnInfiniteTForDifferentConstantGroups) {
  const auto result = welchTTest(Values{1.0, 1.0}, Values{5.0, 5.0, 5.0});

  EXPECT_EQ(result.reason.key(), "constant_differ");
  EXPECT_EQ(result.t, -INFINITY);
  EXPECT_FALSE(result.p.has_value());
  EXPECT_FALSE(result.log10P.has_value());
  EXPECT_FALSE(confidenceInterval(result, 0.95).has_value());
}

TEST(WelchTest, IsAnOrdinaryTestIfOnlyOneGroupIsConstant) {
  const auto result = welchTTest(Values{5.0, 5.0, 5.0}, Values{1.0, 3.0, 2.0});
  EXPECT_EQ(result.degreesOfFreedom, 2.0);
  EXPECT_DOUBLE_EQ(result.t.value(), 3.0 * std::sqrt(3.0));
  EXPECT_EQ(result.reason.key(), "");
}

TEST(WelchTest, IsDefinedWhereTheVarianceIsBeyondADouble) {
  for (const double unit : {1e-200, 1e200}) {
    const auto result = welchTTest(stretched(kSleep1, unit), stretched(kSleep2, unit));
    EXPECT_FALSE(result.variance1.has_value());
    EXPECT_NEAR(result.p.value(), 0.07939414018735818, 1e-14);
    EXPECT_TRUE(confidenceInterval(result, 0.95).has_value());
    EXPECT_EQ(result.reason.key(), "variance_beyond_double");
  }
}

TEST(WelchTest, IsDefinedWhereTheDifferenceIsBeyondADouble) {
  const double unit = 1.7e308;
  const auto result =
      welchTTest(Values{unit, 0.9 * unit, unit}, Values{-unit, -0.9 * unit, -0.8 * unit});
  EXPECT_FALSE(result.difference.has_value());
  EXPECT_FALSE(confidenceInterval(result, 0.95).has_value());
  // R: t.test(c(1, .9, 1), c(-1, -.9, -.8))
  EXPECT_NEAR(result.t.value(), 28.0, 1e-12);
  EXPECT_FALSE(result.reason.empty());
}

TEST(WelchTest, GivesAReasonForAnInfiniteT) {
  const auto result = welchTTest(Values{1e200, 1e200}, Values{1e-200, 2e-200});
  EXPECT_EQ(result.t, INFINITY);
  EXPECT_FALSE(result.p.has_value());
  EXPECT_EQ(result.reason.key(), "t_too_large");
}

TEST(WelchTest, KeepsItsDigitsIfAConstantGroupIsFarAway) {
  // df = 2: P(|T| ≥ t) = 2 / (√(2 + t²) (√(2 + t²) + t)) → 1/t² for t → ∞
  const auto result = welchTTest(Values{1e120, 1e120, 1e120}, Values{1.0, 2.0, 3.5});
  EXPECT_EQ(result.degreesOfFreedom, 2.0);
  EXPECT_NEAR(result.p.value() * result.t.value() * result.t.value(), 1.0, 1e-12);
}

}  // namespace welch_undefined_test

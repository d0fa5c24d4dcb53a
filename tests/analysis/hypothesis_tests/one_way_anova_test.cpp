#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "analysis/hypothesis_tests/anova.h"
#include "analysis/hypothesis_tests/t_tests.h"

namespace one_way_anova_test {

using analysis::oneWayAnova;
using Groups = std::vector<std::vector<double>>;

TEST(OneWayAnova, FollowsFromItsSquares) {
  // means 2, 3, 7 about 4: 3 · (4 + 1 + 9) = 42 between, 2 + 2 + 2 = 6 within; F = 21 / 1
  const auto result = oneWayAnova(Groups{{1, 2, 3}, {2, 3, 4}, {6, 7, 8}});

  EXPECT_DOUBLE_EQ(result.squaresBetween.value(), 42.0);
  EXPECT_DOUBLE_EQ(result.squaresWithin.value(), 6.0);
  EXPECT_DOUBLE_EQ(result.f.value(), 21.0);
  EXPECT_EQ(result.degreesOfFreedom1, 2.0);
  EXPECT_EQ(result.degreesOfFreedom2, 6.0);
  EXPECT_DOUBLE_EQ(result.rSquared.value(), 0.875);
  EXPECT_DOUBLE_EQ(result.residualStandardDeviation.value(), 1.0);
  // P(F ≥ f) with 2 and 6 degrees of freedom is (1 + f/3)⁻³
  EXPECT_DOUBLE_EQ(result.p.value(), 1.0 / 512.0);
  EXPECT_TRUE(result.reason.empty());
}

TEST(OneWayAnova, OfTwoGroupsIsStudentsTest) {
  const Groups groups{{0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7}, {1.9, 0.8, 1.1, 0.1}};
  const auto anova = oneWayAnova(groups);
  const auto student = analysis::studentTTest(groups[0], groups[1]);

  EXPECT_NEAR(anova.f.value(), *student.t * *student.t, 1e-14);
  EXPECT_NEAR(anova.p.value(), *student.p, 1e-14);
}

TEST(OneWayAnova, DoesNotDependOnOffsetsOrTinyScales) {
  const auto plain = oneWayAnova(Groups{{1, 2, 3}, {2, 3, 4}, {6, 7, 9}});
  const auto offset = oneWayAnova(Groups{
      {1e15 + 1, 1e15 + 2, 1e15 + 3},
      {1e15 + 2, 1e15 + 3, 1e15 + 4},
      {1e15 + 6, 1e15 + 7, 1e15 + 9}});
  const auto tiny = oneWayAnova(
      Groups{{1e-200, 2e-200, 3e-200}, {2e-200, 3e-200, 4e-200}, {6e-200, 7e-200, 9e-200}});

  EXPECT_DOUBLE_EQ(offset.f.value(), plain.f.value());
  EXPECT_NEAR(tiny.f.value(), plain.f.value(), 1e-13);
  EXPECT_FALSE(tiny.squaresWithin.has_value());
  EXPECT_FALSE(tiny.reason.empty());
}

TEST(OneWayAnova, HasALogarithmOfPBeyondADouble) {
  std::vector<double> low(300, 0.0);
  std::vector<double> high(300, 1e6);
  low[0] = 1.0;
  high[0] = 1e6 + 1.0;
  const auto result = oneWayAnova(Groups{low, high});

  EXPECT_EQ(result.p, 0.0);
  EXPECT_LT(result.log10P.value(), -2000.0);
}

TEST(OneWayAnova, GivesAReasonIfItIsUndefined) {
  EXPECT_EQ(oneWayAnova(Groups{}).reason.key(), "two_groups_needed");
  EXPECT_EQ(oneWayAnova(Groups{{1, 2, 3}}).reason.key(), "two_groups_needed");
  EXPECT_EQ(oneWayAnova(Groups{{1, 2, 3}, {}}).reason.key(), "a_group_is_empty");
  EXPECT_FALSE(oneWayAnova(Groups{{1}, {2}}).reason.empty());
  EXPECT_FALSE(oneWayAnova(Groups{{1}, {2}}).f.has_value());

  const auto constant = oneWayAnova(Groups{{1, 1}, {2, 2, 2}});
  EXPECT_EQ(constant.f, INFINITY);
  EXPECT_FALSE(constant.p.has_value());
  EXPECT_EQ(constant.rSquared, 1.0);

  const auto same = oneWayAnova(Groups{{2, 2}, {2, 2, 2}});
  EXPECT_FALSE(same.f.has_value());
  EXPECT_EQ(same.reason.key(), "all_values_same");
  EXPECT_THROW(oneWayAnova(Groups{{1, NAN}, {2, 3}}), std::invalid_argument);
}

}  // namespace one_way_anova_test

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "analysis/hypothesis_tests/assumptions.h"

namespace brown_forsythe_test {

using analysis::brownForsytheTest;
using Groups = std::vector<std::vector<double>>;

TEST(BrownForsythe, IsThatOfCar) {
  // R: car::leveneTest(count ~ spray, InsectSprays): F = 3.8214, Pr = 0.004223, df 5 and 66
  const Groups sprays{
      {10, 7, 20, 14, 14, 12, 10, 23, 17, 20, 14, 13},
      {11, 17, 21, 11, 16, 14, 17, 17, 19, 21, 7, 13},
      {0, 1, 7, 2, 3, 1, 2, 1, 3, 0, 1, 4},
      {3, 5, 12, 6, 4, 3, 5, 5, 5, 5, 2, 4},
      {3, 5, 3, 5, 3, 6, 1, 1, 3, 2, 6, 4},
      {11, 9, 15, 22, 15, 16, 13, 10, 26, 26, 24, 13}};
  const auto result = brownForsytheTest(sprays);

  EXPECT_NEAR(result.f.value(), 3.8214, 5e-5);
  EXPECT_NEAR(result.p.value(), 0.004223, 5e-7);
  EXPECT_EQ(result.degreesOfFreedom1, 5.0);
  EXPECT_EQ(result.degreesOfFreedom2, 66.0);
}

TEST(BrownForsythe, IsTheAnalysisOfVarianceOfTheDeviations) {
  // medians 2 and 4.5: deviations 1 0 2 and 3.5 0.5 0.5 4.5; means 1 and 2.25
  const auto result = brownForsytheTest(Groups{{1, 2, 4}, {1, 4, 5, 9}});

  // between: 12/7 · 1.25²; within: 2 + (1.5625 + 3.0625 + 3.0625 + 5.0625) = 14.75
  EXPECT_DOUBLE_EQ(result.f.value(), 12.0 / 7.0 * 1.5625 / (14.75 / 5.0));
}

TEST(BrownForsythe, DoesNotDependOnTheLocationOfTheGroups) {
  const auto here = brownForsytheTest(Groups{{1, 2, 4}, {1, 4, 5, 9}});
  const auto there = brownForsytheTest(Groups{{101, 102, 104}, {-8, -5, -4, 0}});
  EXPECT_DOUBLE_EQ(here.f.value(), there.f.value());

  const auto huge = brownForsytheTest(Groups{{-1.5e308, 0, 1.5e308}, {-1e308, 0, 1e308}});
  EXPECT_TRUE(std::isfinite(huge.f.value()));
}

TEST(BrownForsythe, GivesAReasonIfItIsUndefined) {
  const auto constant = brownForsytheTest(Groups{{1, 1, 1}, {2, 2}});
  EXPECT_FALSE(constant.f.has_value());
  EXPECT_FALSE(constant.reason.empty());

  const auto twoValued = brownForsytheTest(Groups{{1, 3}, {2, 8}});
  EXPECT_EQ(twoValued.f, INFINITY);
  EXPECT_FALSE(twoValued.p.has_value());
  EXPECT_FALSE(twoValued.reason.empty());

  EXPECT_EQ(brownForsytheTest(Groups{{1, 2}, {}}).reason.key(), "a_group_is_empty");
  EXPECT_EQ(brownForsytheTest(Groups{{1, 2}}).reason.key(), "two_groups_needed");
  EXPECT_THROW(brownForsytheTest(Groups{{1, INFINITY}, {1, 2}}), std::invalid_argument);
}

}  // namespace brown_forsythe_test

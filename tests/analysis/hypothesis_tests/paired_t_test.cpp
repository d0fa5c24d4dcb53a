#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/hypothesis_tests/t_tests.h"

namespace paired_t_test {

using analysis::pairedTTest;
using Values = std::vector<double>;

// R: sleep (Cushny & Peebles 1905), the same ten people with both drugs
const Values kSleep1{0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7, 0.8, 0.0, 2.0};
const Values kSleep2{1.9, 0.8, 1.1, 0.1, -0.1, 4.4, 5.5, 1.6, 4.6, 3.4};

TEST(PairedT, IsThatOfStudentsOwnData) {
  // R: t.test(sleep$extra[1:10], sleep$extra[11:20], paired = TRUE)
  const auto result = pairedTTest(kSleep1, kSleep2);
  const auto interval = confidenceInterval(result, 0.95).value();

  EXPECT_NEAR(result.t.value(), -4.0621, 5e-5);
  EXPECT_EQ(result.degreesOfFreedom, 9.0);
  EXPECT_NEAR(result.p.value(), 0.002833, 5e-7);
  EXPECT_NEAR(interval.low, -2.4598858, 5e-8);
  EXPECT_NEAR(interval.high, -0.7001142, 5e-8);
  EXPECT_TRUE(result.reason.empty());
}

TEST(PairedT, ChangesItsSignWithTheOrder) {
  const auto there = pairedTTest(kSleep1, kSleep2);
  const auto back = pairedTTest(kSleep2, kSleep1);

  EXPECT_EQ(there.t.value(), -back.t.value());
  EXPECT_EQ(there.p, back.p);
  EXPECT_EQ(there.pLess, back.pGreater);
}

TEST(PairedT, HasALogarithmOfPBeyondADouble) {
  Values x;
  Values y;
  for (int i = 0; i < 200; ++i) {
    x.push_back(1000.0 + 0.001 * (i % 2));
    y.push_back(0.0);
  }
  const auto result = pairedTTest(x, y);

  EXPECT_EQ(result.p, 0.0);
  EXPECT_LT(result.log10P.value(), -1000.0);
  EXPECT_TRUE(std::isfinite(result.log10P.value()));
}

TEST(PairedT, IsUndefinedWithoutSpread) {
  const auto shifted = pairedTTest(Values{5.0, 4.0, 3.0}, Values{4.0, 3.0, 2.0});
  EXPECT_EQ(shifted.t, INFINITY);
  EXPECT_FALSE(shifted.p.has_value());
  EXPECT_FALSE(confidenceInterval(shifted, 0.95).has_value());
  EXPECT_EQ(shifted.reason.key(), "differences_same");

  const auto equal = pairedTTest(kSleep1, kSleep1);
  EXPECT_FALSE(equal.t.has_value());
  EXPECT_EQ(equal.meanDifference, 0.0);
  EXPECT_EQ(equal.reason.key(), "pairs_equal");
}

TEST(PairedT, IsUndefinedWhereOnlyRoundingErrorsDiffer) {
  const auto shifted = pairedTTest(Values{0.3, 0.6, 1.1, 2.3}, Values{0.1, 0.4, 0.9, 2.1});
  EXPECT_EQ(shifted.t, INFINITY);
  EXPECT_EQ(shifted.variance, 0.0);
  EXPECT_FALSE(shifted.p.has_value());
  EXPECT_EQ(shifted.reason.key(), "differences_same");
  EXPECT_FALSE(equivalenceTest(shifted, {.lower = -0.2, .upper = 0.2}).p.has_value());

  const auto equal = pairedTTest(Values{0.1 + 0.2, 0.7}, Values{0.3, 0.8 - 0.1});
  EXPECT_FALSE(equal.t.has_value());
  EXPECT_EQ(equal.meanDifference, 0.0);
  EXPECT_EQ(equal.reason.key(), "pairs_equal");

  EXPECT_TRUE(pairedTTest(Values{1.0, 1.0 + 1e-14}, Values{0.0, 0.0}).p.has_value());
}

TEST(PairedT, IsUndefinedForFewerThanTwoPairs) {
  EXPECT_EQ(pairedTTest(Values{}, Values{}).reason.key(), "no_pairs");
  const auto one = pairedTTest(Values{2.0}, Values{1.0});
  EXPECT_EQ(one.meanDifference, 1.0);
  EXPECT_FALSE(one.variance.has_value());
  EXPECT_FALSE(one.t.has_value());
  EXPECT_EQ(one.reason.key(), "one_pair");
}

TEST(PairedT, IsDefinedIfTheVarianceIsBeyondADouble) {
  // t as of 1, 2, 4 against 0: mean 7/3, variance 7/3
  const auto tiny = pairedTTest(Values{1e-200, 2e-200, 4e-200}, Values{0.0, 0.0, 0.0});
  EXPECT_FALSE(tiny.variance.has_value());
  EXPECT_NEAR(tiny.t.value(), std::sqrt(7.0), 1e-14);
  EXPECT_FALSE(tiny.reason.empty());

  const auto huge = pairedTTest(Values{1e308, 1.0}, Values{-1e308, 0.0});
  EXPECT_FALSE(huge.t.has_value());
  EXPECT_EQ(huge.reason.key(), "difference_beyond_double");
}

TEST(PairedT, RefusesListsOfDifferentLength) {
  EXPECT_THROW(pairedTTest(Values{1.0, 2.0}, Values{1.0}), std::invalid_argument);
  EXPECT_THROW(pairedTTest(Values{1.0, NAN}, Values{1.0, 2.0}), std::invalid_argument);
  EXPECT_THROW(confidenceInterval(pairedTTest(kSleep1, kSleep2), 1.0), std::invalid_argument);
}

}  // namespace paired_t_test

#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/hypothesis_tests/t_tests.h"

namespace equivalence_test {

using analysis::equivalenceTest;
using Values = std::vector<double>;

const Values kA{3.1, 4.0, 2.8, 3.6, 3.3, 4.2, 3.0};
const Values kB{3.0, 4.1, 3.1, 3.4, 3.6, 3.9};

TEST(Equivalence, AgreesWithTheIntervalAtOneMinusTwoAlpha) {
  const auto welch = analysis::welchTTest(kA, kB);
  const auto interval = confidenceInterval(welch, 0.9).value();

  // The bounds that touch the interval have p = α exactly.
  const auto touching = equivalenceTest(welch, {.lower = interval.low, .upper = interval.high});
  EXPECT_NEAR(touching.aboveLower->p, 0.05, 1e-13);
  EXPECT_NEAR(touching.belowUpper->p, 0.05, 1e-13);
  EXPECT_LT(equivalenceTest(welch, {.lower = -2.0, .upper = 2.0}).p.value(), 0.05);
  EXPECT_GT(equivalenceTest(welch, {.lower = -0.1, .upper = 0.1}).p.value(), 0.05);
}

TEST(Equivalence, OfPairsAgreesWithTheirInterval) {
  const auto paired = analysis::pairedTTest(Values(kA.begin(), kA.begin() + 6), kB);
  const auto interval = confidenceInterval(paired, 0.9).value();

  const auto result = equivalenceTest(paired, {.lower = interval.low, .upper = 5.0});
  EXPECT_NEAR(result.p.value(), 0.05, 1e-13);
  EXPECT_EQ(result.p, result.aboveLower->p);
  EXPECT_LT(result.belowUpper->p, 1e-4);
}

TEST(Equivalence, MayHaveBoundsThatAreNotSymmetric) {
  const auto welch = analysis::welchTTest(kA, kB);
  const auto result = equivalenceTest(welch, {.lower = -3.0, .upper = 0.5});

  EXPECT_DOUBLE_EQ(result.aboveLower->t, (*welch.difference + 3.0) / *welch.standardError);
  EXPECT_DOUBLE_EQ(result.belowUpper->t, (*welch.difference - 0.5) / *welch.standardError);
  EXPECT_EQ(result.p, result.belowUpper->p);
}

TEST(Equivalence, CannotBeFoundOutsideTheBounds) {
  const auto welch = analysis::welchTTest(Values{8.0, 9.0, 10.0}, Values{1.0, 2.0, 3.0});
  const auto result = equivalenceTest(welch, {.lower = -1.0, .upper = 1.0});

  EXPECT_GT(result.p.value(), 0.5);
  EXPECT_NEAR(result.log10P.value(), std::log10(*result.p), 1e-15);
}

TEST(Equivalence, IsUndefinedIfTheTestIs) {
  const auto welch = analysis::welchTTest(Values{4.0, 4.0}, Values{4.0, 4.0});
  const auto result = equivalenceTest(welch, {.lower = -1.0, .upper = 1.0});
  EXPECT_FALSE(result.p.has_value());
  EXPECT_EQ(result.reason, welch.reason);

  const auto paired = analysis::pairedTTest(Values{4.0}, Values{4.0});
  EXPECT_EQ(equivalenceTest(paired, {.lower = -1.0, .upper = 1.0}).reason, paired.reason);
}

TEST(Equivalence, RefusesInvalidBounds) {
  const auto welch = analysis::welchTTest(kA, kB);
  EXPECT_THROW(equivalenceTest(welch, {.lower = 1.0, .upper = -1.0}), std::invalid_argument);
  EXPECT_THROW(equivalenceTest(welch, {.lower = 0.5, .upper = 0.5}), std::invalid_argument);
  EXPECT_THROW(equivalenceTest(welch, {.lower = -1.0, .upper = INFINITY}), std::invalid_argument);
  EXPECT_THROW(equivalenceTest(welch, {.lower = NAN, .upper = 1.0}), std::invalid_argument);
}

}  // namespace equivalence_test

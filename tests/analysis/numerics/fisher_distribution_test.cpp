#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "analysis/numerics/distributions.h"
#include "tests/analysis/digits.h"

namespace fisher_distribution_test {

using analysis::FisherDistribution;
using tests::correctDigits;

TEST(FisherDistribution, HasTheTailsOfTheIncompleteBetaFunction) {
  // mpmath, 40 digits: betainc(b/2, a/2, 0, b / (b + a f), regularized=True)
  const auto digits = [](double f, double a, double b, const char* truth) {
    return correctDigits(FisherDistribution(a, b).upperP(f), truth);
  };
  EXPECT_GE(digits(0.001, 3.0, 40.0, "0.99995552762057514602"), 14.0);
  EXPECT_GE(digits(1.5, 2.5, 7.3, "0.28974650170939960597"), 14.0);
  EXPECT_GE(digits(30.0, 4.0, 200.0, "1.490947887216987535e-19"), 13.0);
  EXPECT_GE(digits(3.0, 2.0, 10.0, "0.095367431640625"), 14.0);
  EXPECT_GE(digits(1e-4, 2.0, 10.0, "0.99990000599972001119"), 14.0);
  EXPECT_GE(digits(40.0, 2.0, 1998.0, "9.2681003646375218727e-18"), 12.0);
  EXPECT_GE(digits(500.0, 3.0, 3000.0, "1.8426764088813597925e-263"), 12.0);
  EXPECT_GE(digits(3.0, 4.0, 2000.0, "0.017574842121596416643"), 12.0);
  EXPECT_GE(digits(1e4, 2.0, 117.0, "1.6999055076248820496e-131"), 12.0);
}

TEST(FisherDistribution, HasLogarithmsBeyondADouble) {
  const auto digits = [](double f, double a, double b, const char* truth) {
    return correctDigits(FisherDistribution(a, b).log10UpperP(f), truth);
  };
  EXPECT_GE(digits(1e6, 3.0, 400.0, "-773.82007889483186383"), 12.0);
  EXPECT_GE(digits(50.0, 8.0, 20000.0, "-79.895788972836907148"), 12.0);
  EXPECT_GE(digits(1e200, 4.0, 10.0, "-997.23214870625616825"), 12.0);
  EXPECT_GE(digits(1e6, 2.0, 200.0, "-400.00434272768626696"), 13.0);
  EXPECT_GE(digits(1e-3, 2.0, 30.0, "-0.0004342800060638887925"), 12.0);
  EXPECT_EQ(FisherDistribution(3.0, 400.0).upperP(1e6), 0.0);
}

TEST(FisherDistribution, IsThatOfTheSquareOfStudentsT) {
  for (const double t : {0.1, 1.0, 2.3, 12.0}) {
    const double p = analysis::StudentDistribution(9.5).twoSidedP(t);
    EXPECT_NEAR(FisherDistribution(1.0, 9.5).upperP(t * t) / p, 1.0, 1e-13);
  }
}

TEST(FisherDistribution, HasTheQuantilesOfItsTails) {
  const FisherDistribution law(3.0, 17.4);
  for (const double p : {0.975, 0.5, 0.05, 0.001}) {
    EXPECT_NEAR(law.upperP(law.upperQuantile(p)) / p, 1.0, 1e-13);
  }
  EXPECT_EQ(FisherDistribution(5.0, 1e-6).upperQuantile(0.025), INFINITY);
}

TEST(FisherDistribution, RejectsInvalidArguments) {
  EXPECT_THROW(FisherDistribution(0.0, 5.0), std::invalid_argument);
  EXPECT_THROW(FisherDistribution(2.0, INFINITY), std::invalid_argument);
  EXPECT_THROW(FisherDistribution(2.0, 5.0).upperP(-1.0), std::invalid_argument);
  EXPECT_THROW(FisherDistribution(2.0, 5.0).upperP(NAN), std::invalid_argument);
  EXPECT_THROW(FisherDistribution(2.0, 5.0).upperQuantile(0.0), std::invalid_argument);
}

}  // namespace fisher_distribution_test

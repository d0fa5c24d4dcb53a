#include "analysis/effects/bayes_factor.h"

#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "tests/analysis/digits.h"

namespace bayes_factor_test {

using analysis::jzsBayesFactor;
using Values = std::vector<double>;

struct KnownFactor {
  double t;
  double degreesOfFreedom;
  double effectiveN;
  const char* log10Bf10;
};

TEST(BayesFactor, AgreesWithItsDefinition) {
  // mpmath, 30 digits: quad of the integral over ln g
  const KnownFactor known[] = {
      {0.0, 10.0, 11.0, "-0.526560188276459053"},
      {2.0, 1e6, 2.5e5, "-1.77794422074417064"},
      {1000.0, 18.0, 5.0, "39.2007193753265062"},
      {40.0, 1e4, 2500.0, "320.317917966113655"},
      {1e5, 2000.0, 500.0, "6693.42070349712757"},
      {1e10, 400.0, 100.0, "3469.03948389803769"}};
  tests::WorstDigits worst("log10 of Bayes factors");
  for (const auto& [t, degreesOfFreedom, effectiveN, log10Bf10] : known) {
    const auto factor = jzsBayesFactor(t, degreesOfFreedom, effectiveN);
    const double digits = tests::correctDigits(factor.log10Bf10.value(), log10Bf10);
    worst.add("log10 BF10", std::to_string(t), digits);
    EXPECT_GE(digits, 11.0) << t;
  }
}

TEST(BayesFactor, DependsOnThePrior) {
  EXPECT_GE(
      tests::correctDigits(
          jzsBayesFactor(2.5, 30.0, 16.0, 1.0).log10Bf10.value(), "0.428585750677258204"),
      12.0);
  EXPECT_EQ(jzsBayesFactor(2.5, 30.0, 16.0, 1.0).priorScale, 1.0);
}

TEST(BayesFactor, EqualsThatOfStudentsSleepData) {
  // R: BayesFactor::ttestBF(sleep$extra[1:10], sleep$extra[11:20], paired = TRUE)
  const Values drug1{0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7, 0.8, 0.0, 2.0};
  const Values drug2{1.9, 0.8, 1.1, 0.1, -0.1, 4.4, 5.5, 1.6, 4.6, 3.4};
  const auto factor = jzsBayesFactor(analysis::pairedTTest(drug1, drug2));
  EXPECT_NEAR(factor.bf10.value(), 17.25888, 5e-6);
}

TEST(BayesFactor, IsTheSameForBothSigns) {
  EXPECT_EQ(jzsBayesFactor(2.0, 18.0, 5.0).bf10, jzsBayesFactor(-2.0, 18.0, 5.0).bf10);
}

TEST(BayesFactor, FavoursTheNullHypothesisAtAZeroT) {
  EXPECT_LT(jzsBayesFactor(0.0, 18.0, 5.0).bf10.value(), 1.0);
  EXPECT_LT(jzsBayesFactor(0.0, 2e6, 5e5).bf10.value(), 0.01);
}

TEST(BayesFactor, NeverOverflows) {
  const auto factor = jzsBayesFactor(1e5, 2000.0, 500.0);
  EXPECT_FALSE(factor.bf10.has_value());
  EXPECT_TRUE(std::isfinite(factor.log10Bf10.value()));
  EXPECT_FALSE(factor.reason.empty());

  EXPECT_TRUE(std::isfinite(jzsBayesFactor(1e100, 1e9, 1e9).log10Bf10.value()));
  EXPECT_FALSE(jzsBayesFactor(1e200, 10.0, 5.0).log10Bf10.has_value());
  EXPECT_FALSE(jzsBayesFactor(1e200, 10.0, 5.0).reason.empty());
}

TEST(BayesFactor, IsUndefinedIfTheTestIs) {
  const auto constant = analysis::studentTTest(Values{4.0, 4.0}, Values{5.0, 5.0});
  EXPECT_FALSE(jzsBayesFactor(constant, 2, 2).bf10.has_value());
  EXPECT_FALSE(jzsBayesFactor(constant, 2, 2).reason.empty());

  const auto shifted = analysis::pairedTTest(Values{5.0, 4.0}, Values{4.0, 3.0});
  EXPECT_FALSE(jzsBayesFactor(shifted).bf10.has_value());
  EXPECT_EQ(jzsBayesFactor(shifted).reason, shifted.reason);
}

TEST(BayesFactor, RejectsInvalidArguments) {
  EXPECT_THROW(jzsBayesFactor(NAN, 18.0, 5.0), std::invalid_argument);
  EXPECT_THROW(jzsBayesFactor(INFINITY, 18.0, 5.0), std::invalid_argument);
  EXPECT_THROW(jzsBayesFactor(1.0, 0.0, 5.0), std::invalid_argument);
  EXPECT_THROW(jzsBayesFactor(1.0, 18.0, -1.0), std::invalid_argument);
  EXPECT_THROW(jzsBayesFactor(1.0, 18.0, 5.0, 0.0), std::invalid_argument);
}

}  // namespace bayes_factor_test

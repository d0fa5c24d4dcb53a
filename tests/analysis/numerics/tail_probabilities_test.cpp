// Against values with 40 digits (mpmath: erfc, gammainc, betainc, and quad for the range).
#include "analysis/numerics/tail_probabilities.h"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/analysis/digits.h"

namespace tail_probabilities_test {

using tests::correctDigits;

TEST(NormalTail, HasItsLogarithmFarInTheTail) {
  using analysis::log10NormalTwoSidedP;
  EXPECT_GE(correctDigits(log10NormalTwoSidedP(0.1), "-0.036049661062642286128"), 14.0);
  EXPECT_GE(correctDigits(log10NormalTwoSidedP(-1.96), "-1.3010665622238701215"), 14.0);
  EXPECT_GE(correctDigits(log10NormalTwoSidedP(29.0), "-184.18180245305136005"), 14.0);
  EXPECT_GE(correctDigits(log10NormalTwoSidedP(31.0), "-210.26837093653995422"), 14.0);
  EXPECT_GE(correctDigits(log10NormalTwoSidedP(100.0), "-2173.5705128733703953"), 14.0);
}

TEST(NormalTail, HasItsLogarithmOnBothSides) {
  EXPECT_GE(correctDigits(analysis::logNormalCdf(-0.1), "-0.77615459273027332557"), 14.0);
  EXPECT_GE(correctDigits(analysis::logNormalCdf(-29.0), "-424.78741990973016268"), 14.0);
  EXPECT_GE(correctDigits(analysis::logNormalCdf(-40.0), "-804.60844201375378817"), 14.0);
  EXPECT_NEAR(std::exp(analysis::logNormalCdf(1.0)), 1.0 - 0.5 * std::erfc(std::sqrt(0.5)), 1e-15);
}

TEST(NormalTail, HasThePublishedQuantiles) {
  EXPECT_GE(
      correctDigits(analysis::normalTwoSidedQuantile(0.95), "1.959963984540054235524594"), 15.0);
  EXPECT_THROW(analysis::normalTwoSidedQuantile(1.0), std::invalid_argument);
}

TEST(ChiSquaredTail, HasTheDigitsOfMpmath) {
  EXPECT_GE(correctDigits(analysis::chiSquaredP(3.0, 1.0), "0.083264516663550401855"), 14.0);
  EXPECT_GE(correctDigits(analysis::chiSquaredP(1e-3, 2.0), "0.99950012497916927056"), 14.0);
  EXPECT_GE(correctDigits(analysis::log10ChiSquaredP(2000.0, 4.0), "-431.29404782577250901"), 14.0);
  EXPECT_GE(
      correctDigits(analysis::log10ChiSquaredP(5000.0, 11.0), "-1072.1635493647409196"), 14.0);
  EXPECT_EQ(analysis::chiSquaredP(0.0, 3.0), 1.0);
  EXPECT_THROW(analysis::chiSquaredP(-1.0, 3.0), std::invalid_argument);
  EXPECT_THROW(analysis::chiSquaredP(1.0, 0.0), std::invalid_argument);
}

TEST(StudentizedRange, HasTheDigitsOfMpmath) {
  using analysis::log10StudentizedRangeP;
  using analysis::studentizedRangeP;
  EXPECT_GE(correctDigits(studentizedRangeP(0.5, 3), "0.93342194513528696372"), 13.0);
  EXPECT_GE(correctDigits(studentizedRangeP(3.0, 3), "0.085542571654958003039"), 13.0);
  EXPECT_GE(correctDigits(studentizedRangeP(4.0, 5), "0.037696068220541633727"), 13.0);
  EXPECT_GE(correctDigits(studentizedRangeP(3.5, 20), "0.6036049452034736836"), 13.0);
  EXPECT_GE(correctDigits(studentizedRangeP(10.0, 4), "9.2241480451318839009e-12"), 12.0);
  // so far out the pairs exclude each other: k(k − 1)/2 erfc(q/2)
  EXPECT_GE(correctDigits(studentizedRangeP(25.0, 3), "1.8695828345939733018e-69"), 12.0);
  EXPECT_GE(correctDigits(log10StudentizedRangeP(60.0, 5), "-391.59097084451657604"), 13.0);
}

TEST(StudentizedRange, OfTwoIsTheirDifference) {
  for (const double q : {0.0, 1e-3, 0.7, 2.0, 5.0, 20.0}) {  // P(|Z₁ − Z₂| ≥ q) = erfc(q/2)
    EXPECT_NEAR(analysis::studentizedRangeP(q, 2) / std::erfc(0.5 * q), 1.0, 1e-12) << q;
  }
}

TEST(StudentizedRange, HasTheCriticalValuesOfTheTables) {
  // Harter 1960; Demšar 2006, table 5a, times √2: q.05 for infinitely many degrees of freedom
  EXPECT_NEAR(analysis::studentizedRangeP(3.314, 3), 0.05, 1e-4);
  EXPECT_NEAR(analysis::studentizedRangeP(3.633, 4), 0.05, 1e-4);
  EXPECT_NEAR(analysis::studentizedRangeP(4.474, 10), 0.05, 1e-4);
}

TEST(StudentizedRange, IsDefinedAtItsLimits) {
  EXPECT_NEAR(analysis::studentizedRangeP(0.0, 7), 1.0, 1e-13);
  EXPECT_NEAR(analysis::studentizedRangeP(0.0, 10'000), 1.0, 1e-12);
  EXPECT_EQ(analysis::studentizedRangeP(1000.0, 3), 0.0);
  EXPECT_THROW(analysis::studentizedRangeP(-1.0, 3), std::invalid_argument);
  EXPECT_THROW(analysis::studentizedRangeP(1.0, 1), std::invalid_argument);
}

}  // namespace tail_probabilities_test

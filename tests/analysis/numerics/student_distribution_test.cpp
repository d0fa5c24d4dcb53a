#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "analysis/numerics/distributions.h"
#include "tests/analysis/digits.h"

namespace student_distribution_test {

using analysis::StudentDistribution;
using tests::correctDigits;

TEST(StudentDistribution, IsTheCauchyDistributionForOneDegreeOfFreedom) {
  const StudentDistribution cauchy(1.0);
  EXPECT_DOUBLE_EQ(cauchy.twoSidedP(1.0), 0.5);
  EXPECT_DOUBLE_EQ(cauchy.twoSidedP(-1.0), 0.5);
  EXPECT_DOUBLE_EQ(cauchy.twoSidedP(std::sqrt(3.0)), 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(cauchy.twoSidedQuantile(0.5), 1.0);
}

TEST(StudentDistribution, HasAClosedFormForTwoDegreesOfFreedom) {
  // P(|T| ≥ t) = 1 − t / √(2 + t²)
  const StudentDistribution law(2.0);
  for (const double t : {0.0, 0.1, 1.0, 3.0, 50.0}) {
    const double root = std::sqrt(2.0 + t * t);
    EXPECT_DOUBLE_EQ(law.twoSidedP(t), 2.0 / (root * (root + t))) << t;
  }
}

TEST(StudentDistribution, ApproachesTheNormalDistribution) {
  EXPECT_NEAR(StudentDistribution(1e12).twoSidedP(1.96), std::erfc(1.96 / std::sqrt(2.0)), 1e-12);
}

struct Far {
  double t;
  double degreesOfFreedom;
  const char* p;
  const char* log10P;
};

// Python, mpmath 1.3 with mp.dps = 50, t and df taken as doubles:
//   p = betainc(df/2, mpf(1)/2, 0, df/(df + t*t), regularized=True); log10(p)
// the last two, beyond betainc, by quad() of the density.
constexpr Far kFar[] = {
    {1e-8, 1.0, "0.99999999363380227632", "-2.7648045508980947295e-9"},
    {1e-3, 2.5, "0.99927638272078488542", "-0.00031437674931981105582"},
    {10.0, 2.5, "0.0044414957673074247731", "-2.3524707474322918885"},
    {40.0, 60.13, "4.9333566430633883772e-45", "-44.306857487311889851"},
    {60.0, 1e4, "3.1324563448680511033e-670", "-669.5041149727887279"},
    {1e120, 2.0, "1.00000000000000004e-240", "-239.99999999999999998"},
    {1e200, 1.0, "6.3661977236758136234e-201", "-200.19611987703015265"},
    {1e300, 50.0, "3.3460608917241321125e-14959", "-14958.475466159996709"},
    {39.0, 1e12, "1.070624442450572733223782e-332", "-331.9703628458580291914502"},
    {45.0, 1e12, "3.352361651786034556818186e-442", "-441.4746491359539238586467"},
};

TEST(StudentDistribution, KeepsItsDigitsForSmallAndLargeT) {
  constexpr double kSmallest = -300.0;
  for (const auto& [t, degreesOfFreedom, p, log10P] : kFar) {
    SCOPED_TRACE(std::to_string(t) + " of " + std::to_string(degreesOfFreedom));
    const StudentDistribution law(degreesOfFreedom);

    EXPECT_GE(correctDigits(law.log10TwoSidedP(t), log10P), 15.0);
    EXPECT_EQ(law.log10TwoSidedP(-t), law.log10TwoSidedP(t));
    if (law.log10TwoSidedP(t) > kSmallest) {
      EXPECT_GE(correctDigits(law.twoSidedP(t), p), 12.5);
    }
  }
}

TEST(StudentDistribution, IsContinuousWhereItsFormulaChanges) {
  // Both sides of p = 1e-300, of t = 1e100 and of the bound of the centre.
  const auto rate = [](double degreesOfFreedom, double t) {
    const StudentDistribution law(degreesOfFreedom);
    const double below = law.log10TwoSidedP(t * (1.0 - 1e-9));
    const double above = law.log10TwoSidedP(t * (1.0 + 1e-9));
    return (below - above) / 2e-9;
  };
  EXPECT_NEAR(rate(3.0, 1e100) * std::numbers::ln10, 3.0, 1e-4);
  EXPECT_NEAR(rate(2.0, 1e150) * std::numbers::ln10, 2.0, 1e-4);
  // The density of Cauchy's law at 0.6, times 2 t / P(|T| ≥ t).
  const double p = 1.0 - 2.0 / std::numbers::pi * std::atan(0.6);
  EXPECT_NEAR(rate(1.0, 0.6) * std::numbers::ln10, 1.2 / (std::numbers::pi * 1.36 * p), 1e-6);
}

struct Quantile {
  double p;
  double degreesOfFreedom;
  const char* t;
};

// Python, mpmath as above: findroot(lambda t: betainc(…) - p, 2)
constexpr Quantile kQuantiles[] = {
    {0.05, 1.0, "12.70620473617470393777668"},
    {0.05 / 3.0, 1.0, "38.18845929702560958591643"},
    {0.05, 1.7, "5.118838988253059689637593"},
    {0.05 / 3.0, 1.7, "9.933741552927163694375114"},
    {0.05, 5.0, "2.570581835636315468952015"},
    {0.05, 60.13, "2.000208877781520964353823"},
    {0.05 / 3.0, 60.13, "2.462800032223187313008912"},
};

TEST(StudentDistribution, HasThePublishedQuantiles) {
  for (const auto& [p, degreesOfFreedom, t] : kQuantiles) {
    EXPECT_GE(correctDigits(StudentDistribution(degreesOfFreedom).twoSidedQuantile(p), t), 14.0)
        << p << " of " << degreesOfFreedom;
  }
}

TEST(StudentDistribution, InvertsItsProbability) {
  for (const double degreesOfFreedom : {1.0, 1.7, 5.0, 60.13, 2e6, 1e12}) {
    const StudentDistribution law(degreesOfFreedom);
    for (const double p : {0.9, 0.5, 0.05, 0.05 / 3.0, 1e-6, 1e-15}) {
      EXPECT_NEAR(law.twoSidedP(law.twoSidedQuantile(p)) / p, 1.0, 1e-12)
          << p << " of " << degreesOfFreedom;
    }
  }
  EXPECT_EQ(StudentDistribution(5.0).twoSidedQuantile(1.0), 0.0);
}

TEST(StudentDistribution, RejectsInvalidArguments) {
  EXPECT_THROW(StudentDistribution(0.5), std::invalid_argument);
  EXPECT_THROW(StudentDistribution(std::nan("")), std::invalid_argument);
  EXPECT_THROW(StudentDistribution{INFINITY}, std::invalid_argument);
  EXPECT_THROW(StudentDistribution(5.0).twoSidedQuantile(0.0), std::invalid_argument);
  EXPECT_THROW(StudentDistribution(5.0).twoSidedQuantile(1.5), std::invalid_argument);
}

}  // namespace student_distribution_test

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "analysis/numerics/distributions.h"
#include "tests/analysis/digits.h"

namespace noncentral_t_test {

using analysis::noncentralityInterval;
using analysis::noncentralTProbability;

struct KnownProbability {
  double t;
  double degreesOfFreedom;
  double noncentrality;
  const char* probability;
};

TEST(NoncentralT, HasTheProbabilitiesOfItsDefinition) {
  // mpmath, 30 digits: quad of Φ(t s − δ) over the density of s = √(χ²/ν)
  const KnownProbability known[] = {
      {2.0, 3.0, 1.0, "0.74362986840766531463"},
      {-1.0, 5.0, 2.0, "0.0023163756540751190482"},
      {60.0, 18.0, 55.0, "0.65272469771995495645"},
      {95.0, 18.0, 99.5, "0.34763502481485607859"},
      {120.0, 1e6, 118.5, "0.93249046021731143881"},
      {150.0, 58.0, 140.0, "0.74602775404897195298"},
      {300.0, 4.5, 200.0, "0.798470722449750804"},
      {1000.0, 10.0, 900.0, "0.61906872669836612002"},
      {5000.0, 1.0, 4000.0, "0.42371080643692284074"},
      {1e5, 30.0, 9e4, "0.75828511654336576594"}};
  tests::WorstDigits worst("noncentral t");
  for (const auto& [t, degreesOfFreedom, noncentrality, probability] : known) {
    const double p = noncentralTProbability(t, degreesOfFreedom, noncentrality);
    const double digits = tests::correctDigits(p, probability);
    worst.add("P(T <= t)", std::to_string(t), digits);
    EXPECT_GE(digits, 12.5) << t << " " << degreesOfFreedom << " " << noncentrality;
  }
}

TEST(NoncentralT, IsStudentsTWithoutNoncentrality) {
  for (const double t : {0.3, 1.0, 2.5, 8.0}) {
    const double p = analysis::StudentDistribution(7.5).twoSidedP(t);
    EXPECT_NEAR(noncentralTProbability(t, 7.5, 0.0), 1.0 - 0.5 * p, 1e-14);
  }
}

TEST(NoncentralT, IsSymmetricInBothSigns) {
  for (const double noncentrality : {1.5, 99.0, 101.0, 250.0}) {
    const double t = noncentrality + 1.0;
    const double p = noncentralTProbability(t, 12.0, noncentrality);
    EXPECT_NEAR(noncentralTProbability(-t, 12.0, -noncentrality), 1.0 - p, 1e-14);
  }
  EXPECT_EQ(noncentralTProbability(-5.0, 12.0, 150.0), 0.0);
  EXPECT_EQ(noncentralTProbability(5.0, 12.0, -150.0), 1.0);
}

TEST(NoncentralT, IsContinuousWhereItsMethodChanges) {
  for (const double degreesOfFreedom : {1.0, 2.7, 40.0, 1e5}) {
    const double near = noncentralTProbability(104.0, degreesOfFreedom, 100.0);
    const double far = noncentralTProbability(104.0, degreesOfFreedom, std::nextafter(100.0, 101));
    EXPECT_NEAR(near, far, 1e-13) << degreesOfFreedom;
  }
}

TEST(NoncentralityInterval, IsNormalForManyDegreesOfFreedom) {
  const auto interval = noncentralityInterval(3.0, 1e12, 0.95);
  EXPECT_NEAR(interval.low, 3.0 - 1.959963984540054, 1e-9);  // R: qnorm(.975)
  EXPECT_NEAR(interval.high, 3.0 + 1.959963984540054, 1e-9);
}

TEST(NoncentralityInterval, HasTheTailsOfItsLevel) {
  for (const double t : {-40.0, -0.7, 0.0, 1e-8, 2.2, 300.0, 1e6}) {
    for (const double level : {0.05, 0.9, 0.95, 0.999}) {
      const auto interval = noncentralityInterval(t, 18.0, level);
      const double tail = 0.5 * (1.0 - level);
      EXPECT_NEAR(noncentralTProbability(t, 18.0, interval.high), tail, 1e-12) << t;
      EXPECT_NEAR(1.0 - noncentralTProbability(t, 18.0, interval.low), tail, 1e-12) << t;
      EXPECT_LT(interval.low, interval.high);
    }
  }
}

TEST(NoncentralityInterval, AgreesWithMpmathForLargeT) {
  // mpmath: findroot of P(T ≤ 300 | δ) = .975 and .025 with 20 degrees of freedom
  const auto interval = noncentralityInterval(300.0, 20.0, 0.95);
  EXPECT_GE(tests::correctDigits(interval.low, "207.72359252883042"), 12.0);
  EXPECT_GE(tests::correctDigits(interval.high, "392.145890799362143"), 12.0);
}

TEST(NoncentralityInterval, RejectsInvalidArguments) {
  EXPECT_THROW(noncentralityInterval(NAN, 5.0, 0.95), std::invalid_argument);
  EXPECT_THROW(noncentralityInterval(INFINITY, 5.0, 0.95), std::invalid_argument);
  EXPECT_THROW(noncentralityInterval(1.0, 0.5, 0.95), std::invalid_argument);
  EXPECT_THROW(noncentralityInterval(1.0, INFINITY, 0.95), std::invalid_argument);
  EXPECT_THROW(noncentralityInterval(1.0, 5.0, 1.0), std::invalid_argument);
  EXPECT_THROW(noncentralityInterval(1.0, 5.0, 0.0), std::invalid_argument);
}

}  // namespace noncentral_t_test

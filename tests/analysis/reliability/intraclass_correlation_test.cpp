#include "analysis/reliability/intraclass_correlation.h"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "analysis/reliability/reliability.h"

namespace intraclass_correlation_test {

using analysis::IntraclassCorrelation;
using analysis::intraclassCorrelations;
using Table = std::vector<std::vector<double>>;

// Shrout & Fleiss 1979, table 2: four judges, six targets
const Table kTargets{
    {9, 2, 5, 8}, {6, 1, 3, 2}, {8, 4, 6, 8}, {7, 1, 2, 6}, {10, 5, 6, 9}, {6, 2, 4, 7}};

TEST(IntraclassCorrelations, AreThoseOfShroutAndFleiss) {
  const auto all = intraclassCorrelations(kTargets);

  EXPECT_NEAR(all.oneWaySingle.value.value(), 0.17, 0.005);
  EXPECT_NEAR(all.twoWayRandomSingle.value.value(), 0.29, 0.005);
  EXPECT_NEAR(all.twoWayMixedSingle.value.value(), 0.71, 0.005);
  EXPECT_NEAR(all.oneWayAverage.value.value(), 0.44, 0.005);
  EXPECT_NEAR(all.twoWayRandomAverage.value.value(), 0.62, 0.005);
  EXPECT_NEAR(all.twoWayMixedAverage.value.value(), 0.91, 0.005);
  EXPECT_EQ(all.subjects, 6U);
  EXPECT_EQ(all.raters, 4U);
  EXPECT_TRUE(all.reason.empty());
}

TEST(IntraclassCorrelations, HaveTheIntervalsOfR) {
  // R: psych::ICC(sf), lower and upper bound
  const auto all = intraclassCorrelations(kTargets);
  const auto expect = [](const IntraclassCorrelation& icc, double low, double high) {
    EXPECT_NEAR(icc.interval.value().low, low, 0.0005);
    EXPECT_NEAR(icc.interval.value().high, high, 0.005);
  };
  expect(all.oneWaySingle, -0.133, 0.72);
  expect(all.twoWayRandomSingle, 0.019, 0.76);
  expect(all.twoWayMixedSingle, 0.342, 0.95);
  expect(all.oneWayAverage, -0.884, 0.91);
  expect(all.twoWayRandomAverage, 0.071, 0.93);
  expect(all.twoWayMixedAverage, 0.676, 0.99);
}

TEST(IntraclassCorrelations, AreTestedByF) {
  // R: psych::ICC(sf): F = 1.8 with 5 and 18, p = 0.16477; F = 11.0 with 5 and 15, p = 0.00013
  const auto all = intraclassCorrelations(kTargets);

  EXPECT_NEAR(all.oneWaySingle.f.value(), 1.8, 0.05);
  EXPECT_NEAR(all.oneWaySingle.p.value(), 0.16477, 5e-6);
  EXPECT_EQ(all.oneWaySingle.degreesOfFreedom2, 18.0);
  EXPECT_NEAR(all.twoWayMixedSingle.f.value(), 11.0, 0.05);
  EXPECT_NEAR(all.twoWayMixedSingle.p.value(), 0.00013, 5e-6);
  EXPECT_EQ(all.twoWayMixedSingle.degreesOfFreedom2, 15.0);
}

TEST(IntraclassCorrelations, OfTheAverageOfTheseRatersIsCronbachsAlpha) {
  const auto all = intraclassCorrelations(kTargets);
  const auto alpha = analysis::cronbachAlpha(kTargets);

  EXPECT_DOUBLE_EQ(all.twoWayMixedAverage.value.value(), alpha.value.value());
  EXPECT_NEAR(all.twoWayMixedAverage.interval->low, alpha.interval->low, 1e-13);
  EXPECT_NEAR(all.twoWayMixedAverage.interval->high, alpha.interval->high, 1e-13);
}

TEST(IntraclassCorrelations, OfTheAverageFollowSpearmanAndBrown) {
  const auto all = intraclassCorrelations(kTargets);
  const auto expect = [](const IntraclassCorrelation& single,
                         const IntraclassCorrelation& average) {
    EXPECT_NEAR(*average.value, 4.0 * *single.value / (1.0 + 3.0 * *single.value), 1e-14);
  };
  expect(all.oneWaySingle, all.oneWayAverage);
  expect(all.twoWayRandomSingle, all.twoWayRandomAverage);
  expect(all.twoWayMixedSingle, all.twoWayMixedAverage);
}

TEST(IntraclassCorrelations, DistinguishAgreementFromConsistency) {
  const auto all = intraclassCorrelations(Table{{1, 2}, {2, 3}, {3, 4}, {5, 6}});

  EXPECT_EQ(all.twoWayMixedSingle.value, 1.0);
  EXPECT_LT(all.twoWayRandomSingle.value.value(), 1.0);
  EXPECT_EQ(all.twoWayMixedSingle.f, INFINITY);
  EXPECT_FALSE(all.twoWayMixedSingle.interval.has_value());
  EXPECT_FALSE(all.reason.empty());
}

TEST(IntraclassCorrelations, GiveAReasonIfTheyAreUndefined) {
  const auto same = intraclassCorrelations(Table{{3, 3}, {3, 3}});
  EXPECT_FALSE(same.oneWaySingle.value.has_value());
  EXPECT_FALSE(same.oneWaySingle.p.has_value());
  EXPECT_FALSE(same.reason.empty());

  const auto noSubjects = intraclassCorrelations(Table{{1, 2, 3}, {2, 3, 1}, {3, 1, 2}});
  EXPECT_DOUBLE_EQ(noSubjects.oneWaySingle.value.value(), -0.5);  // −1 / (k − 1)
  EXPECT_FALSE(noSubjects.oneWayAverage.value.has_value());
  EXPECT_FALSE(noSubjects.twoWayRandomSingle.interval.has_value());
  EXPECT_FALSE(noSubjects.reason.empty());

  EXPECT_FALSE(intraclassCorrelations(Table{{1, 2}}).reason.empty());
  EXPECT_FALSE(intraclassCorrelations(Table{{1}, {2}}).reason.empty());
  EXPECT_THROW(intraclassCorrelations(Table{{1, 2}, {1}}), std::invalid_argument);
  EXPECT_THROW(intraclassCorrelations(kTargets, 0.0), std::invalid_argument);
}

}  // namespace intraclass_correlation_test

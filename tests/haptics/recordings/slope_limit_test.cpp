#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "haptics/recordings/force_curve.h"

namespace haptics::recordings {
namespace slope_limit_test {

/// The envelopes by their definition, every node against every other.
double meanOfEnvelopesAt(const ForceCurve& curve, double x, double maxSlope) {
  double lower = std::numeric_limits<double>::infinity();
  double upper = -lower;
  for (const CurvePoint& node : curve.nodes()) {
    const double reach = maxSlope * std::abs(x - node.travel);
    lower = std::min(lower, node.force + reach);
    upper = std::max(upper, node.force - reach);
  }
  return (lower + upper) / 2.0;
}

ForceCurve noisyCurve(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> step(1e-4, 0.2);
  std::uniform_real_distribution<double> force(0.0, 9.0);
  std::vector<CurvePoint> nodes{{0.0, force(random)}};
  for (int i = 0; i < 200; ++i) {
    nodes.push_back({nodes.back().travel + step(random), force(random)});
  }
  return ForceCurve(nodes);
}

TEST(SlopeLimit, LeavesAGentleCurveAlone) {
  const ForceCurve gentle({{0.0, 0.0}, {1.0, 4.0}, {2.0, 1.0}});
  const SlopeLimited limited = limitSlope(gentle, 4.0);
  EXPECT_EQ(limited.curve, gentle);
  EXPECT_EQ(limited.largestChange, 0.0);
}

TEST(SlopeLimit, MeetsAStepInItsMiddle) {
  const SlopeLimited limited =
      limitSlope(ForceCurve({{0.0, 0.0}, {1.0, 0.0}, {1.5, 3.0}, {3.0, 3.0}}), 2.0);
  // 3 N over half a unit, where 1 N may be: each side gives 1 N.
  EXPECT_DOUBLE_EQ(limited.curve.nodes()[1].force, 1.0);
  EXPECT_DOUBLE_EQ(limited.curve.nodes()[2].force, 2.0);
  EXPECT_DOUBLE_EQ(limited.largestChange, 1.0);
  EXPECT_DOUBLE_EQ(limited.largestChangeAt, 1.0);
}

TEST(SlopeLimit, IsTheMeanOfTheTwoEnvelopes) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const ForceCurve curve = noisyCurve(seed);
    const SlopeLimited limited = limitSlope(curve, 4.39);
    for (const CurvePoint& node : limited.curve.nodes()) {
      EXPECT_NEAR(node.force, meanOfEnvelopesAt(curve, node.travel, 4.39), 1e-9);
    }
  }
}

TEST(SlopeLimit, NeverLeavesASteeperSlopeNorAForceBelowNothing) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const SlopeLimited limited = limitSlope(noisyCurve(seed), 4.39);
    EXPECT_LE(limited.curve.largestSlope(), 4.39 * (1.0 + 1e-9));
    for (const CurvePoint& node : limited.curve.nodes()) EXPECT_GE(node.force, 0.0);
  }
}

TEST(SlopeLimit, ChangesNoMoreThanTheSteepestPairAsksFor) {
  // No curve of slope K can do with less than half of max |f(x) − f(y)| − K |x − y|.
  const ForceCurve curve = noisyCurve(99);
  double least = 0.0;
  for (const CurvePoint& a : curve.nodes()) {
    for (const CurvePoint& b : curve.nodes()) {
      least = std::max(least, std::abs(a.force - b.force) - 4.39 * std::abs(a.travel - b.travel));
    }
  }
  EXPECT_NEAR(limitSlope(curve, 4.39).largestChange, least / 2.0, 1e-9);
}

TEST(SlopeLimit, RefusesALimitThatIsNone) {
  const ForceCurve curve({{0.0, 0.0}, {1.0, 4.0}});
  EXPECT_THROW(limitSlope(curve, 0.0), std::invalid_argument);
  EXPECT_THROW(limitSlope(curve, -1.0), std::invalid_argument);
  EXPECT_THROW(limitSlope(curve, std::nan("")), std::invalid_argument);
  EXPECT_THROW(limitSlope(curve, std::numeric_limits<double>::infinity()), std::invalid_argument);
}

}  // namespace slope_limit_test
}  // namespace haptics::recordings

#include "haptics/models/interpolation.h"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace haptics::models {
namespace interpolation_test {

using Curve = Interpolation<double>;
const std::vector<CurveNode<double>> kNodes{{2.0, 0.0}, {4.0, 1.0}, {5.0, 4.0}, {9.0, 2.0}};
constexpr Curve::Options kRamp{.extrapolation = Extrapolation::RampOut, .rampLength = 2.0};

double forceAt(double travel, const Curve::Options& options = kRamp) {
  std::size_t hint = 0;
  return Curve(kNodes.data(), kNodes.size(), options).at(travel, hint).force;
}

TEST(Interpolation, IsTheStraightLineBetweenTwoPoints) {
  EXPECT_DOUBLE_EQ(forceAt(3.0), 0.5);
  EXPECT_DOUBLE_EQ(forceAt(4.5), 2.5);
  EXPECT_DOUBLE_EQ(forceAt(8.0), 2.5);
}

TEST(Interpolation, PassesThroughEveryPoint) {
  for (const auto& node : kNodes) EXPECT_DOUBLE_EQ(forceAt(node.travel), node.force);
}

TEST(Interpolation, KnowsItsStiffness) {
  std::size_t hint = 0;
  const Curve curve(kNodes.data(), kNodes.size(), kRamp);
  EXPECT_DOUBLE_EQ(curve.at(4.5, hint).stiffness, 3.0);
  EXPECT_DOUBLE_EQ(curve.at(7.0, hint).stiffness, -0.5);
}

TEST(Interpolation, AnswersTheSameWithAnyHint) {
  const Curve curve(kNodes.data(), kNodes.size(), kRamp);
  for (double travel = 0.0; travel < 12.0; travel += 0.1) {
    for (std::size_t start = 0; start < 10; ++start) {
      std::size_t hint = start;
      EXPECT_EQ(curve.at(travel, hint).force, forceAt(travel)) << travel << " from " << start;
    }
  }
}

TEST(Interpolation, FadesBeyondItsEndsOverTheRamp) {
  EXPECT_DOUBLE_EQ(forceAt(10.0), 1.0);
  EXPECT_DOUBLE_EQ(forceAt(11.0), 0.0);
  EXPECT_DOUBLE_EQ(forceAt(50.0), 0.0);
}

TEST(Interpolation, HoldsOrDropsItsEndOnRequest) {
  EXPECT_DOUBLE_EQ(forceAt(50.0, {.extrapolation = Extrapolation::Hold}), 2.0);
  EXPECT_DOUBLE_EQ(forceAt(9.001, {.extrapolation = Extrapolation::Zero}), 0.0);
}

TEST(Interpolation, HasNoForceForNaN) {
  std::size_t hint = 2;
  const Curve curve(kNodes.data(), kNodes.size(), {.extrapolation = Extrapolation::Hold});
  const auto response = curve.at(std::numeric_limits<double>::quiet_NaN(), hint);
  EXPECT_FALSE(response.isDefined);
  EXPECT_EQ(response.force, 0.0);
}

TEST(Interpolation, IsUnsoundWithPointsThatDoNotAdvanceOrAreNoNumbers) {
  const auto isSound = [](const std::vector<CurveNode<double>>& nodes) {
    return Curve::isSound(nodes.data(), nodes.size(), kRamp);
  };
  EXPECT_TRUE(isSound(kNodes));
  EXPECT_FALSE(isSound({{1.0, 0.0}}));
  EXPECT_FALSE(isSound({{1.0, 0.0}, {1.0, 2.0}}));
  EXPECT_FALSE(isSound({{1.0, 0.0}, {0.5, 2.0}}));
  EXPECT_FALSE(isSound({{1.0, 0.0}, {2.0, std::nan("")}}));
  EXPECT_FALSE(isSound({{1.0, 0.0}, {INFINITY, 2.0}}));
}

}  // namespace interpolation_test
}  // namespace haptics::models

#include "haptics/models/hermite_curve.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace haptics::models {
namespace {

using Curve = HermiteCurve<double>;

double cubic(double x) { return 2.0 + x * (3.0 + x * (-1.0 + 0.25 * x)); }
double cubicSlope(double x) { return 3.0 + x * (-2.0 + 0.75 * x); }

std::vector<HermiteNode<double>> nodesOfCubic() {
  std::vector<HermiteNode<double>> nodes;
  for (const double x : {0.0, 0.7, 1.0, 2.5, 4.0}) nodes.push_back({x, cubic(x), cubicSlope(x)});
  return nodes;
}

TEST(HermiteCurve, IsExactForACubic) {
  const auto nodes = nodesOfCubic();
  const Curve curve(nodes.data(), nodes.size());
  std::size_t hint = 0;
  for (double x = 0.0; x < 4.0; x += 0.01) {
    const auto response = curve.at(x, hint);
    EXPECT_NEAR(response.force, cubic(x), 1e-13);
    EXPECT_NEAR(response.stiffness, cubicSlope(x), 1e-12);
  }
}

TEST(HermiteCurve, HasNoForceBeforeContactAndHoldsItBeyondTheEnd) {
  const auto nodes = nodesOfCubic();
  const Curve curve(nodes.data(), nodes.size());
  std::size_t hint = 0;
  EXPECT_EQ(curve.at(-0.001, hint).force, 0.0);
  EXPECT_EQ(curve.at(100.0, hint).force, cubic(4.0));
  EXPECT_FALSE(curve.at(std::nan(""), hint).isDefined);
}

TEST(HermiteCurve, KnowsUnsoundNodes) {
  auto nodes = nodesOfCubic();
  EXPECT_TRUE(Curve::isSound(nodes.data(), nodes.size()));
  EXPECT_FALSE(Curve::isSound(nodes.data(), 1));
  nodes[2].position = nodes[1].position;
  EXPECT_FALSE(Curve::isSound(nodes.data(), nodes.size()));
  nodes = nodesOfCubic();
  nodes[3].slope = INFINITY;
  EXPECT_FALSE(Curve::isSound(nodes.data(), nodes.size()));
}

}  // namespace
}  // namespace haptics::models

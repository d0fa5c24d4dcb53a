#include "haptics/models/hermite_curve.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "haptics/engine/bucket_table.h"

namespace haptics::models {
namespace hermite_curve_test {

using Curve = HermiteCurve<double>;

double cubic(double x) {
  return 2.0 + x * (3.0 + x * (-1.0 + 0.25 * x));
}
double cubicSlope(double x) {
  return 3.0 + x * (-2.0 + 0.75 * x);
}

std::vector<CubicSegment<double>> piecesOf(const std::vector<HermiteNode<double>>& nodes) {
  std::vector<CubicSegment<double>> pieces;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    pieces.push_back(CubicSegment<double>::between(nodes[i], nodes[i + 1]));
  }
  return pieces;
}

std::vector<CubicSegment<double>> piecesOfCubic() {
  std::vector<HermiteNode<double>> nodes;
  for (const double x : {0.0, 0.7, 1.0, 2.5, 4.0}) nodes.push_back({x, cubic(x), cubicSlope(x)});
  return piecesOf(nodes);
}

TEST(HermiteCurve, IsExactForACubic) {
  const auto pieces = piecesOfCubic();
  const Curve curve(pieces.data(), pieces.size());
  std::size_t hint = 0;
  for (double x = 0.0; x < 4.0; x += 0.01) {
    const auto response = curve.at(x, hint);
    EXPECT_NEAR(response.force, cubic(x), 1e-13);
    EXPECT_NEAR(response.stiffness, cubicSlope(x), 1e-12);
  }
}

TEST(HermiteCurve, HasNoForceBeforeContactAndHoldsItBeyondTheEnd) {
  const auto pieces = piecesOfCubic();
  const Curve curve(pieces.data(), pieces.size());
  std::size_t hint = 0;
  EXPECT_EQ(curve.at(-0.001, hint).force, 0.0);
  EXPECT_NEAR(curve.at(100.0, hint).force, cubic(4.0), 1e-14);
  EXPECT_FALSE(curve.at(std::nan(""), hint).isDefined);
}

TEST(HermiteCurve, AnswersTheSameWithAnyHintAndIndex) {
  const auto pieces = piecesOfCubic();
  const std::vector<double> knots{0.0, 0.7, 1.0, 2.5, 4.0};
  const engine::BucketTable table(knots);
  const Curve searching(pieces.data(), pieces.size());
  const Curve indexed(pieces.data(), pieces.size(), table.index());
  for (double x = -0.05; x < 4.1; x += 0.0137) {
    for (std::size_t start = 0; start < 6; ++start) {
      std::size_t hint = start;
      std::size_t other = 0;
      EXPECT_EQ(searching.at(x, hint).force, indexed.at(x, other).force) << x << " " << start;
    }
  }
}

TEST(HermiteCurve, FillsOneCacheLineAPiece) {
  EXPECT_EQ(sizeof(CubicSegment<double>), 64U);
  EXPECT_EQ(alignof(CubicSegment<double>), 64U);
}

TEST(HermiteCurve, RefusesUnsoundPieces) {
  auto pieces = piecesOfCubic();
  EXPECT_TRUE(Curve::isSound(pieces.data(), pieces.size()));
  EXPECT_FALSE(Curve::isSound(pieces.data(), 0));
  pieces[2].begin = pieces[1].begin;
  EXPECT_FALSE(Curve::isSound(pieces.data(), pieces.size()));
  // A number that is one, and a slope that is none: the nodes lie too near to each other.
  const auto crowded = piecesOf({{0.0, 0.0, 0.0}, {1e-300, 1e300, 0.0}});
  EXPECT_FALSE(Curve::isSound(crowded.data(), crowded.size()));
}

}  // namespace hermite_curve_test
}  // namespace haptics::models

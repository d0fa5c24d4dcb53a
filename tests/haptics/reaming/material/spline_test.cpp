#include "haptics/reaming/material/spline.h"

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

namespace haptics::reaming {
namespace spline_test {

SampledCurve sampled(double (*f)(double), double end, int count) {
  SampledCurve curve;
  for (int i = 0; i < count; ++i) {
    const double x = end * i / (count - 1);
    curve.x.push_back(x);
    curve.y.push_back(f(x));
  }
  return curve;
}

double cubic(double x) {
  return 1.0 + x * (2.0 - x * (3.0 - x));
}
double wave(double x) {
  return std::sin(3.0 * x) + 0.3 * x;
}
double kink(double x) {
  return x < 1.0 ? 0.0 : 5.0 * (x - 1.0);
}

std::vector<std::size_t> every(std::size_t stride, std::size_t count) {
  std::vector<std::size_t> nodes;
  for (std::size_t i = 0; i < count; i += stride) nodes.push_back(i);
  return nodes;
}

Spline through(const SampledCurve& curve, std::size_t stride, SplineKind kind) {
  return splineThrough(curve, dataSlopes(curve), every(stride, curve.size()), kind);
}

constexpr SplineKind kKinds[]{
    SplineKind::HermiteDataSlope,
    SplineKind::Pchip,
    SplineKind::Makima,
    SplineKind::NaturalCubic,
    SplineKind::Linear};

TEST(Spline, PassesThroughItsNodesOfEveryKind) {
  const auto curve = sampled(wave, 3.0, 301);
  for (const auto kind : kKinds) {
    const auto spline = through(curve, 20, kind);
    for (const auto& node : spline.nodes) EXPECT_NEAR(spline.at(node.position), node.force, 1e-12);
    EXPECT_EQ(spline.at(-1.0), curve.y.front());
    EXPECT_EQ(spline.at(99.0), curve.y.back());
  }
}

TEST(Spline, OfHermiteKindHasTheOrderThatTheoryGives) {
  // Halving the distance divides the error of exact slopes by sixteen.
  const auto curve = sampled(wave, 3.0, 38'401);
  const double coarse =
      errorOf(curve, through(curve, 1200, SplineKind::HermiteDataSlope), 1.0).largest;
  const double fine =
      errorOf(curve, through(curve, 600, SplineKind::HermiteDataSlope), 1.0).largest;
  EXPECT_NEAR(std::log2(coarse / fine), 4.0, 0.2);
}

TEST(Spline, OfNaturalKindIsSmoothAndStraightAtItsEnds) {
  const auto curve = sampled(wave, 3.0, 301);
  const auto spline = through(curve, 25, SplineKind::NaturalCubic);
  EXPECT_NEAR(spline.segments.front().square, 0.0, 1e-9);
  const auto& last = spline.segments.back();
  EXPECT_NEAR(last.square + 3.0 * last.cube * (last.end - last.begin), 0.0, 1e-9);
  for (std::size_t i = 0; i + 1 < spline.segments.size(); ++i) {
    const auto& a = spline.segments[i];
    const auto& b = spline.segments[i + 1];
    const double h = a.end - a.begin;
    EXPECT_NEAR(a.at(a.end).stiffness, b.slope, 1e-9);
    EXPECT_NEAR(a.square + 3.0 * a.cube * h, b.square, 1e-9);  // second derivatives join
  }
}

TEST(Spline, OvershootsAsNaturalCubicAndNotAsPchip) {
  const auto curve = sampled(kink, 2.0, 201);
  double lowest[2] = {0.0, 0.0};
  const SplineKind kinds[]{SplineKind::NaturalCubic, SplineKind::Pchip};
  for (int k = 0; k < 2; ++k) {
    const auto spline = through(curve, 20, kinds[k]);
    for (double x = 0.0; x < 2.0; x += 0.001) lowest[k] = std::min(lowest[k], spline.at(x));
  }
  EXPECT_LT(lowest[0], -0.01);
  EXPECT_EQ(lowest[1], 0.0);
}

TEST(Spline, OfMakimaKindKeepsFlatDataFlat) {
  SampledCurve steps;
  for (int i = 0; i < 9; ++i) {
    steps.x.push_back(i);
    steps.y.push_back(i < 4 ? 0.0 : 1.0);
  }
  const auto spline = through(steps, 1, SplineKind::Makima);
  for (const double x : {0.5, 1.5, 2.5}) EXPECT_EQ(spline.at(x), 0.0);
}

TEST(DataSlopes, AreExactForAParabola) {
  SampledCurve curve;
  for (const double x : {0.0, 0.3, 0.5, 1.2, 1.3, 2.0}) {
    curve.x.push_back(x);
    curve.y.push_back(2.0 - 3.0 * x + 4.0 * x * x);
  }
  const auto slopes = dataSlopes(curve);
  for (std::size_t i = 1; i + 1 < curve.size(); ++i) {
    EXPECT_NEAR(slopes[i], -3.0 + 8.0 * curve.x[i], 1e-12);
  }
}

TEST(ApproximationError, DistinguishesThePapersErrorFromOneDefinedAtZeroForce) {
  auto curve = sampled(cubic, 2.0, 201);
  curve.y[3] = 1e-9;  // nearly nothing: the published error explodes there
  const auto spline = through(curve, 10, SplineKind::Linear);
  const auto error = errorOf(curve, spline, 0.5);
  EXPECT_GT(error.published, 1e6);
  EXPECT_EQ(error.publishedPosition, curve.x[3]);
  EXPECT_LT(error.floored, 3.0);
  EXPECT_LE(error.rms, error.largest);
  EXPECT_LT(error.rSquared, 1.0);
}

}  // namespace spline_test
}  // namespace haptics::reaming

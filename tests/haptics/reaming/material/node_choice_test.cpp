#include "haptics/reaming/material/node_choice.h"

#include <algorithm>
#include <cmath>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "haptics/reaming/material/synthetic_series.h"
#include "tests/support/long_form.h"
#include "tests/support/test_data.h"

namespace haptics::reaming {
namespace node_choice_test {

constexpr double kFloor = 10.0;  // [N]

/// What a noise-free specimen feels like, as sampled at so many places.
SampledCurve curveOfSpecimen(std::size_t places) {
  auto truth = noiselessSeries({.hardness = 0.7, .seed = 3});
  const auto curve = curveOver(truth.displacement, truth.force);
  auto result = normalised(curve, places);
  for (double& x : result.x) x *= curve.x.back();
  return result;
}

constexpr SplineKind kKinds[]{
    SplineKind::HermiteDataSlope,
    SplineKind::Pchip,
    SplineKind::Makima,
    SplineKind::NaturalCubic,
    SplineKind::Linear};

NodeCriterion nodeCriterion(
    double error, NodeRule rule, SplineKind kind = SplineKind::HermiteDataSlope) {
  return {rule, kind, error, kFloor};
}

void expectSound(const NodeChoice& choice, const SampledCurve& curve) {
  EXPECT_EQ(choice.nodes.front(), 0U);
  EXPECT_EQ(choice.nodes.back(), curve.size() - 1);
  EXPECT_TRUE(std::is_sorted(choice.nodes.begin(), choice.nodes.end()));
  EXPECT_EQ(std::adjacent_find(choice.nodes.begin(), choice.nodes.end()), choice.nodes.end());
}

/// The largest error of the spline itself, not of what chose the nodes.
double errorOfSpline(const SampledCurve& curve, const NodeChoice& choice, SplineKind kind) {
  return errorOf(curve, splineThrough(curve, dataSlopes(curve), choice.nodes, kind), kFloor)
      .floored;
}

TEST(NodeChoice, MeetsTheErrorThatWasWanted) {
  const auto curve = curveOfSpecimen(2000);
  for (const double wanted : {0.41, 0.14, 0.05, 0.01}) {
    for (const auto rule : {NodeRule::Greedy, NodeRule::Optimal}) {
      const auto choice = chooseNodes(curve, nodeCriterion(wanted, rule));
      expectSound(choice, curve);
      EXPECT_LE(choice.error, wanted);
      EXPECT_TRUE(choice.isMet);
    }
  }
}

TEST(NodeChoice, MeetsTheErrorOfTheRequestedSpline) {
  const auto curve = curveOfSpecimen(2000);
  for (const auto kind : kKinds) {
    for (const double wanted : {0.41, 0.05, 0.01}) {
      const auto choice = chooseNodes(curve, nodeCriterion(wanted, NodeRule::Greedy, kind));
      expectSound(choice, curve);
      EXPECT_LE(errorOfSpline(curve, choice, kind), wanted);
      EXPECT_NEAR(errorOfSpline(curve, choice, kind), choice.error, 1e-9);
      EXPECT_LT(choice.nodes.size(), 400U);
    }
  }
}

TEST(NodeChoice, ReportsIfTheErrorIsNotMet) {
  const auto curve = curveOfSpecimen(2000);
  const auto choice = chooseNodes(curve, nodeCriterion(1e-6, NodeRule::Thinned));
  EXPECT_FALSE(choice.isMet);
  EXPECT_GT(choice.error, 1e-6);
}

TEST(NodeChoice, FindsTheFewestOnlyForLocalKinds) {
  for (const auto kind : kKinds) {
    EXPECT_EQ(problemOf(nodeCriterion(0.1, NodeRule::Optimal, kind)).has_value(), !isLocal(kind));
    EXPECT_FALSE(problemOf(nodeCriterion(0.1, NodeRule::Greedy, kind)));
  }
}

TEST(NodeChoice, NeedsAtMostTwiceAsManyNodesAsThereHaveToBe) {
  const auto curve = curveOfSpecimen(2000);
  for (const double wanted : {0.41, 0.14, 0.05, 0.01}) {  // T2
    const auto greedy = chooseNodes(curve, nodeCriterion(wanted, NodeRule::Greedy)).nodes.size();
    const auto fewest = chooseNodes(curve, nodeCriterion(wanted, NodeRule::Optimal)).nodes.size();
    EXPECT_LE(greedy, 2 * fewest) << wanted;
    EXPECT_GE(greedy, fewest) << wanted;
  }
}

TEST(NodeChoice, OfThePaperTakenLiterallyHasThePapersError) {
  // No force is 0 here: e_a = |v - v̂| / |v| is defined everywhere.
  auto curve = curveOfSpecimen(2000);
  for (double& y : curve.y) y += 1.0;
  for (const auto kind : {SplineKind::NaturalCubic, SplineKind::HermiteDataSlope}) {
    const auto choice = chooseNodes(curve, nodeCriterion(0.41, NodeRule::PaperLiteral, kind));
    expectSound(choice, curve);
    const auto spline = splineThrough(curve, dataSlopes(curve), choice.nodes, kind);
    const auto error = errorOf(curve, spline, kFloor);
    EXPECT_LE(error.published, 0.41);
    EXPECT_NEAR(error.published, choice.error, 1e-9);
    EXPECT_LT(error.floored, error.published);
  }
}

TEST(NodeChoice, OfThePaperTakenLiterallySelectsRunsOfSamples) {
  auto curve = curveOfSpecimen(2000);
  for (double& y : curve.y) y += 20.0;
  const auto literal = chooseNodes(curve, nodeCriterion(0.05, NodeRule::PaperLiteral)).nodes.size();
  const auto greedy = chooseNodes(curve, nodeCriterion(0.05, NodeRule::Greedy)).nodes.size();
  EXPECT_GT(literal, 10 * greedy);
}

TEST(NodeChoice, OfAGivenNumberHasTheLeastErrorOfItsSpline) {
  const auto curve = curveOfSpecimen(tests::isLong() ? 2001 : 501);
  for (const auto kind : kKinds) {
    double before = 1e9;
    for (const std::size_t count : {6U, 12U}) {
      const auto choice = chooseNodes(curve, count, nodeCriterion(0.05, NodeRule::Greedy, kind));
      expectSound(choice, curve);
      EXPECT_EQ(choice.nodes.size(), count);
      EXPECT_NEAR(errorOfSpline(curve, choice, kind), choice.error, 1e-9);
      EXPECT_LT(choice.error, before) << static_cast<int>(kind) << ' ' << count;
      before = choice.error;
      // As few as a rule needs for that error, and no better.
      if (!isLocal(kind)) continue;
      const auto fewest =
          chooseNodes(curve, nodeCriterion(0.98 * choice.error, NodeRule::Optimal, kind));
      EXPECT_GE(fewest.nodes.size(), count) << count;
    }
  }
}

/// The curve of nodes_reference.py.
SampledCurve curveOfReference() {
  const auto step = [](double x, double at, double width) {
    return 1.0 / (1.0 + std::exp(-(x - at) / width));
  };
  SampledCurve curve;
  for (int i = 0; i <= 2000; ++i) {
    const double x = 12.0 * i / 2000.0;
    const double past = std::max(0.0, x - 3.6);
    curve.x.push_back(x);
    curve.y.push_back(
        5.0 + 110.0 * step(x, 3.6, 0.30) - 45.0 * step(x, 5.2, 0.35) + 9.0 * past +
        0.9 * past * past);
  }
  return curve;
}

TEST(NodeChoice, OfTwelveNodesIsAtLeastAsGoodAsTheSearchOfSciPy) {
  // tests/data/reaming/nodes_reference.py
  std::ifstream file(tests::testData("reaming/nodes_golden.json"));
  const auto golden = nlohmann::json::parse(file);
  const auto curve = curveOfReference();
  for (const auto& wanted : golden.at("splines")) {
    const auto kind = wanted.at("kind") == "cubic-natural" ? SplineKind::NaturalCubic
                                                           : SplineKind::HermiteDataSlope;
    const auto asked = nodeCriterion(0.05, NodeRule::Greedy, kind);
    const SplineDeviation deviation(curve, asked);
    const auto even = wanted.at("even_nodes").get<std::vector<std::size_t>>();
    const auto best = wanted.at("best_nodes").get<std::vector<std::size_t>>();
    EXPECT_NEAR(deviation.worstOfSpline(even).error, wanted.at("even_error").get<double>(), 1e-9);
    EXPECT_NEAR(deviation.worstOfSpline(best).error, wanted.at("best_error").get<double>(), 1e-9);
    const auto choice = chooseNodes(curve, best.size(), asked);
    EXPECT_LE(choice.error, 1.02 * wanted.at("best_error").get<double>()) << wanted.at("kind");
  }
}

TEST(SplineComparison, HasBothErrorsAndThoseAtTheSamePlace) {
  const auto curve = curveOfReference();
  const auto nodes =
      chooseNodes(curve, 12, nodeCriterion(0.05, NodeRule::Greedy, SplineKind::NaturalCubic));
  const auto comparison = compareSplines(curve, nodes.nodes, kFloor);
  ASSERT_EQ(comparison.splines.size(), 2U);
  const auto& cubic = comparison.splines[0];
  const auto& hermite = comparison.splines[1];
  EXPECT_EQ(cubic.kind, SplineKind::NaturalCubic);
  EXPECT_EQ(hermite.kind, SplineKind::HermiteDataSlope);
  EXPECT_EQ(cubic.flooredErrorAtWorst, cubic.error.floored);
  EXPECT_EQ(cubic.publishedErrorAtWorst, cubic.error.published);
  EXPECT_NEAR(cubic.error.floored, nodes.error, 1e-9);
  const double there = cubic.error.flooredPosition;
  const auto at = std::lower_bound(curve.x.begin(), curve.x.end(), there) - curve.x.begin();
  const double v = curve.y[static_cast<std::size_t>(at)];
  EXPECT_NEAR(
      hermite.flooredErrorAtWorst,
      std::abs(hermite.spline.at(there) - v) / std::max(std::abs(v), kFloor),
      1e-12);
  EXPECT_LE(hermite.flooredErrorAtWorst, hermite.error.floored);
}

TEST(NodeChoice, ThinsRunsToOneNodeEach) {
  const auto curve = curveOfSpecimen(2000);
  const auto literal = chooseNodes(curve, nodeCriterion(0.14, NodeRule::PaperLiteral));
  const auto thinned = chooseNodes(curve, nodeCriterion(0.14, NodeRule::Thinned));
  expectSound(thinned, curve);
  EXPECT_LT(thinned.nodes.size(), literal.nodes.size());
}

TEST(NodeChoice, TakesTwoNodesForAStraightLine) {
  SampledCurve line;
  for (int i = 0; i < 500; ++i) {
    line.x.push_back(0.1 * i);
    line.y.push_back(3.0 * i);
  }
  EXPECT_EQ(chooseNodes(line, nodeCriterion(0.01, NodeRule::Greedy)).nodes.size(), 2U);
  EXPECT_EQ(chooseNodes(line, nodeCriterion(0.01, NodeRule::Optimal)).nodes.size(), 2U);
}

}  // namespace node_choice_test
}  // namespace haptics::reaming

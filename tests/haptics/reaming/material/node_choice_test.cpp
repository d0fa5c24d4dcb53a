#include "haptics/reaming/material/node_choice.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "haptics/reaming/material/synthetic_series.h"

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

void expectSound(const NodeChoice& choice, const SampledCurve& curve) {
  EXPECT_EQ(choice.nodes.front(), 0U);
  EXPECT_EQ(choice.nodes.back(), curve.size() - 1);
  EXPECT_TRUE(std::is_sorted(choice.nodes.begin(), choice.nodes.end()));
  EXPECT_EQ(std::adjacent_find(choice.nodes.begin(), choice.nodes.end()), choice.nodes.end());
}

TEST(NodeChoice, MeetsTheErrorThatWasWanted) {
  const auto curve = curveOfSpecimen(2000);
  for (const double wanted : {0.41, 0.14, 0.05, 0.01}) {
    for (const auto rule : {NodeRule::Greedy, NodeRule::Optimal, NodeRule::PaperLiteral}) {
      const auto choice = chooseNodes(curve, wanted, kFloor, rule);
      expectSound(choice, curve);
      EXPECT_LE(choice.error, wanted);
    }
  }
}

TEST(NodeChoice, NeedsAtMostTwiceAsManyNodesAsThereHaveToBe) {
  const auto curve = curveOfSpecimen(2000);
  for (const double wanted : {0.41, 0.14, 0.05, 0.01}) {  // T2
    const auto greedy = chooseNodes(curve, wanted, kFloor, NodeRule::Greedy).nodes.size();
    const auto fewest = chooseNodes(curve, wanted, kFloor, NodeRule::Optimal).nodes.size();
    EXPECT_LE(greedy, 2 * fewest) << wanted;
    EXPECT_GE(greedy, fewest) << wanted;
  }
}

TEST(NodeChoice, OfThePaperTakenLiterallySelectsRunsOfSamples) {
  const auto curve = curveOfSpecimen(2000);
  const auto literal = chooseNodes(curve, 0.05, kFloor, NodeRule::PaperLiteral).nodes.size();
  const auto greedy = chooseNodes(curve, 0.05, kFloor, NodeRule::Greedy).nodes.size();
  EXPECT_GT(literal, 10 * greedy);
}

TEST(NodeChoice, ThinsRunsToOneNodeEach) {
  const auto curve = curveOfSpecimen(2000);
  const auto literal = chooseNodes(curve, 0.14, kFloor, NodeRule::PaperLiteral);
  const auto thinned = chooseNodes(curve, 0.14, kFloor, NodeRule::Thinned);
  expectSound(thinned, curve);
  EXPECT_LT(thinned.nodes.size(), literal.nodes.size());
}

TEST(NodeChoice, TakesTwoNodesForAStraightLine) {
  SampledCurve line;
  for (int i = 0; i < 500; ++i) {
    line.x.push_back(0.1 * i);
    line.y.push_back(3.0 * i);
  }
  EXPECT_EQ(chooseNodes(line, 0.01, 1.0, NodeRule::Greedy).nodes.size(), 2U);
  EXPECT_EQ(chooseNodes(line, 0.01, 1.0, NodeRule::Optimal).nodes.size(), 2U);
}

}  // namespace node_choice_test
}  // namespace haptics::reaming

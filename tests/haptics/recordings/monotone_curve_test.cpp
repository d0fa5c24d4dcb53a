#include <random>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "haptics/recordings/force_curve.h"

namespace haptics::recordings {
namespace monotone_curve_test {

using Points = std::vector<CurvePoint>;

TEST(MonotoneCurve, LeavesARisingTravelAlone) {
  const Points rising{{1.0, 0.0}, {2.0, 3.0}, {2.5, 1.0}};
  const MonotoneCurve made = monotoneCurve(rising);
  EXPECT_EQ(made.curve.nodes(), rising);
  EXPECT_EQ(made.samples, 3U);
  EXPECT_EQ(made.merged, 0U);
}

TEST(MonotoneCurve, MergesEqualTravelsIntoTheirMean) {
  const MonotoneCurve made =
      monotoneCurve(Points{{1.0, 0.0}, {2.0, 3.0}, {2.0, 6.0}, {2.0, 9.0}, {3.0, 1.0}});
  EXPECT_EQ(made.curve.nodes(), (Points{{1.0, 0.0}, {2.0, 6.0}, {3.0, 1.0}}));
  EXPECT_EQ(made.merged, 2U);
}

TEST(MonotoneCurve, MergesAHandThatGoesBackIntoItsMean) {
  // By hand: 1 | (3 + 2)/2 | (4 + 3.5 + 2.5)/3 | 5.
  const MonotoneCurve made = monotoneCurve(
      Points{{1.0, 0.0}, {3.0, 1.0}, {2.0, 2.0}, {4.0, 3.0}, {3.5, 4.0}, {2.5, 5.0}, {5.0, 6.0}});
  const Points& nodes = made.curve.nodes();
  ASSERT_EQ(nodes.size(), 4U);
  EXPECT_DOUBLE_EQ(nodes[1].travel, 2.5);
  EXPECT_DOUBLE_EQ(nodes[1].force, 1.5);
  EXPECT_NEAR(nodes[2].travel, 10.0 / 3.0, 1e-12);
  EXPECT_NEAR(nodes[2].force, 4.0, 1e-12);
  EXPECT_EQ(made.merged, 3U);
}

TEST(MonotoneCurve, TurnsAnyTremblingIntoARisingCurve) {
  std::mt19937 random(5);
  std::normal_distribution<double> tremble(0.0, 0.3);
  Points samples;
  for (int i = 0; i < 2000; ++i) samples.push_back({0.005 * i + tremble(random), tremble(random)});
  const MonotoneCurve made = monotoneCurve(samples);  // throws if the travel did not rise
  EXPECT_EQ(made.curve.nodes().size() + made.merged, samples.size());
  EXPECT_GT(made.curve.nodes().size(), 20U);
}

TEST(MonotoneCurve, RefusesAHandThatDidNotClose) {
  EXPECT_THROW(monotoneCurve(Points{}), std::invalid_argument);
  EXPECT_THROW(monotoneCurve(Points{{1.0, 1.0}, {1.0, 2.0}}), std::invalid_argument);
  EXPECT_THROW(monotoneCurve(Points{{3.0, 1.0}, {2.0, 2.0}, {1.0, 2.0}}), std::invalid_argument);
}

}  // namespace monotone_curve_test
}  // namespace haptics::recordings

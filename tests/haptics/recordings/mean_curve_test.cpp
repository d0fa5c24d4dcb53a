#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "haptics/recordings/force_curve.h"

namespace haptics::recordings {
namespace mean_curve_test {

using Curves = std::vector<ForceCurve>;

ForceCurve line(double start, double end, double slope) {
  return ForceCurve({{start, slope * start}, {end, slope * end}});
}

TEST(MeanCurve, IsTheMeanWhereAllCurvesAre) {
  const auto mean =
      meanCurve(Curves{line(0.0, 10.0, 1.0), line(2.0, 11.0, 2.0), line(1.0, 9.0, 6.0)});
  ASSERT_TRUE(mean);
  EXPECT_EQ(mean->curve.nodes().size(), MeanCurve::kNodes);
  EXPECT_DOUBLE_EQ(mean->curve.start(), 2.0);
  EXPECT_DOUBLE_EQ(mean->curve.end(), 9.0);
  EXPECT_NEAR(mean->curve.forceAt(5.0), 15.0, 1e-12);
  EXPECT_NEAR(mean->deviation.front(), std::sqrt(28.0), 1e-12);  // of 2, 4 and 12 N
}

TEST(MeanCurve, OfOneCurveHasNoDeviation) {
  const auto mean = meanCurve(Curves{line(0.0, 10.0, 1.0)});
  ASSERT_TRUE(mean);
  for (const double deviation : mean->deviation) EXPECT_EQ(deviation, 0.0);
}

TEST(MeanCurve, IsNothingWhereNothingIsShared) {
  EXPECT_FALSE(meanCurve(Curves{}));
  EXPECT_FALSE(meanCurve(Curves{line(0.0, 4.0, 1.0), line(4.0, 9.0, 1.0)}));
  EXPECT_FALSE(indexOfMostTypical(Curves{line(0.0, 4.0, 1.0), line(5.0, 9.0, 1.0)}));
}

TEST(MeanCurve, KnowsItsNearestCurve) {
  EXPECT_EQ(
      indexOfMostTypical(Curves{line(0.0, 9.0, 0.5), line(0.0, 9.0, 1.1), line(0.0, 9.0, 2.0)}),
      1U);
  EXPECT_EQ(indexOfMostTypical(Curves{line(0.0, 9.0, 1.0), line(0.0, 9.0, 1.0)}), 0U);
}

}  // namespace mean_curve_test
}  // namespace haptics::recordings

#include "haptics/recordings/force_curve.h"

#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

namespace haptics::recordings {
namespace force_curve_test {

TEST(ForceCurve, IsStraightBetweenItsNodesAndHoldsItsEnds) {
  const ForceCurve curve({{2.0, 0.0}, {4.0, 1.0}, {5.0, 4.0}});
  EXPECT_DOUBLE_EQ(curve.forceAt(3.0), 0.5);
  EXPECT_DOUBLE_EQ(curve.forceAt(4.0), 1.0);
  EXPECT_DOUBLE_EQ(curve.forceAt(4.5), 2.5);
  EXPECT_DOUBLE_EQ(curve.forceAt(-9.0), 0.0);
  EXPECT_DOUBLE_EQ(curve.forceAt(99.0), 4.0);
  EXPECT_DOUBLE_EQ(curve.forceAt(std::numeric_limits<double>::quiet_NaN()), 0.0);
}

TEST(ForceCurve, KnowsItsLargestSlopeUpOrDown) {
  EXPECT_DOUBLE_EQ(ForceCurve({{0.0, 0.0}, {1.0, 2.0}, {2.0, 1.0}}).largestSlope(), 2.0);
  EXPECT_DOUBLE_EQ(ForceCurve({{0.0, 0.0}, {1.0, 2.0}, {1.5, 0.0}}).largestSlope(), 4.0);
}

TEST(ForceCurve, CannotBeBuiltFromWhatIsNone) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(ForceCurve({}), std::invalid_argument);
  EXPECT_THROW(ForceCurve({{1.0, 1.0}}), std::invalid_argument);
  EXPECT_THROW(ForceCurve({{1.0, 1.0}, {1.0, 2.0}}), std::invalid_argument);
  EXPECT_THROW(ForceCurve({{2.0, 1.0}, {1.0, 2.0}}), std::invalid_argument);
  EXPECT_THROW(ForceCurve({{1.0, 1.0}, {kNan, 2.0}}), std::invalid_argument);
  EXPECT_THROW(ForceCurve({{1.0, 1.0}, {2.0, kNan}}), std::invalid_argument);
}

}  // namespace force_curve_test
}  // namespace haptics::recordings

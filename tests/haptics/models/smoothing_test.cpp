#include "haptics/models/smoothing.h"

#include <gtest/gtest.h>

namespace haptics::models {
namespace smoothing_test {

TEST(MovingAverage, ChangesNothingIfThereIsNone) {
  MovingAverage<double> average(Smoothing::None);
  EXPECT_EQ(average.feed(1.0), 1.0);
  EXPECT_EQ(average.feed(5.0), 5.0);
}

TEST(MovingAverage, HidesASquareWaveOfTwoPoints) {
  MovingAverage<double> average(Smoothing::TwoPoint);
  average.feed(1.0);
  for (int i = 0; i < 10; ++i) EXPECT_EQ(average.feed(i % 2 == 0 ? 3.0 : 1.0), 2.0);
}

TEST(MovingAverage, FeedsItselfAndLeavesThePresentOutAsTheFirmwareDoes) {
  MovingAverage<double> average(Smoothing::AuthorsFirmware);
  EXPECT_DOUBLE_EQ(average.feed(3.0), 3.0);
  EXPECT_DOUBLE_EQ(average.feed(9.0), 3.0);         // the present is not in it
  EXPECT_DOUBLE_EQ(average.feed(9.0), 5.0);         // (3 + 9 + 3) / 3
  EXPECT_DOUBLE_EQ(average.feed(9.0), 23.0 / 3.0);  // (5 + 9 + 9) / 3
}

TEST(MovingAverage, StartsAgainAfterAReset) {
  MovingAverage<double> average(Smoothing::AuthorsFirmware);
  average.feed(100.0);
  average.reset();
  EXPECT_DOUBLE_EQ(average.feed(2.0), 2.0);
}

}  // namespace smoothing_test
}  // namespace haptics::models

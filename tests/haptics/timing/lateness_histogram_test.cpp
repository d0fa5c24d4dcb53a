#include <gtest/gtest.h>

#include "haptics/timing/clock_statistics.h"

namespace haptics::timing {
namespace lateness_histogram_test {

TEST(LatenessHistogram, FindsQuantilesToASixteenth) {
  LatenessHistogram histogram;
  for (int i = 1; i <= 10'000; ++i) histogram.add(i);
  EXPECT_NEAR(histogram.quantile(0.5) / 5000.0, 1.0, 1.0 / 16);
  EXPECT_NEAR(histogram.quantile(0.99) / 9900.0, 1.0, 1.0 / 16);
  EXPECT_EQ(histogram.largest(), 10'000.0);
  EXPECT_EQ(histogram.quantile(1.0), 10'000.0);
  EXPECT_EQ(histogram.count(), 10'000U);
}

TEST(LatenessHistogram, NeverUnderstates) {
  for (const double lateness : {0.01, 0.5, 1.0, 7.3, 1000.0, 123'456.7}) {
    LatenessHistogram histogram;
    histogram.add(lateness);
    histogram.add(1e9);
    EXPECT_GE(histogram.quantile(0.5), lateness);
    EXPECT_LE(histogram.quantile(0.5), std::max(lateness * 17.0 / 16.0, 1.0 / 8.0));
  }
}

TEST(LatenessHistogram, CountsEarlyTicksAndNaNAsPunctual) {
  LatenessHistogram histogram;
  histogram.add(-5.0);
  histogram.add(__builtin_nan(""));
  EXPECT_EQ(histogram.count(), 2U);
  EXPECT_EQ(histogram.largest(), 0.0);
}

TEST(LatenessHistogram, IsZeroWithoutTicks) {
  EXPECT_EQ(LatenessHistogram().quantile(0.99), 0.0);
}

}  // namespace lateness_histogram_test
}  // namespace haptics::timing

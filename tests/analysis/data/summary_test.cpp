#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "analysis/data/moments.h"

namespace summary_test {

using analysis::summarise;
using Values = std::vector<double>;

TEST(Summary, HasMeanVarianceAndDeviation) {
  const auto summary = summarise(Values{2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0});

  EXPECT_EQ(summary.n, 8U);
  EXPECT_EQ(summary.mean, 5.0);
  EXPECT_EQ(summary.variance, 32.0 / 7.0);
  EXPECT_EQ(summary.standardDeviation, std::sqrt(32.0 / 7.0));
}

TEST(Summary, OfNoValuesIsEmpty) {
  const auto summary = summarise(Values{});
  EXPECT_EQ(summary.n, 0U);
  EXPECT_FALSE(summary.mean.has_value());
  EXPECT_FALSE(summary.variance.has_value());
}

TEST(Summary, HasNoVarianceForOneValue) {
  const auto summary = summarise(Values{4.5});
  EXPECT_EQ(summary.mean, 4.5);
  EXPECT_FALSE(summary.variance.has_value());
  EXPECT_FALSE(summary.standardDeviation.has_value());
}

TEST(Summary, HasZeroVarianceWhereAllValuesAreEqual) {
  EXPECT_EQ(summarise(Values{0.1, 0.1, 0.1}).variance, 0.0);
  EXPECT_EQ(summarise(Values{0.1, 0.1, 0.1}).mean, 0.1);
  EXPECT_EQ(summarise(Values{0.0, -0.0}).variance, 0.0);
}

TEST(Summary, KeepsItsDigitsWithALargeOffset) {
  // The variance of 1, 2, 4 is 7/3; all these values are doubles.
  for (const double offset : {1e6, 1e9, 1e15, -4e15}) {
    EXPECT_EQ(summarise(Values{offset + 1, offset + 2, offset + 4}).variance, 7.0 / 3.0) << offset;
  }
}

TEST(Summary, DoesNotDependOnTheOrder) {
  Values values{1e9, 3.0, -1e-9, 0.1, 7e5, -1e9};
  const auto before = summarise(values);
  std::ranges::sort(values);
  const auto after = summarise(values);

  EXPECT_EQ(before.mean, after.mean);
  EXPECT_EQ(before.variance, after.variance);
}

TEST(Summary, HasADeviationWhereTheVarianceOverflows) {
  for (const double unit : {1e-200, 1e200}) {
    const auto summary = summarise(Values{1.0 * unit, 2.0 * unit, 3.0 * unit});
    EXPECT_DOUBLE_EQ(summary.mean.value(), 2.0 * unit);
    EXPECT_FALSE(summary.variance.has_value());
    EXPECT_DOUBLE_EQ(summary.standardDeviation.value(), unit);
  }
}

TEST(Summary, CoversTheRangeOfDoubles) {
  const double largest = std::numeric_limits<double>::max();
  const double smallest = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(summarise(Values{largest, largest}).mean, largest);
  EXPECT_EQ(summarise(Values{largest, -largest}).mean, 0.0);
  EXPECT_EQ(summarise(Values{smallest, smallest}).mean, smallest);
  EXPECT_EQ(summarise(Values{smallest, smallest}).variance, 0.0);
}

TEST(Summary, RejectsInfinityAndNaN) {
  EXPECT_THROW(summarise(Values{1.0, std::nan("")}), std::invalid_argument);
  EXPECT_THROW(summarise(Values{1.0, INFINITY}), std::invalid_argument);
}

}  // namespace summary_test

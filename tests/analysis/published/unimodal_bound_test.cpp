#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/data/likert_counts.h"

namespace unimodal_bound_test {

using analysis::exceedsUnimodalVariance;
using analysis::largestUnimodalVariance;
using analysis::LikertCounts;

bool hasOnePeak(const std::vector<int>& weights) {
  const auto peak = std::max_element(weights.begin(), weights.end());
  return std::is_sorted(weights.begin(), peak) &&
         std::is_sorted(peak, weights.end(), std::greater<>());
}

/// Calls @p see with every way to share @p left among the points from @p at on.
template <typename See>
void eachShare(std::vector<int>& weights, std::size_t at, int left, const See& see) {
  if (at + 1 == weights.size()) {
    weights[at] = left;
    see(weights);
    return;
  }
  for (int weight = 0; weight <= left; ++weight) {
    weights[at] = weight;
    eachShare(weights, at + 1, left - weight, see);
  }
}

TEST(UnimodalBound, BoundsEveryDistributionOfTwentyAnswersClosely) {
  constexpr int kAnswers = 20;
  std::vector<int> weights(5);
  double closest = 1e9;
  int seen = 0;
  eachShare(weights, 0, kAnswers, [&](const std::vector<int>& of) {
    if (!hasOnePeak(of)) return;
    double sum = 0.0;
    double square = 0.0;
    for (int i = 0; i < 5; ++i) {
      sum += (1 + i) * of[static_cast<std::size_t>(i)];
      square += (1 + i) * (1 + i) * of[static_cast<std::size_t>(i)];
    }
    const double mean = sum / kAnswers;
    const double variance = square / kAnswers - mean * mean;
    const double bound = largestUnimodalVariance(1, 5, mean);
    EXPECT_LE(variance, bound + 1e-9) << mean;
    closest = std::min(closest, bound - variance);
    ++seen;
  });
  EXPECT_GT(seen, 1000);
  EXPECT_LT(closest, 1e-9);
}

TEST(UnimodalBound, IsThatOfTheUniformDistributionAtTheMiddle) {
  EXPECT_NEAR(largestUnimodalVariance(1, 5, 3.0), 2.0, 1e-14);
  EXPECT_NEAR(largestUnimodalVariance(-3, 3, 0.0), 4.0, 1e-14);
  EXPECT_NEAR(largestUnimodalVariance(1, 5, 1.0), 0.0, 1e-14);
  EXPECT_NEAR(largestUnimodalVariance(1, 5, 5.0), 0.0, 1e-14);
}

TEST(UnimodalBound, DoesNotDependOnTheLowestPoint) {
  EXPECT_NEAR(
      largestUnimodalVariance(100001, 100005, 100002.6), largestUnimodalVariance(1, 5, 2.6), 1e-9);
}

// Table 2 of the punch paper prints variances of 2.6 and 2.4 for means of 2.6 and 3.2 of 36 answers
// (± 0.05): no distribution with one peak has more than 2.31 and 2.25.
TEST(UnimodalBound, IsExceededByThePublishedTable) {
  constexpr double kSampleFactor = 36.0 / 35.0;
  EXPECT_NEAR(kSampleFactor * largestUnimodalVariance(1, 5, 2.55), 2.31, 0.005);
  EXPECT_NEAR(kSampleFactor * largestUnimodalVariance(1, 5, 3.25), 2.25, 0.005);
}

TEST(UnimodalBound, IsExceededIfAllAnswersAreAtTheEnds) {
  LikertCounts extremes(1, 5);
  extremes.add(1, 9);
  extremes.add(5, 9);
  EXPECT_EQ(exceedsUnimodalVariance(extremes), true);
  LikertCounts even(1, 5);
  for (int point = 1; point <= 5; ++point) even.add(point, 4);
  EXPECT_EQ(exceedsUnimodalVariance(even), false);
  LikertCounts one(1, 5);
  one.add(3);
  EXPECT_EQ(exceedsUnimodalVariance(one), std::nullopt);
}

TEST(UnimodalBound, RejectsInvalidArguments) {
  EXPECT_THROW(largestUnimodalVariance(1, 1, 1.0), std::invalid_argument);
  EXPECT_THROW(largestUnimodalVariance(1, 5, 5.1), std::invalid_argument);
  EXPECT_THROW(largestUnimodalVariance(1, 5, std::nan("")), std::invalid_argument);
}

}  // namespace unimodal_bound_test

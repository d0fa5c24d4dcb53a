#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/effects/effect_size.h"
#include "analysis/hypothesis_tests/rank_tests.h"

namespace mann_whitney_test {

using analysis::brunnerMunzelTest;
using analysis::cliffDelta;
using analysis::mannWhitneyTest;
using analysis::TiedGroups;
using Values = std::vector<double>;

// Hollander & Wolfe 1973, p. 69: permeability at term and at 12 to 26 weeks (R: ?wilcox.test)
const Values kAtTerm{0.80, 0.83, 1.89, 1.04, 1.45, 1.38, 1.91, 1.64, 0.73, 1.46};
const Values kBefore{1.15, 0.88, 0.90, 0.74, 1.21};

// Brunner & Munzel 2000: pain scores after laparoscopy (R: brunnermunzel::brunnermunzel.test)
const Values kPain1{1, 2, 1, 1, 1, 1, 1, 1, 1, 1, 2, 4, 1, 1};
const Values kPain2{3, 3, 4, 3, 1, 2, 3, 1, 1, 5, 4};

/// How many of all choices of group 1 have a U of at least, at most, or as far off as the observed.
struct Slow {
  double less = 0.0;
  double greater = 0.0;
};

double slowU(const Values& x, const Values& y) {
  double u = 0.0;
  for (const double a : x) {
    for (const double b : y) u += a > b ? 1.0 : a == b ? 0.5 : 0.0;
  }
  return u;
}

Slow slow(const Values& x, const Values& y) {
  Values all = x;
  all.insert(all.end(), y.begin(), y.end());
  const double observed = slowU(x, y);
  std::vector<int> choice(all.size(), 0);
  std::fill_n(choice.rbegin(), x.size(), 1);
  Slow counts;
  double total = 0.0;
  do {
    Values first;
    Values second;
    for (std::size_t i = 0; i < all.size(); ++i)
      (choice[i] == 1 ? first : second).push_back(all[i]);
    const double u = slowU(first, second);
    total += 1.0;
    counts.less += u <= observed ? 1.0 : 0.0;
    counts.greater += u >= observed ? 1.0 : 0.0;
  } while (std::ranges::next_permutation(choice).found);
  return {counts.less / total, counts.greater / total};
}

TEST(MannWhitneyTest, HasThePublishedPOfPermeability) {
  const auto result = mannWhitneyTest(kAtTerm, kBefore);
  EXPECT_EQ(result.u, 35.0);  // R: W = 35, p-value = 0.1272 one-sided
  EXPECT_NEAR(result.pGreater.value(), 0.1272, 0.00005);
  EXPECT_DOUBLE_EQ(result.pGreater.value(), slow(kAtTerm, kBefore).greater);
  EXPECT_EQ(result.reason.key(), "");
}

TEST(MannWhitneyTest, CountsTiesAsGoingThroughAllChoices) {
  for (const auto& [x, y] : std::vector<std::pair<Values, Values>>{
           {{1, 1, 2, 5}, {2, 3, 3, 5, 5, 5}},
           {{4, 4, 4, 4, 5, 1}, {4, 4, 1}},
           {{1, 2}, {2, 2, 2, 2, 2, 3}},
           {{1}, {1, 1, 2}}}) {
    const auto result = mannWhitneyTest(x, y);
    const Slow truth = slow(x, y);
    EXPECT_DOUBLE_EQ(result.pLess.value(), truth.less);
    EXPECT_DOUBLE_EQ(result.pGreater.value(), truth.greater);
    EXPECT_DOUBLE_EQ(result.p.value(), std::min(1.0, 2.0 * std::min(truth.less, truth.greater)));
    EXPECT_EQ(result.u, slowU(x, y));
  }
}

TEST(MannWhitneyTest, MirrorsWithTheGroups) {
  const auto result = mannWhitneyTest(kPain1, kPain2);
  const auto mirror = mannWhitneyTest(kPain2, kPain1);
  EXPECT_DOUBLE_EQ(result.p.value(), mirror.p.value());
  EXPECT_DOUBLE_EQ(result.pLess.value(), mirror.pGreater.value());
  EXPECT_EQ(result.z.value(), -mirror.z.value());
  EXPECT_EQ(result.u.value() + mirror.u.value(), 14.0 * 11.0);
}

TEST(MannWhitneyTest, GivesAReasonIfAllValuesAreEqual) {
  const auto result = mannWhitneyTest(Values{4, 4, 4}, Values{4, 4});
  EXPECT_EQ(result.reason.key(), "all_values_equal");
  EXPECT_EQ(result.p, 1.0);
  EXPECT_EQ(result.variance, 0.0);
  EXPECT_FALSE(result.z.has_value());
  EXPECT_FALSE(result.pAsymptotic.has_value());
}

TEST(MannWhitneyTest, IsUndefinedForAnEmptyGroup) {
  EXPECT_EQ(mannWhitneyTest(Values{}, kBefore).reason.key(), "group_is_empty");
  EXPECT_EQ(mannWhitneyTest(kBefore, Values{}).reason.key(), "group_is_empty");
  EXPECT_FALSE(mannWhitneyTest(kBefore, Values{}).u.has_value());
  EXPECT_THROW(mannWhitneyTest(kBefore, Values{std::nan("")}), std::invalid_argument);
}

TEST(MannWhitneyTest, ReportsGroupsTooLargeForAnExactP) {
  constexpr std::uint64_t kMillion = 1'000'000;
  TiedGroups groups{.n1 = kMillion, .n2 = kMillion, .values = {{kMillion, 0}, {0, kMillion}}};
  const auto result = mannWhitneyTest(groups);
  EXPECT_EQ(result.reason.key(), "too_many_values");
  EXPECT_EQ(result.u, 0.0);
  EXPECT_EQ(result.pAsymptotic, 0.0);
  // σ² = n²/12 (2n + 1 − 2(n³ − n)/(2n(2n − 1))), so that z² = 2n − 1
  EXPECT_NEAR(result.z.value(), -std::sqrt(1'999'999.0), 1e-9);

  groups.n1 = groups.values.front().first = std::uint64_t{1} << 30;
  EXPECT_EQ(mannWhitneyTest(groups).reason.key(), "groups_too_large");
}

TEST(SmallestMannWhitneyP, IsThatOfThePlanningTable) {
  EXPECT_DOUBLE_EQ(
      mannWhitneyTest(Values{1, 2, 3, 4, 5}, Values{6, 7, 8, 9, 10, 11}).p.value(), 2.0 / 462.0);
}

TEST(BrunnerMunzelTest, HasThePublishedPOfPainScores) {
  const auto result = brunnerMunzelTest(kPain1, kPain2);
  // Brunner & Munzel 2000; R: statistic = 3.1375, df = 17.683, p-value = 0.005786, 0.788961
  EXPECT_NEAR(result.w.value(), 3.1375, 0.00005);
  EXPECT_NEAR(result.degreesOfFreedom.value(), 17.683, 0.0005);
  EXPECT_NEAR(result.p.value(), 0.005786, 5e-7);
  EXPECT_NEAR(result.probability.value(), 0.788961, 5e-7);
  EXPECT_DOUBLE_EQ(result.pLess.value(), 0.5 * result.p.value());
  EXPECT_EQ(result.reason.key(), "");
}

TEST(BrunnerMunzelTest, IsUndefinedWithoutOverlap) {
  const auto result = brunnerMunzelTest(Values{1, 2, 2}, Values{3, 4});
  EXPECT_EQ(result.w, std::numeric_limits<double>::infinity());
  EXPECT_EQ(result.probability, 1.0);
  EXPECT_FALSE(result.p.has_value());
  EXPECT_EQ(result.reason.key(), "no_overlap");
}

TEST(BrunnerMunzelTest, IsUndefinedForEqualValuesAndForOneValue) {
  const auto one = brunnerMunzelTest(Values{2}, Values{1, 3, 4});
  EXPECT_EQ(one.reason.key(), "fewer_than_two");
  EXPECT_DOUBLE_EQ(one.probability.value(), 2.0 / 3.0);
  EXPECT_FALSE(one.w.has_value());
  const auto equal = brunnerMunzelTest(Values{3, 3}, Values{3, 3, 3});
  EXPECT_EQ(equal.reason.key(), "all_values_equal");
  EXPECT_EQ(equal.probability, 0.5);
  EXPECT_FALSE(equal.w.has_value());
  EXPECT_FALSE(brunnerMunzelTest(Values{}, Values{}).probability.has_value());
}

TEST(CliffDelta, IsTheShareOfPairsUpLessThoseDown) {
  const auto result = cliffDelta(kPain2, kPain1);
  EXPECT_DOUBLE_EQ(result.delta.value(), 2.0 * slowU(kPain2, kPain1) / 154.0 - 1.0);
  EXPECT_LT(result.interval.value().low, result.delta.value());
  EXPECT_GT(result.interval.value().high, result.delta.value());
}

TEST(CliffDelta, MirrorsWithTheGroups) {
  const auto result = cliffDelta(kPain2, kPain1, 0.9);
  const auto mirror = cliffDelta(kPain1, kPain2, 0.9);
  EXPECT_EQ(result.delta.value(), -mirror.delta.value());
  EXPECT_EQ(result.variance, mirror.variance);
  EXPECT_DOUBLE_EQ(result.interval->low, -mirror.interval->high);
}

TEST(CliffDelta, HasNoIntervalWithoutOverlapOrForOne) {
  const auto apart = cliffDelta(Values{4, 5}, Values{1, 2, 3});
  EXPECT_EQ(apart.delta, 1.0);
  EXPECT_EQ(apart.variance, 0.0);
  EXPECT_FALSE(apart.interval.has_value());
  EXPECT_EQ(apart.reason.key(), "no_overlap_no_interval");
  const auto one = cliffDelta(Values{4}, Values{1, 5});
  EXPECT_EQ(one.delta, 0.0);
  EXPECT_EQ(one.reason.key(), "two_values_needed");
  EXPECT_EQ(cliffDelta(Values{}, Values{1}).reason.key(), "a_group_is_empty");
  EXPECT_THROW(cliffDelta(kPain1, kPain2, 0.0), std::invalid_argument);
}

TEST(CliffDelta, HasAnIntervalIfAllValuesAreEqual) {
  const auto result = cliffDelta(Values{3, 3, 3}, Values{3, 3});
  EXPECT_EQ(result.delta, 0.0);
  EXPECT_EQ(result.variance, 0.0);
  EXPECT_GT(result.interval.value().high, 0.0);  // the variance is held at 1/(n₁n₂ − 1)
}

}  // namespace mann_whitney_test

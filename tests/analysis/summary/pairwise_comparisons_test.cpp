#include "analysis/summary/pairwise_comparisons.h"

#include <stdexcept>

#include <gtest/gtest.h>

namespace pairwise_comparisons_test {

using analysis::comparePairwise;
using analysis::DeclaredPair;
using analysis::LikertCounts;
using analysis::NamedSample;
using Counts = std::vector<std::uint64_t>;

/// The professionals of the synthetic study, whose answers round to the published Table 2.
const std::vector<NamedSample> kMethods{
    {"I", LikertCounts(1, Counts{1, 3, 6, 9, 17})},
    {"F", LikertCounts(1, Counts{13, 7, 4, 4, 8})},
    {"K", LikertCounts(1, Counts{8, 5, 5, 8, 10})}};

const std::vector<DeclaredPair> kPairs{{"I", "F"}, {"I", "K"}, {"K", "F"}};

TEST(PairwiseComparisons, FollowTheDeclaration) {
  const auto family = comparePairwise(kMethods, kPairs);

  ASSERT_EQ(family.rows.size(), 3U);
  EXPECT_EQ(family.rows[2].group1, "K");
  EXPECT_EQ(family.rows[2].group2, "F");
  EXPECT_GT(family.rows[2].estimate.value.value(), 0.0);
}

TEST(PairwiseComparisons, AdjustEachTestForTheirNumber) {
  const auto family = comparePairwise(kMethods, kPairs);

  EXPECT_EQ(family.tests, 3U);
  EXPECT_DOUBLE_EQ(family.alphaPerTest.value(), 0.05 / 3.0);
  // R: 3 * t.test(I, F)$p.value and so on; study_golden.txt
  EXPECT_NEAR(family.rows[0].adjusted.value(), 0.000158610703375827, 1e-15);
  EXPECT_NEAR(family.rows[1].adjusted.value(), 0.0261252574409006, 1e-14);
  EXPECT_NEAR(family.rows[2].adjusted.value(), 0.418068942525642, 1e-13);
  EXPECT_EQ(family.rows[1].isSignificant, true);
  EXPECT_EQ(family.rows[2].isSignificant, false);
}

TEST(PairwiseComparisons, AreAdjustedByTheRequestedMethod) {
  const auto holm = comparePairwise(kMethods, kPairs, 0.05, analysis::Adjustment::Holm);
  const auto bonferroni = comparePairwise(kMethods, kPairs);

  EXPECT_EQ(holm.adjustment, analysis::Adjustment::Holm);
  // The middle one of three counts twice, the largest once.
  EXPECT_DOUBLE_EQ(holm.rows[1].adjusted.value(), 2.0 * holm.rows[1].p.value());
  EXPECT_DOUBLE_EQ(holm.rows[2].adjusted.value(), holm.rows[2].p.value());
  EXPECT_EQ(holm.alphaPerTest, bonferroni.alphaPerTest);
  EXPECT_EQ(holm.rows[1].adjustedInterval->low, bonferroni.rows[1].adjustedInterval->low);
}

TEST(PairwiseComparisons, JudgeByTheAdjustedP) {
  // p of I–K is .0087: more than .02 / 3, less than .02 / 2
  constexpr double kAlpha = 0.02;
  const auto bonferroni = comparePairwise(kMethods, kPairs, kAlpha);
  const auto holm = comparePairwise(kMethods, kPairs, kAlpha, analysis::Adjustment::Holm);

  EXPECT_EQ(bonferroni.rows[1].isSignificant, false);
  EXPECT_EQ(holm.rows[1].isSignificant, true);
}

TEST(PairwiseComparisons, GiveIntervalsAtBothLevels) {
  const auto row = comparePairwise(kMethods, kPairs).rows[1];

  EXPECT_NEAR(row.interval.value().low, 0.22551697994541, 1e-13);  // study_golden.txt
  EXPECT_NEAR(row.adjustedInterval.value().low, 0.078889940671798, 1e-13);
  EXPECT_NEAR(row.adjustedInterval.value().high, 1.64333228155042, 1e-13);
}

TEST(PairwiseComparisons, AreStricterForASmallerAlpha) {
  const auto family = comparePairwise(kMethods, kPairs, 0.01);

  EXPECT_DOUBLE_EQ(family.alphaPerTest.value(), 0.01 / 3.0);
  EXPECT_EQ(family.rows[0].isSignificant, true);
  EXPECT_EQ(family.rows[1].isSignificant, false);
}

TEST(PairwiseComparisons, DoNotCountUndefinedTests) {
  auto methods = kMethods;
  methods.push_back({"A", LikertCounts(1, Counts{0, 0, 0, 0, 6})});
  methods.push_back({"B", LikertCounts(1, Counts{6, 0, 0, 0, 0})});
  const auto family =
      comparePairwise(methods, std::vector<DeclaredPair>{{"I", "F"}, {"A", "B"}, {"I", "K"}});

  EXPECT_EQ(family.tests, 2U);
  EXPECT_DOUBLE_EQ(family.alphaPerTest.value(), 0.025);
  EXPECT_FALSE(family.rows[1].adjusted.has_value());
  EXPECT_FALSE(family.rows[1].isSignificant.has_value());
  EXPECT_FALSE(family.rows[1].interval.has_value());
  EXPECT_FALSE(family.rows[1].reason.empty());
}

TEST(PairwiseComparisons, MayAllBeUndefined) {
  const std::vector<NamedSample> nobody{{"I", LikertCounts(1, 5)}, {"F", LikertCounts(1, 5)}};
  const auto family = comparePairwise(nobody, std::vector<DeclaredPair>{{"I", "F"}});

  EXPECT_EQ(family.tests, 0U);
  EXPECT_FALSE(family.alphaPerTest.has_value());
  EXPECT_FALSE(family.rows[0].isSignificant.has_value());
}

TEST(PairwiseComparisons, RefuseAnInvalidFamily) {
  const auto compare = [](std::vector<DeclaredPair> pairs, double alpha = 0.05) {
    return comparePairwise(kMethods, pairs, alpha);
  };
  EXPECT_THROW(compare({{"I", "X"}}), std::invalid_argument);
  EXPECT_THROW(compare({{"I", "I"}}), std::invalid_argument);
  EXPECT_THROW(compare({{"I", "F"}, {"F", "I"}}), std::invalid_argument);
  EXPECT_THROW(compare({{"I", "F"}}, 0.0), std::invalid_argument);
  EXPECT_THROW(
      comparePairwise(std::vector<NamedSample>{kMethods[0], kMethods[0]}, {}),
      std::invalid_argument);
}

}  // namespace pairwise_comparisons_test

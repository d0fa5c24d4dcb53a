// What Tables 2 and 3 of the punch paper have to do with each other.
#include "analysis/published/published_check.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/data/likert_counts.h"
#include "analysis/hypothesis_tests/t_tests.h"

namespace published_check_test {

using namespace analysis;  // NOLINT: one test of many small types

constexpr PublishedConvention kWelch{};

PublishedTable professionals() {
  return readPublishedTable(
      "group,mean,variance\nI,4.1,1.3\nF,2.6,2.6\nK,3.2,2.4\n",
      "group1,group2,p\nI,F,< .017\nI,K,.021\nK,F,.115\n");
}

PublishedTable others() {
  return readPublishedTable(
      "group,mean,variance\nI,4.1,1.8\nF,3.0,1.9\nK,3.3,2.2\n",
      "group1,group2,p\nI,F,< .017\nI,K,.061\nK,F,.406\n");
}

std::vector<std::uint64_t> from(std::uint64_t low, std::uint64_t high) {
  std::vector<std::uint64_t> sizes(high - low + 1);
  std::iota(sizes.begin(), sizes.end(), low);
  return sizes;
}

ConsistentSizes fits(const PublishedTable& table, std::vector<std::uint64_t> sizes, int parts = 1) {
  const AnswerLattice lattice({.lowest = 1, .highest = 5, .parts = parts}, sizes.back());
  return consistentSizes(table, std::vector(table.groups.size(), sizes), lattice, kWelch);
}

/// Intervals of the three comparisons at equal sizes, to as many decimals as the reference has.
void expectIntervals(
    const PublishedTable& table,
    std::uint64_t n,
    const std::vector<Interval>& wanted,
    double tolerance) {
  const auto check = checkConvention(table, GroupSizes(3, n), kWelch);
  ASSERT_EQ(check.comparisons.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_NEAR(check.comparisons[i].attainable.low, wanted[i].low, tolerance) << n << ", " << i;
    EXPECT_NEAR(check.comparisons[i].attainable.high, wanted[i].high, tolerance) << n << ", " << i;
  }
}

TEST(PublishedCheck, BoundsEveryPOfThePunchPaper) {
  // Means and variances as printed, ± 0.05; Welch, two-sided.
  expectIntervals(professionals(), 36, {{0, .0001}, {.0024, .0165}, {.062, .188}}, 5e-4);
  expectIntervals(professionals(), 33, {{0, .0002}, {.0037, .0217}, {.074, .208}}, 5e-4);
  expectIntervals(professionals(), 30, {{0, .0003}, {.0056, .0287}, {.089, .230}}, 5e-4);
  expectIntervals(others(), 30, {{.001, .0067}, {.0155, .0633}, {.278, .595}}, 5e-4);
  EXPECT_NEAR(
      checkConvention(professionals(), {36, 36, 36}, kWelch).comparisons[1].attainable.high,
      .0165,
      5e-5);
}

TEST(PublishedCheck, FindsThatThePrintedPIsImpossible) {
  const auto all = checkConvention(professionals(), {36, 36, 36}, kWelch);
  EXPECT_TRUE(all.comparisons[0].isAttainable);
  EXPECT_FALSE(all.comparisons[1].isAttainable);  // .021, and at most .0165
  EXPECT_TRUE(all.comparisons[2].isAttainable);
  EXPECT_FALSE(all.row);
  EXPECT_TRUE(checkConvention(professionals(), {30, 30, 30}, kWelch).areAllAttainable());
  EXPECT_TRUE(checkConvention(others(), {30, 30, 30}, kWelch).areAllAttainable());
}

TEST(PublishedCheck, FindsARowOfRealNumbersThatGivesEveryP) {
  const auto table = professionals();
  const auto check = checkConvention(table, {30, 30, 30}, kWelch);
  ASSERT_TRUE(check.row);
  for (const auto& [first, second, p] : table.comparisons) {
    const auto& a = (*check.row)[first];
    const auto& b = (*check.row)[second];
    const auto spread = spreadOfDifference(kWelch.test, a.variance, 30, b.variance, 30);
    const double found = pOf(a.mean - b.mean, spread, kWelch.tails);
    EXPECT_GE(found, p.bounds(RoundingRule::Rounded).low - 1e-9) << p.text();
    EXPECT_LE(found, p.bounds(RoundingRule::Rounded).high + 1e-9) << p.text();
  }
}

TEST(PublishedCheck, NoEqualSizesFitWholeAnswers) {
  const auto of36 = fits(professionals(), from(24, 36));
  EXPECT_EQ(of36.triedCombinations, 2197U);
  EXPECT_EQ(of36.fitting.size(), 62U);
  EXPECT_TRUE(of36.equalSizes().empty());
  EXPECT_EQ(of36.largestFittingSizes(), (GroupSizes{36, 36, 28}));
  const auto of30 = fits(others(), from(18, 30));
  EXPECT_EQ(of30.triedCombinations, 2197U);
  EXPECT_TRUE(of30.fitting.empty());
  EXPECT_FALSE(of30.largestFittingSizes());
}

/// @p value as a table prints it.
std::string printedWith(double value, int decimals) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  return text.data();
}

TEST(PublishedCheck, ShowsAnswersThatPrintTheWholeRow) {
  const auto fits62 = fits(professionals(), from(24, 36));
  const auto& exampleAnswers = fits62.exampleAnswers;
  ASSERT_EQ(exampleAnswers.size(), 3U);
  const std::vector<std::uint64_t> sizes{36, 36, 28};
  const std::vector<const char*> means{"4.1", "2.6", "3.2"};
  const std::vector<const char*> variances{"1.3", "2.6", "2.4"};
  std::vector<LikertCounts> counts;
  for (std::size_t g = 0; g < 3; ++g) {
    ASSERT_EQ(exampleAnswers[g].size(), 5U);
    EXPECT_EQ(
        std::accumulate(exampleAnswers[g].begin(), exampleAnswers[g].end(), std::uint64_t{0}),
        sizes[g]);
    counts.emplace_back(1, exampleAnswers[g]);
  }
  const auto interpolationAndFilter = welchTTest(momentsOf(counts[0]), momentsOf(counts[2]));
  EXPECT_EQ(printedWith(*interpolationAndFilter.p, 3), "0.021");
  EXPECT_EQ(printedWith(*welchTTest(momentsOf(counts[2]), momentsOf(counts[1])).p, 3), "0.115");
  EXPECT_LT(*welchTTest(momentsOf(counts[0]), momentsOf(counts[1])).p, 0.017);
  for (std::size_t g = 0; g < 3; ++g) {
    const auto any = welchTTest(momentsOf(counts[g]), momentsOf(counts[(g + 1) % 3]));
    EXPECT_EQ(printedWith(*any.mean1, 1), means[g]);
    EXPECT_EQ(printedWith(*any.variance1, 1), variances[g]);
  }
}

TEST(PublishedCheck, ShowsNoAnswersWhereNoneExist) {
  EXPECT_TRUE(fits(others(), from(18, 30)).exampleAnswers.empty());
}

TEST(PublishedCheck, HalfPointsFitWhereEachParticipantLacksOneAnswer) {
  EXPECT_EQ(fits(professionals(), {30}, 2).equalSizes(), std::vector<std::uint64_t>{30});
  EXPECT_EQ(fits(others(), {25}, 2).equalSizes(), std::vector<std::uint64_t>{25});
  EXPECT_TRUE(fits(professionals(), {36}, 2).fitting.empty());
}

TEST(PublishedCheck, RealAnswersFitByTheConventionTheyWerePrintedWith) {
  const std::vector<std::uint64_t> counts1{0, 1, 1, 4, 6};
  const std::vector<std::uint64_t> counts2{3, 2, 4, 2, 1};
  const auto a =
      welchTTest(momentsOf(LikertCounts(1, counts1)), momentsOf(LikertCounts(1, counts2)));
  ASSERT_TRUE(a.p && a.variance1 && a.variance2);
  const auto printed = [](double x, int decimals) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.*f", decimals, x);
    return std::string(text.data());
  };
  for (const bool isSd : {false, true}) {
    const auto spread = [&](double v) { return printed(isSd ? std::sqrt(v) : v, 2); };
    const auto table = readPublishedTable(
        std::string("group,mean,") + (isSd ? "sd" : "variance") + "\na," + printed(*a.mean1, 2) +
            "," + spread(*a.variance1) + "\nb," + printed(*a.mean2, 2) + "," +
            spread(*a.variance2) + "\n",
        "group1,group2,p\na,b," + printed(*a.p, 4) + "\n");
    EXPECT_TRUE(checkConvention(table, {12, 12}, kWelch).row) << isSd;
    const AnswerLattice lattice({.lowest = 1, .highest = 5, .parts = 1}, 14);
    const std::vector<std::vector<std::uint64_t>> sizes(2, from(10, 14));
    EXPECT_EQ(
        consistentSizes(table, sizes, lattice, kWelch).fitting,
        (std::vector<GroupSizes>{{12, 12}}));
    auto oneSided = kWelch;
    oneSided.tails = PublishedConvention::Tails::One;
    EXPECT_TRUE(consistentSizes(table, sizes, lattice, oneSided).fitting.empty());
  }
}

TEST(PublishedCheck, FindsTheMeansAndVariancesOfWholeAnswers) {
  const auto group = [](const char* mean, const char* variance) {
    return readPublishedTable(
               std::string("group,mean,variance\na,") + mean + "," + variance + "\nb,1,1\n",
               "group1,group2,p\na,b,.5\n")
        .groups.front();
  };
  const AnswerLattice lattice({.lowest = 1, .highest = 7, .parts = 1}, 28);
  const auto points = [&](const char* mean, const char* variance, std::uint64_t n) {
    return lattice
        .pointsOf(
            group(mean, variance), n, PublishedConvention::Divisor::Sample, RoundingRule::Rounded)
        .size();
  };
  EXPECT_EQ(points("5.19", "1.00", 28), 0U);  // Brown & Heathers 2017: 145/28 and 146/28
  EXPECT_GT(points("5.18", "1.0", 28), 0U);
  EXPECT_EQ(points("5.18", "1.00", 28), 0U);  // 731/756 = 0.967 and 787/756 = 1.041 are nearest
  EXPECT_EQ(points("3.47", "1.00", 10), 0U);
  EXPECT_EQ(points("1.00", "0.00", 10), 1U);
  EXPECT_EQ(points("1.00", "0.10", 10), 0U);  // all answers are 1
  EXPECT_EQ(points("4.00", "18.00", 2), 1U);  // 1 and 7
  EXPECT_EQ(points("4.00", "16.00", 2), 0U);
}

TEST(PublishedCheck, CoversEveryConvention) {
  const auto conventions = publishedConventions();
  EXPECT_EQ(conventions.size(), 24U);
  EXPECT_EQ(describe(conventions.front()), "Welch, two-sided, variances with n − 1, rounded");
  const auto table = professionals();
  const auto two = checkConvention(table, {36, 36, 36}, kWelch).comparisons[2].attainable;
  const auto one = checkConvention(table, {36, 36, 36}, {.tails = PublishedConvention::Tails::One})
                       .comparisons[2]
                       .attainable;
  EXPECT_DOUBLE_EQ(one.low, two.low / 2);
  EXPECT_DOUBLE_EQ(one.high, two.high / 2);
}

TEST(PublishedCheck, AllowsVariancesOfZero) {
  const auto table = readPublishedTable(
      "group,mean,variance\na,3,0\nb,3,0\nc,5,0\n", "group1,group2,p\na,b,.9\na,c,< .001\n");
  const auto check = checkConvention(table, {5, 5, 5}, kWelch);
  EXPECT_EQ(check.comparisons[0].attainable.low, 0.0);
  EXPECT_EQ(check.comparisons[0].attainable.high, 1.0);
  EXPECT_TRUE(check.row);
  EXPECT_THROW(checkConvention(table, {5, 5}, kWelch), std::invalid_argument);
}

}  // namespace published_check_test

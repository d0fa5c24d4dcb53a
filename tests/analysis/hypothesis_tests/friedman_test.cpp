#include "analysis/hypothesis_tests/friedman.h"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/hypothesis_tests/attainable_p.h"

namespace friedman_test {

using analysis::friedmanTest;
using analysis::smallestFriedmanP;
using Blocks = std::vector<std::vector<double>>;

/// Σ of squared rank sums of rows that already are ranks.
double squaredSums(const Blocks& ranks) {
  double total = 0.0;
  for (std::size_t j = 0; j < ranks.front().size(); ++j) {
    double sum = 0.0;
    for (const auto& row : ranks) sum += row[j];
    total += sum * sum;
  }
  return total;
}

/// By going through all permutations of all rows.
double slowP(const Blocks& ranks) {
  const double observed = squaredSums(ranks);
  double asUnequal = 0.0;
  double all = 0.0;
  Blocks rows = ranks;
  for (auto& row : rows) std::ranges::sort(row);
  const auto walk = [&](const auto& self, std::size_t row) -> void {
    if (row == rows.size()) {
      all += 1.0;
      asUnequal += squaredSums(rows) >= observed - 1e-9 ? 1.0 : 0.0;
      return;
    }
    do {
      self(self, row + 1);
    } while (std::ranges::next_permutation(rows[row]).found);
  };
  walk(walk, 0);
  return asUnequal / all;
}

TEST(FriedmanTest, CountsTiesAsGoingThroughAllPermutations) {
  for (const auto& ranks : std::vector<Blocks>{
           {{1, 2, 3}, {1.5, 1.5, 3}, {1, 3, 2}, {2, 1, 3}},
           {{1, 2, 3, 4}, {1, 2.5, 2.5, 4}, {2, 2, 2, 4}},
           {{1, 2}, {1, 2}, {1.5, 1.5}, {2, 1}, {1, 2}},
           {{1, 2, 3, 4, 5}, {2, 1, 3, 5, 4}}}) {
    EXPECT_DOUBLE_EQ(friedmanTest(ranks).exactP.value(), slowP(ranks));
  }
}

TEST(FriedmanTest, IsASignTestOfTwoTreatments) {
  // χ² = (8 − 2)²/10; exact 2 (1 + 10 + 45)/2^10
  Blocks blocks(8, {1.0, 2.0});
  blocks.push_back({2.0, 1.0});
  blocks.push_back({2.0, 1.0});
  const auto result = friedmanTest(blocks);
  EXPECT_DOUBLE_EQ(result.chiSquared.value(), 3.6);
  EXPECT_EQ(result.exactP, 112.0 / 1024.0);
}

TEST(FriedmanTest, KeepsConoversTBesideTheFOfTwoTreatments) {
  // both are the analysis of variance of ranks: t² = F for k = 2
  const auto result = friedmanTest(Blocks{{1, 2}, {1, 2}, {1, 2}, {2, 1}, {3, 3}, {1, 2}});
  ASSERT_EQ(result.pairs.size(), 1U);
  const auto& pair = result.pairs.front();
  EXPECT_NEAR(std::pow(pair.conoverT.value(), 2), result.imanDavenportF.value(), 1e-13);
  EXPECT_EQ(pair.conoverDegreesOfFreedom, static_cast<double>(result.blocks - 1));
  EXPECT_NEAR(pair.conoverP.value(), result.imanDavenportP.value(), 1e-14);
  EXPECT_LT(pair.conoverT.value(), 0.0);  // the second treatment ranks higher
}

TEST(FriedmanTest, IsThatOfPlanningIfPeopleAgree) {
  const auto result = friedmanTest(Blocks(6, {3.0, 1.0, 2.0}));
  EXPECT_EQ(result.chiSquared, 12.0);
  EXPECT_EQ(result.kendallW, 1.0);
  EXPECT_EQ(result.imanDavenportF, std::numeric_limits<double>::infinity());
  EXPECT_EQ(result.imanDavenportP, 0.0);
  EXPECT_FALSE(result.pairs.front().conoverT.has_value());
  EXPECT_DOUBLE_EQ(result.exactP.value(), smallestFriedmanP(6, 3).p);
}

TEST(FriedmanTest, ReachesFurtherThanADouble) {
  Blocks blocks(5000, {3.0, 1.0, 2.0});
  blocks.push_back({1.0, 2.0, 3.0});
  const auto result = friedmanTest(blocks);
  EXPECT_EQ(result.reason.key(), "too_many_blocks");
  EXPECT_EQ(result.p, 0.0);
  // two degrees of freedom: e^(−χ²/2)
  EXPECT_NEAR(result.log10P.value(), -0.5 * result.chiSquared.value() / std::log(10.0), 1e-9);
  EXPECT_LT(result.pairs.front().nemenyiLog10P, -1000.0);
}

TEST(FriedmanTest, HasAnExactPForTheDocumentedNumberOfBlocks) {
  const auto isExact = [](std::size_t blocks, const std::vector<double>& order) {
    return friedmanTest(Blocks(blocks, order)).exactP ==
           smallestFriedmanP(blocks, static_cast<int>(order.size())).p;
  };
  const auto isLeftOut = [](std::size_t blocks, const std::vector<double>& order) {
    return !friedmanTest(Blocks(blocks, order)).exactP.has_value();
  };
  EXPECT_TRUE(isExact(126, {1, 2}));
  EXPECT_TRUE(isLeftOut(127, {1, 2}));
  EXPECT_TRUE(isLeftOut(49, {1, 2, 3}));
  EXPECT_TRUE(isLeftOut(11, {1, 2, 3, 4}));
  EXPECT_TRUE(isLeftOut(3, {1, 2, 3, 4, 5}));
  for (const auto& [blocks, order] : std::vector<std::pair<std::size_t, std::vector<double>>>{
           {48, {1, 2, 3}}, {10, {1, 2, 3, 4}}, {2, {1, 2, 3, 4, 5}}}) {
    const double smallest = smallestFriedmanP(blocks, static_cast<int>(order.size())).p;
    EXPECT_NEAR(friedmanTest(Blocks(blocks, order)).exactP.value() / smallest, 1.0, 1e-13);
  }
}

/// The most memory that this program has used so far [kB].
long peakMemory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

TEST(FriedmanTest, TakesLittleMemoryForAPThatItDoesNotCompute) {
  const long before = peakMemory();
  // 64 participants and four conditions: a grid of 57 million counts, 16 bytes each.
  EXPECT_FALSE(friedmanTest(Blocks(64, {1, 2, 3, 4})).exactP.has_value());
  EXPECT_LT(peakMemory() - before, 100'000);
}

TEST(FriedmanTest, IsUndefinedIfAllAreTied) {
  const auto result = friedmanTest(Blocks{{3, 3, 3}, {5, 5, 5}});
  EXPECT_EQ(result.reason.key(), "all_treatments_tied");
  EXPECT_FALSE(result.chiSquared.has_value());
  EXPECT_FALSE(result.exactP.has_value());
  EXPECT_TRUE(result.pairs.empty());
}

TEST(FriedmanTest, IsPartlyDefinedForOneBlockAndUndefinedForNone) {
  const auto one = friedmanTest(Blocks{{1, 2, 3}});
  EXPECT_EQ(one.reason.key(), "one_block");
  EXPECT_EQ(one.exactP, 1.0);
  EXPECT_FALSE(one.imanDavenportF.has_value());
  EXPECT_EQ(friedmanTest(Blocks{}).reason.key(), "no_blocks");
}

TEST(FriedmanTest, RefusesInvalidBlocks) {
  EXPECT_THROW(friedmanTest(Blocks{{1, 2}, {1}}), std::invalid_argument);
  EXPECT_THROW(friedmanTest(Blocks{{1}, {1}}), std::invalid_argument);
  EXPECT_THROW(friedmanTest(Blocks{{1, std::nan("")}}), std::invalid_argument);
}

}  // namespace friedman_test

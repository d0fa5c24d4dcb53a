#include <cmath>

#include <gtest/gtest.h>

#include "analysis/hypothesis_tests/vote_tests.h"

namespace equal_shares_test {

using analysis::equalSharesP;
using analysis::VoteCounts;

VoteCounts votes(const std::vector<std::uint64_t>& counts) {
  std::vector<std::string> options;
  for (std::size_t i = 0; i < counts.size(); ++i) options.push_back("option " + std::to_string(i));
  VoteCounts result(options);
  for (std::size_t i = 0; i < counts.size(); ++i) result.add(options[i], counts[i]);
  return result;
}

double factorial(std::uint64_t n) {
  return n < 2 ? 1.0 : static_cast<double>(n) * factorial(n - 1);
}

/// By walking through all outcomes, one by one.
double slowP(const std::vector<std::uint64_t>& observed) {
  std::uint64_t n = 0;
  for (const auto count : observed) n += count;
  const auto orders = [&](const std::vector<std::uint64_t>& outcome) {
    double product = factorial(n);
    for (const auto count : outcome) product /= factorial(count);
    return std::round(product);
  };
  double rare = 0.0;
  double all = 0.0;
  std::vector<std::uint64_t> outcome(observed.size(), 0);
  const auto walk = [&](const auto& self, std::size_t option, std::uint64_t left) -> void {
    if (option + 1 == outcome.size()) {
      outcome[option] = left;
      all += orders(outcome);
      if (orders(outcome) <= orders(observed)) rare += orders(outcome);
      return;
    }
    for (outcome[option] = 0; outcome[option] <= left; ++outcome[option]) {
      self(self, option + 1, left - outcome[option]);
    }
  };
  walk(walk, 0, n);
  return rare / all;
}

TEST(EqualShares, AreTheBinomialTestForTwoOptions) {
  // R: binom.test(9, 10)$p.value = 22/1024
  EXPECT_EQ(equalSharesP(votes({9, 1})), 22.0 / 1024.0);
  EXPECT_EQ(equalSharesP(votes({5, 5})), 1.0);
}

TEST(EqualShares, HaveTheirExactProbability) {
  EXPECT_EQ(equalSharesP(votes({3, 0, 0})), 3.0 / 27.0);  // AAA, BBB, CCC
  EXPECT_NEAR(
      equalSharesP(votes({11, 1, 9})).value(), 0.0081, 0.00005);  // votes of TABLE 4, punch paper
}

TEST(EqualShares, AgreeWithWalkingThroughAllOutcomes) {
  for (const auto& counts : std::vector<std::vector<std::uint64_t>>{
           {7, 0, 4},
           {4, 1, 5},
           {1, 0},
           {2, 2, 2, 2},
           {6, 3, 1, 1},
           {0, 0, 5, 1, 2},
           {3, 3, 0, 1}}) {
    EXPECT_DOUBLE_EQ(equalSharesP(votes(counts)).value(), slowP(counts));
  }
}

TEST(EqualShares, DoNotDependOnTheOrderOfTheOptions) {
  EXPECT_EQ(equalSharesP(votes({7, 0, 4})), equalSharesP(votes({4, 7, 0})));
}

TEST(EqualShares, AreOneForTheMostEqualOutcome) {
  EXPECT_EQ(equalSharesP(votes({26, 26, 27})), 1.0);
  EXPECT_EQ(equalSharesP(votes({63, 63})), 1.0);
}

TEST(EqualShares, AreCountedInWholeNumbersWhereTheseSuffice) {
  EXPECT_EQ(equalSharesP(votes({126, 0})), 0x1p-125);
  EXPECT_EQ(equalSharesP(votes({63, 0, 0, 0})), 0x1p-124);
}

TEST(EqualShares, AreExactOfManyVotesAsWell) {
  const auto isNear = [](const std::vector<std::uint64_t>& counts, double p) {
    EXPECT_NEAR(equalSharesP(votes(counts)).value() / p, 1.0, 1e-10);
  };
  // Python, with whole numbers:
  // n, k = sum(v), len(v); w = lambda v: factorial(n) // prod(map(factorial, v))
  // Fraction(sum(w(o) for o in all_outcomes(n, k) if w(o) <= w(v)), k ** n)
  isNear({33, 62, 105}, 2.2116274130164493e-09);
  isNear({40, 20, 20}, 0.009398797420308138);
  isNear({64, 64}, 1.0);
  isNear({127, 0}, 1.1754943508222875e-38);
  isNear({70, 52, 60}, 0.2631737922226579);
  isNear({20, 16, 24, 28}, 0.3070250554178492);
  isNear({500, 500, 500}, 1.0);
}

TEST(EqualShares, AreNotCountedForMoreThanAMillionOutcomes) {
  EXPECT_TRUE(equalSharesP(votes({200, 100, 100, 100})).has_value());
  EXPECT_FALSE(equalSharesP(votes({200, 200, 200, 200})).has_value());
  EXPECT_FALSE(equalSharesP(votes({std::uint64_t{1} << 40, 0})).has_value());
}

TEST(EqualShares, AreUndefinedWithoutVotes) {
  EXPECT_FALSE(equalSharesP(votes({0, 0, 0})).has_value());
}

TEST(EqualShares, MayHaveManyOptions) {
  std::vector<std::uint64_t> counts(100, 0);
  counts[0] = 1;
  EXPECT_EQ(equalSharesP(votes(counts)), 1.0);
  counts[0] = 2;
  EXPECT_EQ(equalSharesP(votes(counts)), 0.01);
}

}  // namespace equal_shares_test

#include "analysis/hypothesis_tests/vote_tests.h"

#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/data/vote_shares.h"
#include "analysis/hypothesis_tests/contingency_tables.h"
#include "analysis/hypothesis_tests/friedman.h"

namespace vote_tests_test {

using analysis::clopperPearsonInterval;
using analysis::cochranQTest;
using analysis::equalSharesTest;
using analysis::fisherExactTest;
using analysis::mcNemarTest;
using analysis::stuartMaxwellTest;
using analysis::wilsonInterval;
using Counts = std::vector<std::uint64_t>;
using Table = std::vector<Counts>;
using Answers = std::vector<std::vector<bool>>;

analysis::VoteCounts preferences(std::uint64_t i, std::uint64_t f, std::uint64_t k) {
  analysis::VoteCounts votes({"interpolation", "fem", "kalman"});
  votes.add("interpolation", i);
  votes.add("fem", f);
  votes.add("kalman", k);
  return votes;
}

TEST(EqualSharesTest, IsThatOfTable4) {
  // TABLE 4 of the punch paper
  const auto professionals = equalSharesTest(preferences(7, 0, 4));
  EXPECT_NEAR(professionals.exactP.value(), 0.0209, 0.00005);
  EXPECT_NEAR(professionals.p.value(), 0.0346, 0.00005);
  EXPECT_NEAR(equalSharesTest(preferences(4, 1, 5)).exactP.value(), 0.371, 0.0005);
  EXPECT_NEAR(equalSharesTest(preferences(11, 1, 9)).exactP.value(), 0.0081, 0.00005);
}

TEST(EqualSharesTest, GivesAReasonForMissingValues) {
  const auto none = equalSharesTest(preferences(0, 0, 0));
  EXPECT_EQ(none.reason.key(), "nobody_voted");
  EXPECT_FALSE(none.p.has_value());
  const auto many = equalSharesTest(preferences(5000, 1000, 0));
  EXPECT_EQ(many.reason.key(), "too_many_votes");
  EXPECT_EQ(many.chiSquared, 7000.0);  // (3000² + 1000² + 2000²)/2000
  EXPECT_NEAR(many.log10P.value(), -3500.0 / std::log(10.0), 1e-9);  // two degrees: e^(−χ²/2)
}

TEST(ShareIntervals, EndAtZeroAndOneForNoVotesAndAllVotes) {
  EXPECT_EQ(wilsonInterval(0, 11)->low, 0.0);
  EXPECT_EQ(wilsonInterval(11, 11)->high, 1.0);
  // (α/2)^(1/n)
  EXPECT_NEAR(clopperPearsonInterval(11, 11)->low, std::pow(0.025, 1.0 / 11.0), 1e-14);
  EXPECT_NEAR(clopperPearsonInterval(0, 11)->high, 1.0 - std::pow(0.025, 1.0 / 11.0), 1e-14);
  EXPECT_EQ(clopperPearsonInterval(0, 11)->low, 0.0);
}

TEST(ShareIntervals, MirrorVotesForIntoVotesAgainst) {
  for (const double level : {0.5, 0.95, 0.999}) {
    EXPECT_NEAR(wilsonInterval(3, 10, level)->low, 1.0 - wilsonInterval(7, 10, level)->high, 1e-15);
    EXPECT_NEAR(
        clopperPearsonInterval(3, 10, level)->low,
        1.0 - clopperPearsonInterval(7, 10, level)->high,
        1e-14);
  }
}

TEST(ShareIntervals, AreUndefinedWithoutVotes) {
  EXPECT_FALSE(wilsonInterval(0, 0).has_value());
  EXPECT_FALSE(clopperPearsonInterval(0, 0).has_value());
  EXPECT_THROW(wilsonInterval(2, 1), std::invalid_argument);
  EXPECT_THROW(clopperPearsonInterval(1, 2, 1.0), std::invalid_argument);
}

TEST(McNemarTest, CountsChangedAnswers) {
  // R: binom.test(59, 59 + 6)$p.value is tiny; by hand: 2 (1 + 10)/2^10 for 1 against 9
  EXPECT_EQ(mcNemarTest(1, 9).p, 22.0 / 1024.0);
  EXPECT_EQ(mcNemarTest(9, 1).chiSquared, 6.4);
  const auto result = mcNemarTest(2, 1);
  EXPECT_EQ(result.changedToYes, 2U);
  EXPECT_EQ(result.changedToNo, 1U);
  EXPECT_EQ(result.p, 1.0);
}

TEST(McNemarTest, HasThePublishedChiSquaredOfApproval) {
  // Agresti 1990, p. 350: approval of the president, 150 to no and 86 to yes. R: ?mcnemar.test;
  // z² = 64²/236 = 17.36, without correction
  const auto result = mcNemarTest(86, 150);
  EXPECT_DOUBLE_EQ(result.chiSquared.value(), 4096.0 / 236.0);
  EXPECT_NEAR(result.pAsymptotic.value(), std::erfc(std::sqrt(2048.0 / 236.0)), 1e-18);
}

TEST(McNemarTest, GivesAReasonIfNoAnswerChanged) {
  EXPECT_EQ(mcNemarTest(0, 0).reason.key(), "nobody_changed");
  EXPECT_FALSE(mcNemarTest(std::uint64_t{1} << 40, 1).p.has_value());
  EXPECT_EQ(mcNemarTest(0, 5000).reason.key(), "p_too_small");
}

TEST(StuartMaxwellTest, IsMcNemarsForTwoOptions) {
  const auto result = stuartMaxwellTest(Table{{794, 150}, {86, 570}});
  EXPECT_DOUBLE_EQ(result.chiSquared.value(), 4096.0 / 236.0);
  EXPECT_EQ(result.degreesOfFreedom, 1.0);
  EXPECT_EQ(result.changed, 236U);
}

TEST(StuartMaxwellTest, HasThePublishedValueOfVision) {
  // Stuart 1955: unaided vision of the right and left eyes of 7477 women, χ² = 11.96, 3 df
  const auto result = stuartMaxwellTest(
      Table{{1520, 266, 124, 66}, {234, 1512, 432, 78}, {117, 362, 1772, 205}, {36, 82, 179, 492}});
  EXPECT_EQ(result.persons, 7477U);
  EXPECT_NEAR(result.chiSquared.value(), 11.96, 0.005);
  EXPECT_EQ(result.degreesOfFreedom, 3.0);
  EXPECT_NEAR(result.p.value(), 0.0075, 0.00005);
}

TEST(StuartMaxwellTest, LeavesOutOptionsWithoutChanges) {
  const auto three = stuartMaxwellTest(Table{{5, 0, 3}, {0, 4, 0}, {1, 0, 2}});
  EXPECT_EQ(three.degreesOfFreedom, 1.0);
  EXPECT_DOUBLE_EQ(three.chiSquared.value(), 1.0);  // (3 − 1)²/4
  const auto apart =
      stuartMaxwellTest(Table{{1, 3, 0, 0}, {1, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 5, 1}});
  EXPECT_EQ(apart.degreesOfFreedom, 2.0);
  EXPECT_DOUBLE_EQ(apart.chiSquared.value(), 1.0 + 5.0);
}

TEST(StuartMaxwellTest, IsUndefinedWithoutChanges) {
  EXPECT_EQ(stuartMaxwellTest(Table{{5, 0}, {0, 4}}).reason.key(), "nobody_changed");
  EXPECT_EQ(stuartMaxwellTest(Table{{0, 0}, {0, 0}}).reason.key(), "nobody_voted");
  EXPECT_THROW(stuartMaxwellTest(Table{{5, 0}, {0}}), std::invalid_argument);
  EXPECT_THROW(stuartMaxwellTest(Table{{5}}), std::invalid_argument);
}

// Twelve games, as three fans predict them; seven say nothing about the fans.
const Answers kFans{
    {true, true, true},
    {true, true, true},
    {false, true, false},
    {true, true, false},
    {false, false, false},
    {true, true, true},
    {true, true, true},
    {true, true, false},
    {false, false, true},
    {false, true, false},
    {true, true, true},
    {true, true, true}};

TEST(CochranQTest, IsFriedmansTestOfZerosAndOnes) {
  std::vector<std::vector<double>> blocks;
  for (const auto& game : kFans) blocks.emplace_back(game.begin(), game.end());
  const auto result = cochranQTest(kFans);
  const auto friedman = analysis::friedmanTest(blocks);
  EXPECT_DOUBLE_EQ(result.q.value(), friedman.chiSquared.value());
  EXPECT_DOUBLE_EQ(result.exactP.value(), friedman.exactP.value());
  EXPECT_EQ(result.unvaryingPersons, 7U);
  EXPECT_EQ(result.degreesOfFreedom, 2.0);
}

TEST(CochranQTest, IsMcNemarsTestOfTwoOptions) {
  const Answers answers{{true, false}, {true, false}, {true, false}, {false, true}, {true, true}};
  EXPECT_EQ(cochranQTest(answers).q, mcNemarTest(1, 3).chiSquared);
  EXPECT_EQ(cochranQTest(answers).exactP, mcNemarTest(1, 3).p);
}

TEST(CochranQTest, GivesAReasonIfThereIsNothingToCompare) {
  EXPECT_EQ(cochranQTest(Answers{}).reason.key(), "nobody_answered");
  EXPECT_EQ(cochranQTest(Answers{{true, true}, {false, false}}).reason.key(), "same_to_all");
  EXPECT_THROW(cochranQTest(Answers{{true, true}, {false}}), std::invalid_argument);
  EXPECT_THROW(cochranQTest(Answers{{true}}), std::invalid_argument);
}

/// By going through all tables of three columns and two rows.
double slowFisher(const Counts& top, const Counts& bottom) {
  const auto factorial = [](std::uint64_t n) { return std::tgamma(static_cast<double>(n) + 1.0); };
  const auto weight = [&](const Counts& first) {
    double w = 1.0;
    for (std::size_t j = 0; j < 3; ++j) {
      w /= factorial(first[j]) * factorial(top[j] + bottom[j] - first[j]);
    }
    return w;
  };
  double all = 0.0;
  double rare = 0.0;
  for (std::uint64_t a = 0; a <= top[0] + bottom[0]; ++a) {
    for (std::uint64_t b = 0; b <= top[1] + bottom[1]; ++b) {
      const std::uint64_t n = top[0] + top[1] + top[2];
      if (a + b > n || n - a - b > top[2] + bottom[2]) continue;
      const double w = weight({a, b, n - a - b});
      all += w;
      if (w <= weight(top) * (1.0 + 1e-12)) rare += w;
    }
  }
  return rare / all;
}

TEST(CochranQTest, TakesAnyNumberOfOptions) {
  std::vector<std::vector<bool>> answers(3, std::vector<bool>(51, false));
  for (std::size_t person = 0; person < 3; ++person) answers[person][person] = true;
  const auto result = cochranQTest(answers);
  // Three of 51 options get one yes each: Q = 50 (51 · 3 − 9) / (51 · 3 − 3).
  EXPECT_DOUBLE_EQ(result.q.value(), 48.0);
  EXPECT_EQ(result.degreesOfFreedom, 50.0);
  EXPECT_FALSE(result.exactP.has_value());
  EXPECT_EQ(result.reason.key(), "too_many_answers");
}

TEST(FisherExactTest, HasThePublishedPOfTheTeaExperiment) {
  // Fisher 1935: 34/70; R: fisher.test(matrix(c(3, 1, 1, 3), 2))
  EXPECT_DOUBLE_EQ(fisherExactTest(Table{{3, 1}, {1, 3}}).p.value(), 34.0 / 70.0);
  EXPECT_DOUBLE_EQ(fisherExactTest(Table{{4, 0}, {0, 4}}).p.value(), 2.0 / 70.0);
}

TEST(FisherExactTest, HasThePublishedPOfConvictions) {
  // Fisher 1962: like-sex twins of convicts; R: p-value = 0.0005367
  EXPECT_NEAR(fisherExactTest(Table{{2, 15}, {10, 3}}).p.value(), 0.0005367, 5e-8);
}

TEST(FisherExactTest, AgreesWithGoingThroughAllTables) {
  // TABLE 4 of the punch paper: cohort × method
  EXPECT_NEAR(
      fisherExactTest(Table{{7, 0, 4}, {4, 1, 5}}).p.value(),
      slowFisher({7, 0, 4}, {4, 1, 5}),
      1e-14);
  EXPECT_NEAR(
      fisherExactTest(Table{{9, 3, 2}, {1, 6, 12}}).p.value(),
      slowFisher({9, 3, 2}, {1, 6, 12}),
      1e-14);
}

TEST(FisherExactTest, DoesNotDependOnOrderOrEmptyRows) {
  const double p = fisherExactTest(Table{{3, 1, 0}, {0, 2, 4}, {1, 1, 5}}).p.value();
  EXPECT_DOUBLE_EQ(fisherExactTest(Table{{3, 0, 1}, {1, 2, 1}, {0, 4, 5}}).p.value(), p);
  EXPECT_DOUBLE_EQ(
      fisherExactTest(Table{{0, 2, 0, 4}, {0, 0, 0, 0}, {1, 1, 0, 5}, {3, 1, 0, 0}}).p.value(), p);
}

TEST(FisherExactTest, GivesAReasonIfThereIsNoP) {
  EXPECT_EQ(fisherExactTest(Table{{3, 1}, {0, 0}}).reason.key(), "one_row_or_column");
  EXPECT_EQ(fisherExactTest(Table{{300, 1}, {1, 3}}).reason.key(), "too_many_counts");
  EXPECT_EQ(
      fisherExactTest(Table{{9, 9, 9, 9}, {9, 9, 9, 9}, {9, 9, 9, 9}, {9, 9, 9, 9}}).reason.key(),
      "too_many_tables");
  EXPECT_THROW(fisherExactTest(Table{}), std::invalid_argument);
  EXPECT_THROW(fisherExactTest(Table{{1, 2}, {1}}), std::invalid_argument);
  EXPECT_TRUE(fisherExactTest(Table{{150, 10}, {90, 50}}).p.has_value());
}

}  // namespace vote_tests_test

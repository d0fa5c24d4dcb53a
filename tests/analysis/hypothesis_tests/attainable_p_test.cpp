#include "analysis/hypothesis_tests/attainable_p.h"

#include <cmath>
#include <optional>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace attainable_p_test {

using namespace analysis;  // NOLINT: free functions only

TEST(AttainableP, OfSignFlipsHalvesWithEveryParticipant) {
  EXPECT_EQ(smallestSignFlipP(5).p, 0.0625);
  EXPECT_EQ(smallestSignFlipP(6).p, 0.03125);
  EXPECT_EQ(smallestSignFlipP(7).p, 0.015625);
  EXPECT_EQ(smallestSignFlipP(1).p, 1.0);
  EXPECT_EQ(smallestSignFlipP(0).p, 1.0);
  EXPECT_EQ(smallestSignFlipP(5000).p, 0.0);
  EXPECT_NEAR(smallestSignFlipP(5000).log10P, -4999 * std::log10(2.0), 1e-9);
}

TEST(AttainableP, OfFriedmanIsThatOfPerfectAgreement) {
  EXPECT_DOUBLE_EQ(smallestFriedmanP(5, 3).p, 1.0 / 1296.0);  // 7.7e-4
  EXPECT_DOUBLE_EQ(smallestFriedmanP(6, 3).p, 1.0 / 7776.0);  // 1.3e-4
  EXPECT_DOUBLE_EQ(smallestFriedmanP(2, 4).p, 1.0 / 24.0);
  EXPECT_EQ(smallestFriedmanP(1, 3).p, 1.0);
  EXPECT_NEAR(smallestFriedmanP(2, 30).log10P, -32.4236600749, 1e-9);  // 30! = 2.6525e32
  EXPECT_THROW(smallestFriedmanP(5, 1), std::invalid_argument);
}

TEST(AttainableP, OfMannAndWhitneyIsThatOfGroupsThatDoNotOverlap) {
  EXPECT_DOUBLE_EQ(smallestMannWhitneyP(5, 6).p, 2.0 / 462.0);  // .0043
  EXPECT_DOUBLE_EQ(smallestMannWhitneyP(6, 5).p, 2.0 / 462.0);
  EXPECT_DOUBLE_EQ(smallestMannWhitneyP(2, 2).p, 2.0 / 6.0);
  EXPECT_EQ(smallestMannWhitneyP(1, 1).p, 1.0);
  EXPECT_EQ(smallestMannWhitneyP(0, 9).p, 1.0);
  EXPECT_NEAR(smallestMannWhitneyP(5, 6).log10P, std::log10(2.0 / 462.0), 1e-12);
}

TEST(AttainableP, HasTheNumberOfParticipantsThatAFamilyNeeds) {
  EXPECT_EQ(fewestParticipantsForSignFlip(0.05), 6U);
  EXPECT_EQ(fewestParticipantsForSignFlip(0.05 / 3.0), 7U);
  EXPECT_EQ(fewestParticipantsForSignFlip(0.05 / 6.0), 8U);
  EXPECT_EQ(fewestParticipantsForSignFlip(0.05 / 10.0), 9U);
  EXPECT_EQ(fewestParticipantsForSignFlip(0.5), 2U);
  EXPECT_THROW(fewestParticipantsForSignFlip(0.0), std::invalid_argument);
}

TEST(FamilyLevels, AreWhereTheCorrectionTurns) {
  const auto corrected = [](std::vector<std::optional<double>> p, auto method) {
    return *analysis::adjust(p, method).front();
  };
  for (const auto method : analysis::kAdjustments) {
    const auto [strictest, mostLenient] = analysis::levelsOf(0.05, 3, method);
    EXPECT_NEAR(corrected({strictest, 1.0, 1.0}, method), 0.05, 1e-12) << nameOf(method);
    EXPECT_NEAR(corrected({mostLenient, mostLenient, mostLenient}, method), 0.05, 1e-12)
        << nameOf(method);
  }
  EXPECT_EQ(analysis::levelsOf(0.05, 3, std::nullopt).strictest, 0.05);
  EXPECT_THROW(analysis::levelsOf(1.0, 3, std::nullopt), std::invalid_argument);
}

TEST(AttainableP, OfVotesIsThatOfAUnanimousVote) {
  EXPECT_DOUBLE_EQ(smallestVoteP(6, 3).p, 1.0 / 243.0);
  EXPECT_EQ(smallestVoteP(0, 3).p, 1.0);
  EXPECT_THROW(smallestVoteP(6, 1), std::invalid_argument);
}

TEST(AttainableP, HasTheNumberOfVotesForSignificance) {
  // Two options are a sign test: 9 of 10 have p = 22/1024, 8 of 10 have 112/1024.
  EXPECT_EQ(fewestVotesForSignificance(10, 2, 0.05), 9U);
  EXPECT_EQ(fewestVotesForSignificance(6, 2, 0.05), 6U);
  EXPECT_FALSE(fewestVotesForSignificance(5, 2, 0.05));  // 2/32
  // Three options, five votes: 5/0/0 has p = 3/243, 4/1/0 has (3 + 30)/243 = .136.
  EXPECT_EQ(fewestVotesForSignificance(5, 3, 0.05), 5U);
  EXPECT_FALSE(fewestVotesForSignificance(0, 3, 0.05));
  EXPECT_EQ(fewestVotesForSignificance(200, 2, 0.05), 115U);  // R: binom.test(115, 200)
}

}  // namespace attainable_p_test

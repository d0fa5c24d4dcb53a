#include <stdexcept>

#include <gtest/gtest.h>

#include "analysis/data/vote_shares.h"

namespace vote_counts_test {

using analysis::VoteCounts;

TEST(VoteCounts, CountInTheOrderOfTheOptions) {
  VoteCounts votes({"interpolation", "fem", "kalman"});
  votes.add("kalman");
  votes.add("interpolation", 3);

  const auto shares = votes.shares();
  ASSERT_EQ(shares.size(), 3U);
  EXPECT_EQ(shares[0].option, "interpolation");
  EXPECT_EQ(shares[0].votes, 3U);
  EXPECT_EQ(shares[0].share, 0.75);
  EXPECT_EQ(shares[1].share, 0.0);
  EXPECT_EQ(shares[2].votes, 1U);
  EXPECT_EQ(votes.total(), 4U);
}

TEST(VoteCounts, HaveNoSharesBeforeTheFirstVote) {
  EXPECT_FALSE(VoteCounts({"a", "b"}).shares().front().share.has_value());
}

TEST(VoteCounts, RejectUnknownOptionsAndTooManyVotes) {
  VoteCounts votes({"a", "b"});
  EXPECT_THROW(votes.add("c"), std::invalid_argument);
  votes.add("a", VoteCounts::kMostVotes);
  EXPECT_THROW(votes.add("b"), std::invalid_argument);
}

TEST(VoteCounts, RejectFewerThanTwoDifferentOptions) {
  EXPECT_THROW(VoteCounts({"a"}), std::invalid_argument);
  EXPECT_THROW(VoteCounts({"a", "a"}), std::invalid_argument);
}

}  // namespace vote_counts_test

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "study/results/results.h"

namespace study {

/// The votes of one cohort in all rounds.
struct CohortVotes {
  std::string cohort;
  std::vector<const VoteResult*> rounds;  ///< pointers into the argument of voteTables()
  analysis::VoteCounts sum;               ///< votes summed over the rounds
};

/// The votes between one set of conditions, by cohort and round, with their sums: Table 4 of the
/// punch paper. A sum counts a participant once for each round. Such votes are not independent, so
/// a sum has no p value and no interval.
struct VoteTable {
  std::vector<std::string> options;  ///< condition ids
  std::vector<CohortVotes> cohorts;  ///< cohorts that voted, in the protocol's order
  analysis::VoteCounts total;        ///< over all cohorts
};

/// The tables of all votes, one for each set of conditions. They point into @p results.
std::vector<VoteTable> voteTables(const Results& results);

/// The condition that got most votes, over all cohorts and rounds.
struct MostNamed {
  std::string condition;
  std::string phase;  ///< a phase that asked for votes
  std::uint64_t votes = 0;
  std::uint64_t total = 0;
  std::size_t rounds = 0;
};

/// std::nullopt if there are no votes, or if several conditions have the largest number of votes.
std::optional<MostNamed> mostNamedIn(const Results& results);

}  // namespace study

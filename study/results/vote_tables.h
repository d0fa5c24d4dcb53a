#pragma once

#include <string>
#include <vector>

#include "study/results/results.h"

namespace study {

/// The votes of one cohort in all rounds.
struct CohortVotes {
  std::string cohort;
  std::vector<const VoteResult*> rounds;  ///< of the results that the table was made of
  analysis::VoteCounts sum;
};

/// The votes between the same conditions, by cohort and round, with their sums: Table 4 of the
/// punch paper. A sum counts a participant once a round. Such votes are not independent of each
/// other, so a sum has no p and no interval.
struct VoteTable {
  std::vector<std::string> options;  ///< condition ids
  std::vector<CohortVotes> cohorts;  ///< in the order of the protocol; those that were asked
  analysis::VoteCounts total;        ///< over all cohorts
};

/// The tables of all votes, one for each set of options. They point into @p results.
std::vector<VoteTable> voteTables(const Results& results);

}  // namespace study

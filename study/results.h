#pragma once

#include <string>
#include <vector>

#include "analysis/pairwise_comparisons.h"
#include "analysis/vote_counts.h"
#include "study/run_mode.h"
#include "study/study.h"

namespace study {

/// What became of the people of a cohort.
struct CohortFlow {
  std::string cohort;
  int enrolled = 0;
  int completed = 0;
  int inProgress = 0;
  int declined = 0;
  int withdrawn = 0;
  int rejected = 0;
  int abortedHardware = 0;
};

/// The keyed answers of one cohort to a family's instrument, condition by condition, and the
/// declared comparisons between them.
struct CohortResult {
  std::string cohort;
  std::vector<analysis::NamedCounts> conditions;  ///< by id; the answers are keyed
  analysis::PairwiseComparisons comparisons;
};

struct FamilyResult {
  protocols::Family family;
  std::vector<CohortResult> cohorts;
};

/// Who preferred what, in one cohort, after one block.
struct VoteResult {
  std::string cohort;
  std::string phase;  ///< the preference's
  std::string block;
  analysis::VoteCounts votes;  ///< by condition id
};

/// What a study says, computed as the punch paper did (profile `as-published`): answers of all
/// statements and rounds pooled per person and method, statements with key -1 reversed, Welch's
/// t-tests, Bonferroni's correction over the declared family. Only completed sessions count, and of
/// those only steps that were finished and not repeated.
struct Results {
  RunMode runMode = RunMode::Live;
  std::vector<CohortFlow> flow;
  std::vector<FamilyResult> families;
  std::vector<VoteResult> votes;

  int completed() const;
};

/// @throws storage::StorageError
Results computeResults(Study& study, RunMode mode);

}  // namespace study

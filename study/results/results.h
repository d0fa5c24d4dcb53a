#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "analysis/data/answer_table.h"
#include "analysis/data/vote_counts.h"
#include "analysis/summary/flags.h"
#include "analysis/summary/pairwise_comparisons.h"
#include "analysis/summary/position_effect.h"
#include "analysis/summary/scale_checks.h"
#include "analysis/summary/within_analysis.h"
#include "analysis/tests/vote_tests.h"
#include "study/model/run_mode.h"
#include "study/results/instrument_scores.h"
#include "study/session/study.h"

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

  /// One more session.
  void add(SessionState state);
};

/// The keyed answers of one cohort to a family's instrument, condition by condition, and the
/// declared comparisons between them.
struct CohortResult {
  std::string cohort;
  analysis::AnswerTable table;
  std::vector<analysis::NamedCounts> conditions;  ///< by id; the answers are keyed
  analysis::PairwiseComparisons comparisons;      ///< as in the punch paper
  analysis::WithinAnalysis within;                ///< with the participant as the unit
  analysis::ScaleChecks checks;                   ///< distribution and reliability
  analysis::PositionEffect position;              ///< of the order
  std::vector<analysis::Flag> flags;              ///< what a reader has to know
};

/// Two cohorts' participants' means of one condition. Probabilities and effects are for the first
/// cohort having the larger values.
struct BetweenResult {
  std::string condition;
  std::string cohort1;
  std::string cohort2;
  std::vector<analysis::TestRow> tests;  ///< the registered tests of cohorts (StudyUse)

  const analysis::TestRow& test(std::string_view id) const {
    return analysis::testNamed(tests, id);
  }
};

/// The id of a test that a protocol can declare: "paired_t".
std::string_view idOf(protocols::TestType test) noexcept;

struct FamilyResult {
  protocols::Family family;
  bool isDeclared = true;  ///< as it stands, before the first live participant (plan_history.h)
  std::vector<CohortResult> cohorts;
  std::vector<BetweenResult> between;

  /// Whether the protocol names the test of this id, declared before there were data or not.
  bool isNamed(std::string_view test) const { return idOf(family.test) == test; }
  /// Whether it is the one that was declared: confirmatory, all else is exploratory.
  bool isConfirmatory(std::string_view test) const { return isDeclared && isNamed(test); }
};

/// How a study is computed (docs/statistics.md).
enum class Profile {
  AsPublished,  ///< all answers pooled, Welch's t-test, as the punch paper did
  Recommended,  ///< the participant is the unit
};

/// A kind of flag, and what it found by cohort.
struct RaisedFlag {
  const analysis::Flag* flag = nullptr;  ///< of the first cohort that has it
  std::vector<std::pair<std::string, const analysis::Flag*>> found;  ///< cohort, and what
};

/// The flags of all cohorts of a family, each kind once, in the order in which cohorts have them.
std::vector<RaisedFlag> flagsByKind(const FamilyResult& family);

/// Who preferred what, in one cohort, after one block.
struct VoteResult {
  std::string cohort;
  std::string phase;  ///< the preference's
  std::string block;
  analysis::VoteCounts votes;  ///< by condition id
  analysis::EqualSharesResult test;
  std::vector<std::optional<analysis::Interval>> intervals;  ///< Wilson's, of each share, at 95 %
};

/// What a study says, in both profiles: as the punch paper did, and with the participant as the
/// unit. Statements with key -1 are reversed. Only completed sessions count, and of those only
/// steps that were finished and not repeated.
struct Results {
  RunMode runMode = RunMode::Live;
  std::vector<CohortFlow> flow;
  std::vector<FamilyResult> families;
  std::vector<VoteResult> votes;
  std::vector<InstrumentSummary> instruments;  ///< those with scores or thresholds

  int completed() const;
};

/// @throws storage::StorageError
Results computeResults(Study& study, RunMode mode);

}  // namespace study

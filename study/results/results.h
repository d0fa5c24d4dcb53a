#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "analysis/data/answer_table.h"
#include "analysis/data/vote_shares.h"
#include "analysis/hypothesis_tests/vote_tests.h"
#include "analysis/summary/answer_checks.h"
#include "analysis/summary/flags.h"
#include "analysis/summary/pairwise_comparisons.h"
#include "analysis/summary/site_comparison.h"
#include "analysis/summary/within_analysis.h"
#include "study/model/run_mode.h"
#include "study/results/instrument_scores.h"
#include "study/results/item_summaries.h"
#include "study/session/study.h"

namespace study {

/// Numbers of sessions of a cohort: enrolled, and by their present state.
struct CohortFlow {
  std::string cohort;
  int enrolled = 0;
  int completed = 0;
  int inProgress = 0;
  int declined = 0;
  int withdrawn = 0;
  int rejected = 0;
  int abortedHardware = 0;
  int erased = 0;

  /// Counts a session in that state.
  void add(SessionState state);
};

/// The results of one cohort for one family: its answers by condition, reversed where a statement's
/// key is −1, and the declared comparisons.
struct CohortResult {
  std::string cohort;
  analysis::AnswerTable table;
  std::vector<analysis::NamedSample> conditions;  ///< by condition id; answers are reversed by key
  analysis::PairwiseComparisons comparisons;      ///< on pooled answers, as in the punch paper
  analysis::WithinAnalysis within;                ///< tests within participants
  analysis::ScaleChecks checks;                   ///< distribution and reliability
  analysis::PositionEffect position;              ///< effect of a condition's place in the order
  std::vector<analysis::Flag> flags;              ///< notes on doubtful data and tests
  /// Results at each site and pooled over sites; std::nullopt for fewer than two sites.
  std::optional<analysis::SiteAnalysis> sites = std::nullopt;
};

/// The comparison of two cohorts in one condition, based on one mean for each participant. Positive
/// effects, and probabilities above 0.5, mean larger values in cohort1.
struct BetweenResult {
  std::string condition;
  std::string cohort1;
  std::string cohort2;
  std::vector<analysis::TestRow> tests;  ///< all registered tests that compare cohorts (StudyUse)

  const analysis::TestRow& test(std::string_view id) const {
    return analysis::testNamed(tests, id);
  }
};

/// The id of a test that a protocol can declare: "paired_t".
std::string_view idOf(protocols::TestType test) noexcept;

/// The results of one family of comparisons.
struct FamilyResult {
  protocols::Family family;
  /// Whether the family was declared as it is now before the first live participant began
  /// (analysis_plan_history.h).
  bool isDeclared = true;
  std::vector<CohortResult> cohorts;
  std::vector<BetweenResult> between;

  /// Whether the protocol declares the test with this id for the family, no matter when.
  bool isNamed(std::string_view test) const { return idOf(family.test) == test; }
  /// Whether this test was declared before the first live participant began. Such a test is
  /// confirmatory; all others are exploratory.
  bool isConfirmatory(std::string_view test) const { return isDeclared && isNamed(test); }
};

/// A set of statistics in which a study's results are shown (docs/statistics.md).
enum class Profile {
  Declared,     ///< for each family the profile that contains its declared test
  AsPublished,  ///< Welch's t-test on all answers pooled, as in the punch paper
  Recommended,  ///< tests within participants
};

/// A kind of flag, and the cohorts for which it was raised.
struct RaisedFlag {
  const analysis::Flag* flag = nullptr;  ///< of the first of these cohorts
  std::vector<std::pair<std::string, const analysis::Flag*>> found;  ///< by id of a cohort
};

/// The mean of all answers to the family about a condition; std::nullopt without answers.
std::optional<double> meanOfAll(const FamilyResult& family, const std::string& condition);

/// Whether a profile shows a family's tests on pooled answers instead of those within participants.
bool isPooled(Profile profile, const protocols::Family& family) noexcept;

/// The flags of all cohorts of a family: each kind once, in the order of first occurrence. Flags on
/// pooled tests are left out unless @p hasPooledTests is true.
std::vector<RaisedFlag> flagsByKind(const FamilyResult& family, bool hasPooledTests);

/// The votes of one cohort on one preference question about one block.
struct VoteResult {
  std::string cohort;
  std::string site;   ///< empty: votes of all sites
  std::string phase;  ///< phase of the preference
  std::string block;
  analysis::VoteCounts votes;  ///< by id of the chosen condition
  std::size_t leftOut = 0;     ///< votes of participants who had not felt every alternative
  analysis::EqualSharesResult test;
  std::vector<std::optional<analysis::Interval>> intervals;  ///< Wilson's, 95 %, of each share
};

/// The results of a study for both profiles: tests on pooled answers as in the punch paper, and
/// tests within participants. Answers to statements with key −1 are reversed. Only completed
/// sessions count, and of these only steps that were finished and not repeated. Each answer is read
/// by the version of the protocol of its session; answers on another scale than that of the newest
/// version are left out (docs/decisions/0077).
struct Results {
  RunMode runMode = RunMode::Live;
  std::vector<CohortFlow> flow;
  /// The flow of all cohorts at each site, by the site's name; empty for fewer than two sites.
  std::vector<std::pair<std::string, CohortFlow>> siteFlow = {};
  std::vector<FamilyResult> families;
  std::vector<VoteResult> votes;
  std::vector<VoteResult> siteVotes = {};      ///< of each site; empty for fewer than two sites
  std::vector<InstrumentSummary> instruments;  ///< scores, thresholds, consistency
  ItemResults answers;                         ///< summaries of single items
  /// What later versions of the protocol changed in items, scores and conditions for participants
  /// who completed before.
  std::vector<base::Message> changes = {};

  /// The number of completed sessions of all cohorts.
  int completed() const;
};

/// Which method of a declared comparison comes first; differences are first − second.
enum class PairOrder {
  AsDeclared,
  HigherFirst,  ///< the one with the higher mean of the answers of all cohorts
};

/// @throws storage::StorageError
Results computeResults(Study& study, RunMode mode, PairOrder order = PairOrder::AsDeclared);

}  // namespace study

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

/// How many sessions of a cohort were begun, completed or ended otherwise.
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

  /// Counts one more session.
  void add(SessionState state);
};

/// The keyed answers of one cohort to a family's instrument, condition by condition, and the
/// declared comparisons between them.
struct CohortResult {
  std::string cohort;
  analysis::AnswerTable table;
  std::vector<analysis::NamedSample> conditions;  ///< by id; the answers are keyed
  analysis::PairwiseComparisons comparisons;      ///< as in the punch paper
  analysis::WithinAnalysis within;                ///< with the participant as the unit
  analysis::ScaleChecks checks;                   ///< distribution and reliability
  analysis::PositionEffect position;              ///< effect of the position in the order
  std::vector<analysis::Flag> flags;              ///< remarks on data and tests
  /// Results of each site and pooled over sites, if there are several.
  std::optional<analysis::SiteAnalysis> sites = std::nullopt;
};

/// The comparison of two cohorts in one condition, by participants' means. Positive effects, and
/// probabilities above 0.5, mean larger values in cohort1.
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
  /// Whether its present form was declared before the first live participant
  /// (analysis_plan_history.h).
  bool isDeclared = true;
  std::vector<CohortResult> cohorts;
  std::vector<BetweenResult> between;

  /// Whether the protocol names the test with this id, declared in time or not.
  bool isNamed(std::string_view test) const { return idOf(family.test) == test; }
  /// Whether this test was declared in time. It is then confirmatory; all others are exploratory.
  bool isConfirmatory(std::string_view test) const { return isDeclared && isNamed(test); }
};

/// A way to compute a study's results (docs/statistics.md).
enum class Profile {
  Declared,     ///< for each family, the profile that has its declared test
  AsPublished,  ///< all answers pooled, Welch's t-test, as in the punch paper
  Recommended,  ///< the participant is the unit
};

/// A kind of flag, with the cohorts that have it.
struct RaisedFlag {
  const analysis::Flag* flag = nullptr;  ///< of the first cohort that has it
  std::vector<std::pair<std::string, const analysis::Flag*>> found;  ///< cohort and its flag
};

/// Whether a profile shows the pooled tests of a family, and not those within people.
bool isPooled(Profile profile, const protocols::Family& family) noexcept;

/// The flags of all cohorts of a family, each kind once, in order of first occurrence. Flags that
/// concern pooled tests only are left out unless @p hasPooledTests.
std::vector<RaisedFlag> flagsByKind(const FamilyResult& family, bool hasPooledTests);

/// The preferences of one cohort after one block.
struct VoteResult {
  std::string cohort;
  std::string site;   ///< empty: at all sites
  std::string phase;  ///< of the preference
  std::string block;
  analysis::VoteCounts votes;  ///< by condition id
  analysis::EqualSharesResult test;
  std::vector<std::optional<analysis::Interval>> intervals;  ///< Wilson's, of each share, at 95 %
};

/// The results of a study in both profiles: as in the punch paper, and tests within participants;
/// the participant is the unit. Answers to statements with key −1 are reversed. Only completed
/// sessions count, and of those only steps that were finished and not repeated.
struct Results {
  RunMode runMode = RunMode::Live;
  std::vector<CohortFlow> flow;
  /// The flow of all cohorts at each site, by its name; empty if there are fewer than two sites.
  std::vector<std::pair<std::string, CohortFlow>> siteFlow = {};
  std::vector<FamilyResult> families;
  std::vector<VoteResult> votes;
  std::vector<VoteResult> siteVotes = {};      ///< of each site; empty if there are not several
  std::vector<InstrumentSummary> instruments;  ///< see InstrumentSummary
  ItemResults answers;                         ///< every answered item by itself

  int completed() const;
};

/// @throws storage::StorageError
Results computeResults(Study& study, RunMode mode);

}  // namespace study

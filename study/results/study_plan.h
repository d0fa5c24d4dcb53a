#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analysis/hypothesis_tests/attainable_p.h"
#include "analysis/planning/simulated_power.h"
#include "analysis/planning/site_power.h"
#include "protocols/model/loaded_protocol.h"
#include "study/session/session_length.h"

namespace study {

/// What a study plan is computed from, in addition to the protocol.
struct StudyPlanOptions {
  std::optional<std::uint64_t> participants;  ///< per cohort; std::nullopt: the protocol's
  double dz = 1.0;                            ///< the effect to detect: Cohen's d_z
  std::optional<double> alpha;                ///< significance level; std::nullopt: the family's
  double power = 0.8;                         ///< desired power
  std::uint64_t studies = 2000;               ///< number of simulated studies; 0: no simulation
  std::uint64_t seed = 1;                     ///< seed of the simulation
  /// How answers vary: see analysis::LikertModel. Its numbers of points, conditions and answers and
  /// its effect are replaced by those of the protocol and of the members above.
  analysis::LikertModel model;
  Pace pace;
  std::optional<analysis::SitePlan> sites = {};  ///< sites of each cohort; std::nullopt: one site
};

/// A block, and the number of participants for which its orders are balanced.
struct BlockPlan {
  std::string phase;
  std::size_t conditions = 0;
  protocols::OrderType order = protocols::OrderType::Fixed;
  std::size_t multipleOf = 1;  ///< see protocols::Balance::multipleOf
  bool hasOneOrder = false;    ///< whether all participants have the same order
};

/// What a family of comparisons can detect at several sites.
struct SiteDetectability {
  double designEffect = 1.0;
  double power = 0.0;  ///< closed form, for the requested effect, pooled over sites
  std::optional<analysis::SimulatedSitePower> found;  ///< simulated with the requested effect
  /// Simulated without an effect: the rate of false positives.
  std::optional<analysis::SimulatedSitePower> falsePositives;
};

/// What a family of comparisons can detect with a number of participants.
struct Detectability {
  std::uint64_t participants = 0;
  analysis::AttainableP pair;          ///< smallest p that an exact paired test can attain
  bool canPairsBeSignificant = false;  ///< whether this p is at most levels.mostLenient
  /// Smallest attainable p of an exact Friedman test; for three or more conditions.
  std::optional<analysis::AttainableP> friedman;
  std::optional<double> power;  ///< of a paired t-test for the requested effect; n ≥ 2
  std::optional<analysis::SimulatedPower> found;  ///< simulated with the requested effect
  /// Simulated without an effect: the rate of false positives.
  std::optional<analysis::SimulatedPower> falsePositives;
  /// At several sites, if each has two participants.
  std::optional<SiteDetectability> sites = {};
};

/// A family of comparisons as the protocol declares it.
struct FamilyPlan {
  std::string id;
  std::string title;
  std::size_t comparisons = 0;
  std::size_t conditions = 0;
  std::size_t answers = 0;  ///< per participant and condition; the smallest number over conditions
  bool isScore = false;     ///< whether each answer is a score of a form
  int points =
      5;  ///< number of points of the scale, or of the grid that simulates a continuous one
  bool isContinuous = false;  ///< whether the scale has no points; also that of a score
  double alpha = 0.05;
  analysis::FamilyLevels levels;  ///< powers are at the strictest one
  bool isCorrected = true;        ///< whether p is corrected for the number of comparisons
  std::string correction;         ///< "Holm"
  protocols::TestType test = protocols::TestType::Welch;  ///< powers are of a paired t-test
  /// Fewest participants for which an exact paired test can be significant.
  std::uint64_t fewestForSignificance = 0;
  std::optional<std::uint64_t> sampleSizeForPower;  ///< participants needed for the requested
                                                    ///< effect and power
  std::optional<std::uint64_t> recommended;  ///< fewest participants that suffice for power and
                                             ///< significance and balance the orders
  /// Simulated with the recommended participants: how often the declared test finds the requested
  /// effect. Not of a paired t-test, nor of more than 500 participants.
  std::optional<analysis::DetectionRate> foundIfRecommended = {};
  /// Participants over all sites needed for the requested effect and power; std::nullopt without
  /// sites, or if no number suffices.
  std::optional<std::uint64_t> sampleSizeForPowerAtSites = {};
  /// The fewest of them that are equally many at each site and balance the orders there.
  std::optional<std::uint64_t> recommendedAtSites = {};
  std::vector<Detectability> detectabilities = {};  ///< for every cohort, in the protocol's order
};

/// A vote between the alternatives of a block, in one cohort.
struct VotePlan {
  std::string phase;
  std::string cohort;
  int alternatives = 0;
  std::uint64_t votes = 0;
  std::optional<std::uint64_t>
      votesForSignificance;  ///< fewest votes for one alternative that are significant
  bool canDecide = false;    ///< whether a unanimous vote would be significant
};

/// A comparison of two cohorts in one condition.
struct CohortPairPlan {
  std::string first;
  std::string second;
  analysis::AttainableP smallestP;  ///< smallest attainable p of an exact Mann–Whitney test
};

/// The planned participants of one cohort.
struct CohortPlan {
  std::string id;
  std::string title;
  std::uint64_t participants = 0;  ///< 0: not in the protocol
  /// Whether `participants` balances every block whose orders can be balanced.
  bool isBalanced = false;
};

/// What can be computed from a protocol before the study begins.
struct StudyPlan {
  std::string title;
  StudyPlanOptions planOptions;
  std::vector<BlockPlan> blocks;
  /// Every multiple of this number balances every block that can be balanced; 1: there is none.
  std::size_t balancedBy = 1;
  std::vector<CohortPlan> cohorts;
  std::vector<CohortPairPlan> cohortPairs;  ///< for pairs of cohorts whose numbers are known
  std::vector<FamilyPlan> families;
  std::vector<VotePlan> votes;
  SessionLength length;
  std::vector<double> forceLimits;  ///< of each of the study's devices [N]
  double largestForce = 0.0;        ///< largest of them [N]
};

StudyPlan planOf(const protocols::LoadedProtocol& loaded, const StudyPlanOptions& planOptions);

/// How often the test that a protocol declares found the effect.
const analysis::DetectionRate& rateOf(
    protocols::TestType test, const analysis::SimulatedPower& found) noexcept;

/// The effects (d_z) and the numbers of participants for which a table of power is shown.
std::vector<double> effectsToShow(const StudyPlan& plan);
std::vector<std::uint64_t> sizesToShow(const FamilyPlan& family);

/// "trials on the device".
std::string partInWords(StepKind kind);

std::string studyPlanAsText(const StudyPlan& plan);

/// A paragraph on numbers of participants and durations for an application to an ethics committee.
std::string ethicsParagraph(const StudyPlan& plan);

}  // namespace study

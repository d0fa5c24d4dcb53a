#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analysis/planning/simulated_power.h"
#include "analysis/tests/attainable_p.h"
#include "protocols/model/loaded_protocol.h"
#include "study/session/session_length.h"

namespace study::app {

/// What is asked of a plan.
struct PlanQuestion {
  std::optional<std::uint64_t> participants;  ///< of every cohort, instead of what is planned
  double dz = 1.0;               ///< the difference that is to be found, in its own deviations
  std::optional<double> alpha;   ///< of a family, instead of what it declares
  double power = 0.8;            ///< that is wanted
  std::uint64_t studies = 2000;  ///< to be simulated; 0: none
  std::uint64_t seed = 1;        ///< of the simulation
  /// How answers vary: see analysis::LikertModel. Points, conditions, answers and the effect are
  /// taken from the protocol and from above.
  analysis::LikertModel model;
  Pace pace;
};

/// A block, and how many participants balance its orders.
struct BlockPlan {
  std::string phase;
  std::size_t conditions = 0;
  protocols::OrderType order = protocols::OrderType::Fixed;
  std::size_t multipleOf = 1;  ///< as protocols::Balance::multipleOf
  bool hasOneOrder = false;    ///< the same for everybody
};

/// What a family of comparisons can find with so many participants.
struct Prospect {
  std::uint64_t participants = 0;
  analysis::AttainableP pair;  ///< the smallest p of an exact paired test (sign flip, signed rank)
  bool canFindPairs = false;   ///< that p is not above alpha per comparison
  std::optional<analysis::AttainableP> friedman;  ///< of all conditions at once; from three on
  std::optional<double> power;  ///< of a paired t-test for the effect asked for; from two people on
  std::optional<analysis::SimulatedPower> found;     ///< with that effect
  std::optional<analysis::SimulatedPower> invented;  ///< without any effect: errors
};

/// A family of comparisons as the protocol declares it.
struct FamilyPlan {
  std::string id;
  std::string title;
  std::size_t comparisons = 0;
  std::size_t conditions = 0;
  std::size_t answers = 0;  ///< of one person to one condition; the fewest of all conditions
  int points = 5;           ///< of the scale
  double alpha = 0.05;
  double alphaPerTest = 0.05;
  bool isCorrected = true;                ///< alphaPerTest is that of the strictest step
  std::string correction;                 ///< "Holm"
  std::uint64_t fewestForAnyP = 0;        ///< with fewer no exact paired test can find anything
  std::optional<std::uint64_t> forPower;  ///< participants for the effect and the power asked for
  std::optional<std::uint64_t> recommended;  ///< the same, as a number that balances the orders
  std::vector<Prospect> prospects;           ///< for every cohort, in the protocol's order
};

/// A vote on the alternatives of a block, in one cohort.
struct VotePlan {
  std::string phase;
  std::string cohort;
  int alternatives = 0;
  std::uint64_t votes = 0;
  std::optional<std::uint64_t> toWin;  ///< for one alternative, to be more than chance
  bool canDecide = false;              ///< all votes for one alternative would be more than chance
};

/// Two cohorts beside each other, in one condition.
struct CohortPairPlan {
  std::string first;
  std::string second;
  analysis::AttainableP smallest;  ///< of an exact Mann–Whitney test
};

struct CohortPlan {
  std::string id;
  std::string title;
  std::uint64_t participants = 0;  ///< 0: nobody has said how many
  bool isBalanced = false;         ///< in every block whose orders can be
};

/// Everything that a protocol tells before anybody comes.
struct StudyPlan {
  std::string title;
  PlanQuestion question;
  std::vector<BlockPlan> blocks;
  std::size_t balancedBy = 1;  ///< a multiple of it balances every block; 1: nothing to balance
  std::vector<CohortPlan> cohorts;
  std::vector<CohortPairPlan> cohortPairs;  ///< of those whose participants are known
  std::vector<FamilyPlan> families;
  std::vector<VotePlan> votes;
  SessionLength length;
  double mostForce = 0.0;  ///< of all devices that the study needs [N]
};

StudyPlan planOf(const protocols::LoadedProtocol& loaded, const PlanQuestion& question);

std::string studyPlanAsText(const StudyPlan& plan);
std::string studyPlanAsJson(const StudyPlan& plan);

/// What an application to an ethics committee asks about numbers and duration: a paragraph.
std::string ethicsParagraph(const StudyPlan& plan);

}  // namespace study::app

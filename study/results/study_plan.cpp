#include "study/results/study_plan.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "analysis/planning/power.h"
#include "protocols/orders/schedule.h"
#include "study/results/apa_text.h"
#include "study/results/pooled_results.h"

namespace study {
namespace {

using protocols::LoadedProtocol;
using protocols::PhaseType;

constexpr double kDefaultAlpha = 0.05;

std::vector<BlockPlan> blocksOf(const protocols::Protocol& protocol) {
  std::vector<BlockPlan> blocks;
  for (const auto& phase : protocol.phases) {
    if (phase.type != PhaseType::Block) continue;
    const auto balance = protocols::balanceOf(protocol, phase, 1, protocol.cohorts.front().id, 0);
    blocks.push_back(
        {.phase = phase.id,
         .conditions = phase.trials.conditions.size(),
         .order = phase.trials.order.type,
         .multipleOf = balance.multipleOf,
         .hasOneOrder = balance.multipleOf == 1});
  }
  return blocks;
}

std::size_t balancedBy(const std::vector<BlockPlan>& blocks) {
  std::size_t multiple = 1;
  for (const auto& block : blocks) {
    if (block.multipleOf > 0) multiple = std::lcm(multiple, block.multipleOf);
  }
  return multiple;
}

std::vector<CohortPlan> cohortsOf(
    const protocols::Protocol& protocol,
    const StudyPlanOptions& planOptions,
    std::size_t multiple) {
  std::vector<CohortPlan> cohorts;
  for (const auto& cohort : protocol.cohorts) {
    const auto planned = static_cast<std::uint64_t>(std::max(cohort.planned, 0));
    const auto participants = planOptions.participants.value_or(planned);
    cohorts.push_back(
        {.id = cohort.id,
         .title = cohort.title.in("en"),
         .participants = participants,
         .isBalanced = participants > 0 && multiple > 1 && participants % multiple == 0});
  }
  return cohorts;
}

std::set<std::string> comparedConditions(const protocols::Family& family) {
  std::set<std::string> conditions;
  for (const auto& pair : family.comparisons) conditions.insert({pair.first, pair.second});
  return conditions;
}

/// The number of values that a participant gives @p family about @p condition: one per compared
/// item, or one per form if a score is compared.
std::size_t answersTo(
    const std::string& condition, const protocols::Family& family, const LoadedProtocol& loaded) {
  const auto& instrument = *loaded.instrument(family.instrument);
  std::size_t answers = 0;
  for (const auto& phase : loaded.protocol.phases) {
    const bool isAsked = phase.type == PhaseType::Block &&
                         std::ranges::count(phase.trials.conditions, condition) > 0 &&
                         (family.blocks.empty() || std::ranges::count(family.blocks, phase.id) > 0);
    if (!isAsked) continue;
    for (const auto& asked : phase.trials.questionnaires) {
      if (asked.instrument != family.instrument) continue;
      const auto items = instrument.itemsOf(asked.itemSetFor(condition));
      answers +=
          family.score.empty() ? protocols::comparedItems(family, items).size() : std::size_t{1};
    }
  }
  return answers;
}

/// The number of points of a family's scale; std::nullopt if it is continuous.
std::optional<int> pointsOf(const protocols::Family& family, const LoadedProtocol& loaded) {
  constexpr double kMostPoints = 1e6;
  const auto& instrument = *loaded.instrument(family.instrument);
  const auto scale = protocols::scaleOf(family, instrument);
  if (!scale || !family.score.empty()) return std::nullopt;
  const auto items = protocols::comparedItems(family, instrument.items);
  const auto first = std::ranges::find_if(
      items, [](const auto& item) { return protocols::scaleOf(item).has_value(); });
  const double step = scale->isPointScale || first == items.end() ? 1.0 : first->step;
  const double points = std::floor((scale->highest - scale->lowest) / step) + 1.0;
  return points < kMostPoints ? std::optional(static_cast<int>(points)) : std::nullopt;
}

analysis::PowerSimulation simulationOf(
    const FamilyPlan& family,
    const StudyPlanOptions& planOptions,
    std::uint64_t participants,
    double dz) {
  analysis::PowerSimulation simulation{
      .model = planOptions.model,
      .participants = participants,
      .alpha = family.alpha,
      .alphaPerTest = family.levels.strictest,
      .studies = planOptions.studies,
      .seed = planOptions.seed};
  simulation.model.points = family.points;
  simulation.model.conditions = static_cast<int>(family.conditions);
  simulation.model.answers = static_cast<int>(family.answers);
  simulation.model.dz = dz;
  return simulation;
}

SiteDetectability detectabilityAtSites(
    const FamilyPlan& family,
    const StudyPlanOptions& planOptions,
    const analysis::SitePlan& sites,
    std::uint64_t participants) {
  SiteDetectability detectability{
      .designEffect = sites.designEffect(participants),
      .power =
          analysis::pooledSitesPower(planOptions.dz, participants, sites, family.levels.strictest)};
  if (planOptions.studies == 0 || family.answers == 0) return detectability;
  const auto simulatePowerFor = [&](double dz) {
    return analysis::simulateSitePower(simulationOf(family, planOptions, participants, dz), sites);
  };
  detectability.found = simulatePowerFor(planOptions.dz);
  detectability.falsePositives = simulatePowerFor(0.0);
  return detectability;
}

Detectability detectabilityOf(
    const FamilyPlan& family, const StudyPlanOptions& planOptions, std::uint64_t participants) {
  Detectability detectability{
      .participants = participants, .pair = analysis::smallestSignFlipP(participants)};
  detectability.canPairsBeSignificant = detectability.pair.p <= family.levels.mostLenient;
  if (family.conditions > 2) {
    detectability.friedman =
        analysis::smallestFriedmanP(participants, static_cast<int>(family.conditions));
  }
  if (participants < 2) return detectability;
  detectability.power =
      analysis::pairedTPower(planOptions.dz, participants, family.levels.strictest);
  if (planOptions.studies > 0 && family.answers > 0) {
    const auto simulatePowerFor = [&](double dz) {
      return analysis::simulatePower(simulationOf(family, planOptions, participants, dz));
    };
    detectability.found = simulatePowerFor(planOptions.dz);
    detectability.falsePositives = simulatePowerFor(0.0);
  }
  const auto& sites = planOptions.sites;
  if (sites && participants >= sites->fewestParticipants()) {
    detectability.sites = detectabilityAtSites(family, planOptions, *sites, participants);
  }
  return detectability;
}

FamilyPlan declaredPlanOf(
    const protocols::Family& family,
    const LoadedProtocol& loaded,
    const StudyPlanOptions& planOptions) {
  constexpr int kPointsOfContinuousScale = 101;  // approximate it
  const auto conditions = comparedConditions(family);
  const auto points = pointsOf(family, loaded);
  FamilyPlan plan{
      .id = family.id,
      .title = family.title,
      .comparisons = family.comparisons.size(),
      .conditions = conditions.size(),
      .isScore = !family.score.empty(),
      .points = points.value_or(kPointsOfContinuousScale),
      .isContinuous = !points,
      .alpha = planOptions.alpha.value_or(family.alpha),
      .isCorrected = family.correction != protocols::CorrectionType::None,
      .correction = std::string(nameOf(family.correction)),
      .test = family.test};
  plan.levels = analysis::levelsOf(plan.alpha, plan.comparisons, adjustmentOf(family.correction));
  plan.answers = answersTo(*conditions.begin(), family, loaded);
  for (const auto& condition : conditions) {
    plan.answers = std::min(plan.answers, answersTo(condition, family, loaded));
  }
  return plan;
}

std::optional<std::uint64_t> roundedUp(std::optional<std::uint64_t> size, std::uint64_t multiple) {
  if (size) *size = (*size + multiple - 1) / multiple * multiple;
  return size;
}

/// How many participants the requested power needs.
void addSizes(FamilyPlan& plan, const StudyPlan& study) {
  const double dz = study.planOptions.dz;
  const double power = study.planOptions.power;
  const double level = plan.levels.strictest;
  const auto multiple = static_cast<std::uint64_t>(study.balancedBy);
  plan.fewestForSignificance = analysis::fewestParticipantsForSignFlip(plan.levels.mostLenient);
  if (power <= level) return;
  plan.sampleSizeForPower = analysis::participantsForPower(dz, level, power);
  if (plan.sampleSizeForPower) {
    plan.recommended =
        roundedUp(std::max(*plan.sampleSizeForPower, plan.fewestForSignificance), multiple);
  }
  const auto& sites = study.planOptions.sites;
  if (!sites) return;
  plan.sampleSizeForPowerAtSites = analysis::participantsForPower(dz, *sites, level, power);
  plan.recommendedAtSites = roundedUp(plan.sampleSizeForPowerAtSites, sites->sites * multiple);
}

void simulateRecommended(FamilyPlan& plan, const StudyPlanOptions& planOptions) {
  constexpr std::uint64_t kMostParticipants = 500;
  const bool isPairedT = plan.test == protocols::TestType::PairedT;
  const auto participants = plan.recommended.value_or(0);
  if (isPairedT || planOptions.studies == 0 || plan.answers == 0) return;
  if (participants < 2 || participants > kMostParticipants) return;
  plan.foundIfRecommended = rateOf(
      plan.test,
      analysis::simulatePower(simulationOf(plan, planOptions, participants, planOptions.dz)));
}

FamilyPlan familyPlan(
    const protocols::Family& family, const LoadedProtocol& loaded, const StudyPlan& study) {
  FamilyPlan plan = declaredPlanOf(family, loaded, study.planOptions);
  addSizes(plan, study);
  simulateRecommended(plan, study.planOptions);
  for (const auto& cohort : study.cohorts) {
    const auto same =
        std::ranges::find(plan.detectabilities, cohort.participants, &Detectability::participants);
    plan.detectabilities.push_back(
        same != plan.detectabilities.end()
            ? Detectability(*same)
            : detectabilityOf(plan, study.planOptions, cohort.participants));
  }
  return plan;
}

void addCohortPairs(StudyPlan& study) {
  for (std::size_t i = 0; i < study.cohorts.size(); ++i) {
    for (std::size_t j = i + 1; j < study.cohorts.size(); ++j) {
      const auto& first = study.cohorts[i];
      const auto& second = study.cohorts[j];
      if (first.participants == 0 || second.participants == 0) continue;
      study.cohortPairs.push_back(
          {first.id,
           second.id,
           analysis::smallestMannWhitneyP(first.participants, second.participants)});
    }
  }
}

void addVotes(StudyPlan& study, const protocols::Protocol& protocol) {
  const double alpha = study.planOptions.alpha.value_or(kDefaultAlpha);
  for (const auto& phase : protocol.phases) {
    if (phase.type != PhaseType::Preference) continue;
    const auto& conditions = protocol.phase(phase.block)->trials.conditions;
    for (const auto& cohort : study.cohorts) {
      VotePlan vote{
          .phase = phase.id,
          .cohort = cohort.id,
          .alternatives = static_cast<int>(conditions.size()),
          .votes = cohort.participants};
      if (vote.alternatives > 1) {
        vote.votesForSignificance =
            analysis::fewestVotesForSignificance(vote.votes, vote.alternatives, alpha);
        vote.canDecide = analysis::smallestVoteP(vote.votes, vote.alternatives).p <= alpha;
      }
      study.votes.push_back(vote);
    }
  }
}

}  // namespace

const analysis::DetectionRate& rateOf(
    protocols::TestType test, const analysis::SimulatedPower& found) noexcept {
  switch (test) {
    case protocols::TestType::Welch:
      return found.pooledWelch;
    case protocols::TestType::SignFlip:
      return found.signFlip;
    case protocols::TestType::SignedRank:
      return found.signedRank;
    case protocols::TestType::PairedT:
      break;
  }
  return found.pairedT;
}

StudyPlan planOf(const LoadedProtocol& loaded, const StudyPlanOptions& planOptions) {
  const auto& protocol = loaded.protocol;
  StudyPlan study{.title = protocol.study.title, .planOptions = planOptions};
  study.blocks = blocksOf(protocol);
  study.balancedBy = balancedBy(study.blocks);
  study.cohorts = cohortsOf(protocol, planOptions, study.balancedBy);
  for (const auto& family : protocol.analysis.families) {
    if (!family.comparisons.empty()) study.families.push_back(familyPlan(family, loaded, study));
  }
  addCohortPairs(study);
  addVotes(study, protocol);
  study.length = lengthOf(loaded, planOptions.pace);
  for (const auto& device : protocol.devices) {
    study.forceLimits.push_back(device.maxForce);
    study.largestForce = std::max(study.largestForce, device.maxForce);
  }
  return study;
}

}  // namespace study

#include "study/model/session_plan.h"

#include <algorithm>
#include <array>
#include <utility>

#include "study/model/named_value.h"

namespace study {
namespace {

constexpr std::array<std::string_view, 9> kStepKinds{
    "reading",
    "consent",
    "form",
    "benchmark",
    "trial",
    "questionnaire",
    "preference",
    "break",
    "interview"};

using protocols::Phase;
using protocols::PhaseType;

void addTrials(
    const protocols::Protocol& protocol,
    const Phase& phase,
    const protocols::PlannedBlock& block,
    std::vector<Step>& steps) {
  for (const auto& trial : block.trials) {
    const auto* condition = protocol.condition(trial.condition);
    Step step{
        .kind = StepKind::Trial,
        .phase = phase.id,
        .position = trial.position,
        .label = trial.label,
        .condition = trial.condition,
        .isVisualised = phase.trials.isVisualised.value_or(condition->isVisualised),
        .minimumCuts = phase.trials.minimumCuts};
    steps.push_back(step);
    step.kind = StepKind::Questionnaire;
    step.minimumCuts = 0;
    step.isVisualised = false;
    for (const auto& asked : phase.trials.questionnaires) {
      step.instrument = asked.instrument;
      step.itemSet = asked.itemSetFor(trial.condition);
      steps.push_back(step);
    }
  }
}

/// Adds an optional trial for each alternative, in the order of labels, before a preference.
void offerAgain(
    const protocols::Protocol& protocol,
    const Phase& preference,
    const protocols::PlannedBlock& block,
    std::vector<Step>& steps) {
  auto trials = block.trials;
  std::ranges::sort(trials, [](const auto& a, const auto& b) { return a.label < b.label; });
  const auto& seen = protocol.phase(preference.block)->trials.isVisualised;
  for (const auto& trial : trials) {
    steps.push_back(
        {.kind = StepKind::Trial,
         .phase = preference.id,
         .label = trial.label,
         .condition = trial.condition,
         .isVisualised = seen.value_or(protocol.condition(trial.condition)->isVisualised),
         .minimumCuts = 1,
         .isOptionalTrial = true});
  }
}

std::vector<std::string> labelsOf(const protocols::PlannedBlock& block) {
  std::vector<int> numbers;
  for (const auto& trial : block.trials) numbers.push_back(trial.label);
  std::ranges::sort(numbers);
  std::vector<std::string> labels;
  for (const int number : numbers) labels.push_back(std::to_string(number));
  return labels;
}

StepKind stepKind(PhaseType type) {
  switch (type) {
    case PhaseType::Consent:
      return StepKind::Consent;
    case PhaseType::Form:
      return StepKind::Form;
    case PhaseType::Benchmark:
      return StepKind::Benchmark;
    case PhaseType::Preference:
      return StepKind::Preference;
    case PhaseType::Break:
      return StepKind::Break;
    case PhaseType::Interview:
      return StepKind::Interview;
    default:
      return StepKind::Reading;
  }
}

}  // namespace

std::string_view nameOf(StepKind kind) noexcept {
  return kStepKinds[static_cast<std::size_t>(kind)];
}

std::optional<StepKind> stepKindNamed(std::string_view name) noexcept {
  return valueNamed<StepKind>(kStepKinds, name);
}

std::vector<Step> sessionPlan(
    const protocols::Protocol& protocol, const protocols::Schedule& schedule) {
  std::vector<Step> steps;
  for (const auto& phase : protocol.phases) {
    if (phase.type == PhaseType::Block) {
      addTrials(protocol, phase, *schedule.block(phase.id), steps);
      continue;
    }
    Step step{
        .kind = stepKind(phase.type),
        .phase = phase.id,
        .instrument = phase.instrument,
        .minimumCuts = phase.minimumCuts,
        .seconds = phase.seconds};
    if (phase.type == PhaseType::Preference) {
      step.alternatives = labelsOf(*schedule.block(phase.block));
      if (phase.hasOptionalTrials) offerAgain(protocol, phase, *schedule.block(phase.block), steps);
    }
    steps.push_back(std::move(step));
  }
  return steps;
}

}  // namespace study

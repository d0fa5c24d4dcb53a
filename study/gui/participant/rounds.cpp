#include "study/gui/participant/rounds.h"

#include <algorithm>
#include <vector>

namespace study::gui {
namespace {

/// The trials before the current step, without optional repetitions.
std::vector<Step> trialsBefore(const Session& session) {
  std::vector<Step> trials;
  for (int i = 0; i < session.stepIndex(); ++i) {
    const auto& step = session.plan()[static_cast<std::size_t>(i)];
    if (step.kind == StepKind::Trial && !step.isOptionalTrial) trials.push_back(step);
  }
  return trials;
}

/// The block of trials that the current step belongs to or asks about; else the step's own phase.
const std::string& blockOf(const Session& session) {
  const auto* phase = session.protocol().protocol.phase(session.step().phase);
  return phase->block.empty() ? phase->id : phase->block;
}

}  // namespace

RoundPlace placeOf(const Session& session) {
  RoundPlace place{.position = session.step().position};
  const auto& block = blockOf(session);
  for (const auto& phase : session.protocol().protocol.phases) {
    if (phase.type != protocols::PhaseType::Block) continue;
    ++place.rounds;
    if (phase.id != block) continue;
    place.round = place.rounds;
    place.alternatives = static_cast<int>(phase.trials.conditions.size());
  }
  return place;
}

bool isLabelledByPosition(const Session& session) {
  return session.protocol().protocol.labels.policy == protocols::LabelPolicy::Position;
}

bool reusesLabels(const Session& session) {
  const auto& step = session.step();
  return isLabelledByPosition(session) && !step.isOptionalTrial && step.position == 1 &&
         !trialsBefore(session).empty();
}

bool isNumberedInFeltOrder(const Session& session) {
  const auto& step = session.step();
  if (step.kind != StepKind::Preference || !isLabelledByPosition(session)) return false;
  const auto trials = trialsBefore(session);
  return !trials.empty() && blockOf(session) == trials.back().phase;
}

std::map<std::string, int> feltOrder(const Session& session) {
  const auto& step = session.step();
  std::map<std::string, int> order;
  const auto trials = trialsBefore(session);
  if (step.kind != StepKind::Preference || isLabelledByPosition(session) || trials.empty()) {
    return order;
  }
  const auto& block = blockOf(session);
  int place = 0;
  for (const auto& trial : trials) {
    if (trial.phase != block) continue;
    if (!order.emplace(std::to_string(trial.label), place++).second) return {};
  }
  return order;
}

const Step* nextTrial(const Session& session) {
  const auto& plan = session.plan();
  const auto next =
      std::find_if(plan.begin() + session.stepIndex(), plan.end(), [](const Step& step) {
        return step.kind == StepKind::Trial && !step.isOptionalTrial;
      });
  return next == plan.end() ? nullptr : &*next;
}

bool keepsNumbers(const Session& session, const Step& next) {
  const auto& protocol = session.protocol().protocol;
  const auto& now = protocol.phase(blockOf(session))->trials.conditions;
  const auto& then = protocol.phase(next.phase)->trials.conditions;
  return !isLabelledByPosition(session) &&
         std::is_permutation(now.begin(), now.end(), then.begin(), then.end());
}

}  // namespace study::gui

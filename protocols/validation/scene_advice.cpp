#include "protocols/validation/scene_advice.h"

#include <algorithm>
#include <string>

#include "haptics/engine/kalman_weight.h"
#include "haptics/models/interpolation.h"

namespace protocols {
namespace {

namespace engine = haptics::engine;
using questionnaires::Problems;

constexpr double kDeaf = 0.02;  // a weight below which nobody feels a force

void adviseOnWeight(const engine::KalmanSpec& spec, const std::string& path, Problems& problems) {
  const double weight = engine::interpolationWeight(spec);
  if (weight >= kDeaf && weight <= 1.0 - kDeaf) return;
  const bool isRecordingUnheard = weight < kDeaf;
  problems.warn(
      path + ".parameters",
      isRecordingUnheard
          ? "with this noise the recorded cut weighs next to nothing; the finite elements alone "
            "are felt"
          : "with this noise the finite elements weigh next to nothing; the recorded cut alone is "
            "felt",
      "bring noise.finite_elements and noise.interpolation closer together, or take another "
      "variant; 'palpate scene play' draws what is felt");
}

/// More force on the way out than on the way in pushes the hand on its own account.
void adviseOnBranches(
    const engine::InterpolationSpec& spec, const std::string& path, Problems& problems) {
  if (spec.branches != engine::Branches::Hysteresis) return;
  constexpr double kNoticeable = 0.05;  // [N]
  using Curve = haptics::models::Interpolation<double>;
  const Curve closing(spec.curve.data(), spec.curve.size(), spec.options);
  double most = 0.0;
  double where = 0.0;
  for (const auto& node : spec.opening) {
    std::size_t hint = 0;
    const double excess = node.force - closing.at(node.travel, hint).force;
    if (excess > most) {
      most = excess;
      where = node.travel;
    }
  }
  if (most < kNoticeable) return;
  const auto shown = [](double value) { return std::to_string(value).substr(0, 5); };
  problems.warn(
      path + ".parameters",
      "the opening branch lies up to " + shown(most) + " N above the closing one (at travel " +
          shown(where) + "), so that opening gives back more than closing took",
      "choose another closure of the recording, or take closing-only");
}

/// Whether some block shows condition @p id.
bool isSeen(const Protocol& protocol, const Condition& condition) {
  return std::any_of(protocol.phases.begin(), protocol.phases.end(), [&](const auto& phase) {
    const auto& felt = phase.trials.conditions;
    const bool isFelt = std::find(felt.begin(), felt.end(), condition.id) != felt.end();
    return isFelt && phase.trials.isVisualised.value_or(condition.scene.isVisualised);
  });
}

std::string anatomyOf(const Condition& condition) {
  return condition.anatomy ? condition.anatomy->name : std::string();
}

/// What is seen must not tell apart what is to be told apart by feel.
void adviseOnAnatomy(const Protocol& protocol, const Block& block, Problems& problems) {
  const Condition* first = nullptr;
  for (const auto& id : block.conditions) {
    const auto* condition = protocol.condition(id);
    if (condition == nullptr || !block.isVisualised.value_or(condition->scene.isVisualised))
      continue;
    if (first == nullptr) first = condition;
    if (anatomyOf(*first) == anatomyOf(*condition)) continue;
    const auto at = static_cast<std::size_t>(condition - protocol.conditions.data());
    problems.warn(
        "$.conditions[" + std::to_string(at) + "].scene",
        "'" + condition->id + "' shows another knee than '" + first->id +
            "', so that they can be told apart by what is seen",
        "give all conditions of a block the same 'anatomy'");
  }
}

}  // namespace

void adviseOnScenes(const Protocol& protocol, Problems& problems) {
  for (std::size_t i = 0; i < protocol.conditions.size(); ++i) {
    const std::string path = "$.conditions[" + std::to_string(i) + "].scene";
    const auto& condition = protocol.conditions[i];
    if (condition.anatomy && !isSeen(protocol, condition)) {
      problems.warn(
          path + ".anatomy",
          "it is never seen",
          "set 'visualisation' to true, in the scene or in a block");
    }
    const auto parts = engine::partsOf(condition.scene.model);
    if (parts.filter != nullptr) adviseOnWeight(*parts.filter, path, problems);
    if (parts.cut != nullptr) adviseOnBranches(*parts.cut, path, problems);
  }
  for (const auto& phase : protocol.phases) adviseOnAnatomy(protocol, phase.trials, problems);
}

}  // namespace protocols

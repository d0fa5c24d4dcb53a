#include <algorithm>
#include <string>

#include "haptics/engine/punch_models.h"
#include "haptics/models/interpolation.h"
#include "protocols/model/messages.h"
#include "protocols/validation/validation.h"

namespace protocols {
namespace {

namespace engine = haptics::engine;
using questionnaires::Problems;

constexpr double kUnfelt = 0.02;  // a smaller weight has no noticeable effect

void adviseOnWeight(const engine::KalmanSpec& spec, const std::string& path, Problems& problems) {
  const double weight = engine::interpolationWeight(spec);
  if (weight >= kUnfelt && weight <= 1.0 - kUnfelt) return;
  const bool isRecordingUnheard = weight < kUnfelt;
  problems.warn(
      path + ".parameters",
      isRecordingUnheard ? message("cut_not_felt") : message("elements_not_felt"),
      message("one_force_felt.fix"));
}

/// Warns of an opening branch with more force than the closing branch: it would push the hand by
/// itself.
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
      message("opening_gives_more", shown(most), shown(where)),
      message("opening_gives_more.fix"));
}

/// Whether a block shows the tissue of condition @p id.
bool isSeen(const Protocol& protocol, const Condition& condition) {
  return std::any_of(protocol.phases.begin(), protocol.phases.end(), [&](const auto& phase) {
    const auto& felt = phase.trials.conditions;
    const bool isFelt = std::find(felt.begin(), felt.end(), condition.id) != felt.end();
    return isFelt && phase.trials.isVisualised.value_or(condition.isVisualised);
  });
}

/// Warns if conditions of a block that are to be compared by touch show different knees.
void adviseOnAnatomy(const Protocol& protocol, const Block& block, Problems& problems) {
  const Condition* first = nullptr;
  for (const auto& id : block.conditions) {
    const auto* condition = protocol.condition(id);
    if (condition == nullptr || !block.isVisualised.value_or(condition->isVisualised)) continue;
    if (first == nullptr) first = condition;
    if (first->anatomy.value_or("") == condition->anatomy.value_or("")) continue;
    const auto at = static_cast<std::size_t>(condition - protocol.conditions.data());
    problems.warn(
        "$.conditions[" + std::to_string(at) + "].scene",
        message("other_knee", condition->id, first->id),
        message("other_knee.fix"));
  }
}

}  // namespace

void addSceneWarnings(const Protocol& protocol, Problems& problems) {
  for (std::size_t i = 0; i < protocol.conditions.size(); ++i) {
    const std::string path = "$.conditions[" + std::to_string(i) + "].scene";
    const auto& condition = protocol.conditions[i];
    if (condition.anatomy && !isSeen(protocol, condition)) {
      problems.warn(path + ".anatomy", message("knee_never_seen"), message("knee_never_seen.fix"));
    }
    const auto parts = engine::partsOf(*condition.model);
    if (parts.filter != nullptr) adviseOnWeight(*parts.filter, path, problems);
    if (parts.cut != nullptr) adviseOnBranches(*parts.cut, path, problems);
  }
  for (const auto& phase : protocol.phases) adviseOnAnatomy(protocol, phase.trials, problems);
}

}  // namespace protocols

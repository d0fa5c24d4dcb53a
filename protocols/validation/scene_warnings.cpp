#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/search.h"
#include "haptics/engine/punch_models.h"
#include "protocols/model/messages.h"
#include "protocols/validation/validation.h"
#include "questionnaires/json/document.h"

namespace protocols {
namespace {

namespace engine = haptics::engine;
using questionnaires::Problems;

constexpr double kNegligibleWeight = 0.02;  // a smaller weight of a force cannot be felt

void adviseOnWeight(const engine::KalmanSpec& spec, const std::string& path, Problems& problems) {
  const double weight = engine::interpolationWeight(spec);
  if (weight >= kNegligibleWeight && weight <= 1.0 - kNegligibleWeight) return;
  const bool isRecordingUnheard = weight < kNegligibleWeight;
  problems.warn(
      path + ".parameters",
      isRecordingUnheard ? message("cut_not_felt") : message("elements_not_felt"),
      message("one_force_felt.fix"));
}

/// Warns if the force of the opening branch is larger than that of the closing branch, because it
/// would push the hand by itself.
void adviseOnBranches(
    const engine::InterpolationSpec& spec, const std::string& path, Problems& problems) {
  if (spec.branches != engine::Branches::Hysteresis) return;
  constexpr double kNoticeableExcess = 0.05;  // [N]
  double most = 0.0;
  double where = 0.0;
  for (const auto& forces : engine::branchesAtKinks(spec)) {
    const double excess = forces.opening - forces.closing;
    if (excess > most) {
      most = excess;
      where = forces.travel;
    }
  }
  if (most < kNoticeableExcess) return;
  const auto shown = [](double value) { return std::to_string(value).substr(0, 5); };
  problems.warn(
      path + ".parameters",
      message("opening_gives_more", shown(most), shown(where)),
      message("opening_gives_more.fix"));
}

/// Warns if the force of a cut exceeds the protocol's limit for the device, because the excess is
/// felt as a plateau.
void adviseOnLimit(
    const engine::InterpolationSpec& spec,
    const DeviceRequirement& device,
    const std::string& path,
    Problems& problems) {
  double most = 0.0;
  double from = std::numeric_limits<double>::infinity();
  double to = -from;
  for (const auto& node : spec.curve) {
    most = std::max(most, node.force);
    if (node.force <= device.maxForce) continue;
    from = std::min(from, node.travel);
    to = std::max(to, node.travel);
  }
  if (most <= device.maxForce) return;
  using questionnaires::shown;
  const auto tenths = [](double value) { return shown(std::round(value * 10.0) / 10.0); };
  problems.warn(
      path + ".parameters",
      message("cut_beyond_limit", tenths(most), shown(device.maxForce), tenths(from), tenths(to)),
      message("cut_beyond_limit.fix"));
}

/// Whether a block shows the tissue of @p condition.
bool isVisualised(const Protocol& protocol, const Condition& condition) {
  return std::ranges::any_of(protocol.phases, [&](const auto& phase) {
    return base::contains(phase.trials.conditions, condition.id) &&
           phase.trials.isVisualised.value_or(condition.isVisualised);
  });
}

/// Warns if conditions of a block, which are to be compared by touch, show different knees.
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
    if (condition.anatomy && !isVisualised(protocol, condition)) {
      problems.warn(path + ".anatomy", message("knee_never_seen"), message("knee_never_seen.fix"));
    }
    const auto parts = engine::partsOf(*condition.model);
    if (parts.filter != nullptr) adviseOnWeight(*parts.filter, path, problems);
    if (parts.cut != nullptr) adviseOnBranches(*parts.cut, path, problems);
    const auto* device = protocol.device(condition.device);
    const bool isFeltAsItIs = parts.cut != nullptr && parts.filter == nullptr;
    if (isFeltAsItIs && device != nullptr) adviseOnLimit(*parts.cut, *device, path, problems);
  }
  for (const auto& phase : protocol.phases) adviseOnAnatomy(protocol, phase.trials, problems);
}

// Warnings about questions that refer to something the study may not have: a benchmark, vibration,
// removal, forces of full size.
namespace {

using questionnaires::Item;
using questionnaires::shown;
using questionnaires::StudyFeature;

/// The items that one phase asks, and the place of the phase in the protocol.
struct AskedItems {
  std::string instrument;
  std::string path;
  std::vector<Item> items;
};

/// Whether the questionnaire @p asked contains @p item for @p condition.
bool isAskedAbout(
    const ConditionQuestionnaire& asked, const Item& item, const std::string& condition) {
  const auto set = asked.itemSetFor(condition);
  return set.empty() || item.set == set;
}

/// The items that a questionnaire asks about at least one condition of the block.
std::vector<Item> itemsAsked(
    const questionnaires::Instrument& instrument,
    const ConditionQuestionnaire& asked,
    const Block& block) {
  std::vector<Item> items;
  for (const auto& item : instrument.items) {
    const auto isAsked = [&](const auto& condition) {
      return isAskedAbout(asked, item, condition);
    };
    if (std::ranges::any_of(block.conditions, isAsked)) {
      items.push_back(item);
    }
  }
  return items;
}

std::vector<AskedItems> itemsAskedIn(const LoadedProtocol& loaded, std::size_t index) {
  const auto& phase = loaded.protocol.phases[index];
  const std::string path = "$.phases[" + std::to_string(index) + "]";
  std::vector<AskedItems> all;
  if (const auto* instrument = loaded.instrument(phase.instrument)) {
    all.push_back({instrument->id, path + ".instrument", instrument->items});
  }
  for (std::size_t i = 0; i < phase.trials.questionnaires.size(); ++i) {
    const auto& asked = phase.trials.questionnaires[i];
    const auto* instrument = loaded.instrument(asked.instrument);
    if (instrument == nullptr) continue;
    all.push_back(
        {instrument->id,
         path + ".questionnaires[" + std::to_string(i) + "].instrument",
         itemsAsked(*instrument, asked, phase.trials)});
  }
  return all;
}

/// The ids of the items in @p items that ask about a benchmark: "'1.1', '3.2'".
std::string benchmarkItemIds(const std::vector<Item>& items) {
  std::string names;
  for (const auto& item : items) {
    if (item.neededFeature != StudyFeature::Benchmark) continue;
    names += (names.empty() ? "'" : ", '") + shown(item.id) + "'";
  }
  return names;
}

/// A warning if the scene of @p condition does not render what @p item asks about; otherwise
/// std::nullopt.
std::optional<base::Message> messageIfNotRendered(const Condition& condition, const Item& item) {
  const auto parts = engine::partsOf(*condition.model);
  const double scale = parts.material != nullptr  ? parts.material->forceScale
                       : parts.packing != nullptr ? parts.packing->forceScale
                                                  : 1.0;
  const bool hasJitter = parts.material != nullptr && parts.material->jitter.rms > 0.0;
  const bool isRemoved = (parts.packing != nullptr && parts.packing->isRemoved) ||
                         (parts.material != nullptr && parts.material->isRemoved);
  if (item.neededFeature == StudyFeature::Vibration && !hasJitter) {
    return message("no_vibration", item.id, condition.id);
  }
  if (item.neededFeature == StudyFeature::Pace && !isRemoved) {
    return message("no_removal", item.id, condition.id);
  }
  if (item.neededFeature == StudyFeature::ForceSize && scale < 1.0) {
    return message("scaled_force", item.id, condition.id, std::lround(100.0 * scale));
  }
  return std::nullopt;
}

/// Warns of each item once, for the first condition that does not render what it asks about.
void adviseOnItem(
    const Protocol& protocol,
    const Block& block,
    const ConditionQuestionnaire& asked,
    const Item& item,
    const std::string& path,
    Problems& problems) {
  for (const auto& id : block.conditions) {
    if (!isAskedAbout(asked, item, id)) continue;
    const auto lack = messageIfNotRendered(*protocol.condition(id), item);
    if (!lack) continue;
    problems.warn(path, *lack, message("not_rendered.fix"));
    return;
  }
}

}  // namespace

void validateBenchmarks(const UnvalidatedProtocol& draft, Problems& problems) {
  if (!draft.hasAllPhases()) return;
  const auto& phases = draft.loaded.protocol.phases;
  for (std::size_t i = 0; i < phases.size(); ++i) {
    if (phases[i].type == PhaseType::Benchmark) return;
    for (const auto& asked : itemsAskedIn(draft.loaded, i)) {
      const auto names = benchmarkItemIds(asked.items);
      if (names.empty()) continue;
      problems.add(
          asked.path,
          "'" + shown(asked.instrument) + "' asks about a benchmark (" + names +
              "), and none has been cut before",
          "put a phase of type 'benchmark' before it, or ask what refers to none ('realism-cuts', "
          "'preference-cuts')");
    }
  }
}

void addReferentWarnings(const LoadedProtocol& loaded, Problems& problems) {
  const auto& protocol = loaded.protocol;
  for (std::size_t i = 0; i < protocol.phases.size(); ++i) {
    const auto& block = protocol.phases[i].trials;
    for (std::size_t q = 0; q < block.questionnaires.size(); ++q) {
      const std::string path =
          "$.phases[" + std::to_string(i) + "].questionnaires[" + std::to_string(q) + "]";
      const auto& asked = block.questionnaires[q];
      for (const auto& item : loaded.instrument(asked.instrument)->items) {
        adviseOnItem(protocol, block, asked, item, path, problems);
      }
    }
  }
}

}  // namespace protocols

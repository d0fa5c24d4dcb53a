#include "protocols/model/protocol.h"

#include <algorithm>
#include <cmath>

#include "base/search.h"
#include "questionnaires/scoring/scoring.h"

namespace protocols {

std::vector<questionnaires::Item> comparedItems(
    const Family& family, const std::vector<questionnaires::Item>& items) {
  std::vector<questionnaires::Item> compared;
  if (!family.score.empty()) return compared;
  for (const auto& item : items) {
    const bool isCompared = family.items.empty() ? item.type == questionnaires::ItemType::Likert
                                                 : base::contains(family.items, item.id);
    if (isCompared) compared.push_back(item);
  }
  return compared;
}

bool Family::usesBlock(std::string_view block) const {
  return blocks.empty() || base::contains(blocks, block);
}

std::optional<ComparedScale> scaleOf(const questionnaires::Item& item) {
  const auto range = questionnaires::rangeOf(item);
  if (!range) return std::nullopt;
  if (answerKindOf(item.type) == questionnaires::AnswerKind::Point) {
    return ComparedScale{range->low, range->high, true};
  }
  // The largest magnitude of a point in a table of answers.
  constexpr double kLargestPoint = 1e6;
  const auto isWhole = [](double value) {
    return value == std::round(value) && std::abs(value) <= kLargestPoint;
  };
  const bool isCounted = isWhole(range->low) && isWhole(range->high) && isWhole(item.step) &&
                         item.step > 0.0 && range->high - range->low < kMostComparedPoints;
  return ComparedScale{range->low, range->high, isCounted};
}

std::optional<ComparedScale> scaleOf(
    const Family& family, const questionnaires::Instrument& instrument) {
  if (!family.score.empty()) {
    const auto* score = instrument.score(family.score);
    // a protocol that an earlier release accepted may lack the score
    if (score == nullptr) return std::nullopt;
    const auto range = questionnaires::rangeOf(instrument, *score);
    return ComparedScale{range.low, range.high, false};
  }
  for (const auto& item : comparedItems(family, instrument.items)) {
    if (const auto scale = scaleOf(item)) return scale;
  }
  return std::nullopt;
}

std::string ConditionQuestionnaire::itemSetFor(std::string_view condition) const {
  for (const auto& [name, set] : setByCondition) {
    if (name == condition) return set;
  }
  return {};
}

double SimulatedAnswerModel::realismOf(std::string_view condition) const {
  for (const auto& [name, realism] : realismByCondition) {
    if (name == condition) return realism;
  }
  return 0.0;
}

const Condition* Protocol::condition(std::string_view id) const noexcept {
  return base::withId(conditions, id);
}
const DeviceRequirement* Protocol::device(std::string_view id) const noexcept {
  return base::withId(devices, id);
}
const haptics::devices::DeviceKind* Protocol::onlyDeviceKind() const noexcept {
  const bool isOne = !devices.empty() && std::ranges::all_of(devices, [&](const auto& need) {
    return need.kind == devices.front().kind;
  });
  return isOne ? devices.front().kind : nullptr;
}
const Phase* Protocol::phase(std::string_view id) const noexcept {
  return base::withId(phases, id);
}
const Cohort* Protocol::cohort(std::string_view id) const noexcept {
  return base::withId(cohorts, id);
}

std::vector<InstrumentUse> instrumentUses(const Protocol& protocol) {
  std::vector<InstrumentUse> uses;
  for (std::size_t i = 0; i < protocol.phases.size(); ++i) {
    const auto& phase = protocol.phases[i];
    const std::string path = "$.phases[" + std::to_string(i) + "]";
    if (!phase.instrument.empty()) {
      uses.push_back({phase.instrument, path + ".instrument", phase.type});
    }
    for (std::size_t j = 0; j < phase.trials.questionnaires.size(); ++j) {
      const auto& asked = phase.trials.questionnaires[j];
      if (asked.instrument.empty()) continue;
      uses.push_back(
          {asked.instrument,
           path + ".questionnaires[" + std::to_string(j) + "].instrument",
           phase.type});
    }
  }
  return uses;
}

}  // namespace protocols

#include "protocols/model/protocol.h"

#include <algorithm>

namespace protocols {
namespace {

template <typename T>
const T* withId(const std::vector<T>& all, std::string_view id) noexcept {
  const auto found = std::find_if(all.begin(), all.end(), [&](const T& t) { return t.id == id; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace

std::string ConditionQuestionnaire::setFor(std::string_view condition) const {
  for (const auto& [name, set] : setByCondition) {
    if (name == condition) return set;
  }
  return {};
}

double SimulationTruth::realismOf(std::string_view condition) const {
  for (const auto& [name, realism] : realismByCondition) {
    if (name == condition) return realism;
  }
  return 0.0;
}

const Condition* Protocol::condition(std::string_view id) const noexcept {
  return withId(conditions, id);
}
const DeviceNeed* Protocol::device(std::string_view id) const noexcept {
  return withId(devices, id);
}
const haptics::devices::DeviceKind* Protocol::onlyDeviceKind() const noexcept {
  const bool isOne =
      !devices.empty() && std::all_of(devices.begin(), devices.end(), [&](const auto& need) {
        return need.kind == devices.front().kind;
      });
  return isOne ? devices.front().kind : nullptr;
}
const Phase* Protocol::phase(std::string_view id) const noexcept {
  return withId(phases, id);
}
const Cohort* Protocol::cohort(std::string_view id) const noexcept {
  return withId(cohorts, id);
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

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

}  // namespace protocols

#include "protocols/reading/draft.h"

#include <algorithm>
#include <vector>

#include "questionnaires/json/document.h"

namespace protocols {
namespace {

using questionnaires::isSoundId;

/// A list is never empty where it could be read, and what could not be read in it has no sound id.
template <typename T>
bool isComplete(const std::vector<T>& all) noexcept {
  return !all.empty() &&
         std::all_of(all.begin(), all.end(), [](const T& t) { return isSoundId(t.id); });
}

}  // namespace

bool Draft::lacksDevice(std::string_view id) const noexcept {
  const auto& protocol = loaded.protocol;
  return isSoundId(id) && protocol.device(id) == nullptr && isComplete(protocol.devices);
}

bool Draft::lacksCondition(std::string_view id) const noexcept {
  const auto& protocol = loaded.protocol;
  return isSoundId(id) && protocol.condition(id) == nullptr && isComplete(protocol.conditions);
}

bool Draft::lacksInstrument(std::string_view id) const noexcept {
  return isSoundId(id) && loaded.instrument(id) == nullptr && hasAllInstruments;
}

bool Draft::hasAllPhases() const noexcept {
  return isComplete(loaded.protocol.phases);
}

}  // namespace protocols

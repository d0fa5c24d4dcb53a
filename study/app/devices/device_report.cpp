#include "study/app/devices/device_report.h"

#include <algorithm>

#include <fmt/format.h>

namespace study::app {

using haptics::devices::Finding;

std::vector<DeviceFindings> checkAll(
    HardwareDeviceSet& deviceSet, const protocols::Protocol* protocol, double seconds) {
  std::vector<DeviceFindings> found;
  for (const auto& entry : deviceSet.entries()) {
    found.push_back({entry.id, preflight(*deviceSet.find(entry.id), protocol, entry.id, seconds)});
  }
  if (protocol == nullptr) return found;
  for (const auto& need : protocol->devices) {
    if (deviceSet.find(need.id) != nullptr) continue;
    found.push_back({need.id, {missingDevice()}});
  }
  return found;
}

bool isFit(const std::vector<DeviceFindings>& found) noexcept {
  return std::ranges::all_of(found, [](const auto& device) {
    return std::ranges::none_of(
        device.results, [](const auto& result) { return result.finding == Finding::Fail; });
  });
}

std::string checksAsText(const std::vector<DeviceFindings>& found) {
  std::string text;
  for (const auto& device : found) {
    text += device.device + "\n";
    for (const auto& result : device.results) {
      text += fmt::format(
          "  {}  {}: {}\n",
          haptics::devices::nameOf(result.finding),
          base::describe(result.what),
          base::describe(result.measured));
      if (!result.fix.empty()) text += "        → " + base::describe(result.fix) + "\n";
    }
  }
  return text;
}

}  // namespace study::app

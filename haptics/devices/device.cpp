#include "haptics/devices/device.h"

namespace haptics::devices {

const char* nameOf(Lifecycle state) noexcept {
  switch (state) {
    case Lifecycle::Closed:
      return "closed";
    case Lifecycle::Open:
      return "open";
    case Lifecycle::Checked:
      return "checked";
    case Lifecycle::Armed:
      return "armed";
    case Lifecycle::Running:
      return "running";
    case Lifecycle::Faulted:
      return "faulted";
  }
  return "";
}

const char* nameOf(Finding finding) noexcept {
  switch (finding) {
    case Finding::Pass:
      return "PASS";
    case Finding::Warn:
      return "WARN";
    case Finding::Fail:
      return "FAIL";
  }
  return "";
}

std::vector<CheckResult> Device::check(double) {
  return {{Finding::Pass, "simulated device", "nothing to connect", ""}};
}

}  // namespace haptics::devices

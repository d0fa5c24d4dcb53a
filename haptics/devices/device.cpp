#include "haptics/devices/device.h"

namespace haptics::devices {

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

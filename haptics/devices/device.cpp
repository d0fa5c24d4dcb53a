#include "haptics/devices/device.h"

#include <utility>

#include "haptics/devices/messages.h"

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

CheckResult passIf(
    bool isGood, Finding otherwise, base::Message what, base::Message measured, base::Message fix) {
  return {
      isGood ? Finding::Pass : otherwise,
      std::move(what),
      std::move(measured),
      isGood ? base::Message() : std::move(fix)};
}

std::vector<CheckResult> Device::check(double) {
  return {
      {Finding::Pass, deviceMessage("check.simulated"), deviceMessage("check.simulated.nothing")}};
}

}  // namespace haptics::devices

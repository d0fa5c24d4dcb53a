#pragma once

#include <string>
#include <vector>

#include "study/trial/hardware_device_set.h"

namespace study::app {

/// What was found of one device.
struct DeviceFindings {
  std::string device;
  std::vector<haptics::devices::CheckResult> results;
};

/// Checks all devices of @p deviceSet, @p seconds each; those that @p needs names also against
/// them. A device that is needed and not there is a finding.
std::vector<DeviceFindings> checkAll(
    HardwareDeviceSet& deviceSet, const std::vector<protocols::DeviceNeed>& needs, double seconds);

/// No FAIL among them.
bool isFit(const std::vector<DeviceFindings>& found) noexcept;

std::string checksAsText(const std::vector<DeviceFindings>& found);

}  // namespace study::app

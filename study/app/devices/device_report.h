#pragma once

#include <string>
#include <vector>

#include "study/trial/hardware_device_set.h"

namespace study::app {

/// The results of checking one device.
struct DeviceFindings {
  std::string device;
  std::vector<haptics::devices::CheckResult> results;
};

/// Checks every device of @p deviceSet for @p seconds, and compares the devices in @p needs with
/// the protocol's requirements. A missing device is a finding.
std::vector<DeviceFindings> checkAll(
    HardwareDeviceSet& deviceSet,
    const std::vector<protocols::DeviceRequirement>& needs,
    double seconds);

/// Whether there is no finding FAIL.
bool isFit(const std::vector<DeviceFindings>& found) noexcept;

std::string checksAsText(const std::vector<DeviceFindings>& found);

}  // namespace study::app

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

/// Checks every device of @p deviceSet for @p seconds, and compares it with what a @p protocol
/// needs, unless that is nullptr. A missing device is a finding.
std::vector<DeviceFindings> checkAll(
    HardwareDeviceSet& deviceSet, const protocols::Protocol* protocol, double seconds);

/// Whether there is no finding FAIL.
bool isFit(const std::vector<DeviceFindings>& found) noexcept;

std::string checksAsText(const std::vector<DeviceFindings>& found);

}  // namespace study::app

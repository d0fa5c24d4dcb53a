#pragma once

#include <string_view>
#include <vector>

#include "haptics/devices/device_kind.h"

namespace haptics {

/// Every kind of device that there is. Each has a folder of its own below haptics/devices.
const std::vector<const devices::DeviceKind*>& deviceKinds();

/// The entry of that name; nullptr if no entry has it.
const devices::DeviceKind* deviceKindNamed(std::string_view name);

}  // namespace haptics

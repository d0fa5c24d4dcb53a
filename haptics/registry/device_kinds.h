#pragma once

#include <string_view>
#include <vector>

#include "haptics/devices/device_kind.h"

namespace haptics {

/// All kinds of devices. Each has its own folder below haptics/devices.
const std::vector<const devices::DeviceKind*>& deviceKinds();

/// The kind of that name; nullptr if there is none.
const devices::DeviceKind* deviceKindNamed(std::string_view name);

}  // namespace haptics

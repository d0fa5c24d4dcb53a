#pragma once

#include "haptics/devices/device_kind.h"

namespace haptics::devices {

/// An acetabular reamer on an arm (KUKA LBR iiwa), moved along one axis; travel in metres.
const DeviceKind& reamerKind();

}  // namespace haptics::devices

#pragma once

#include "haptics/devices/device_kind.h"

namespace haptics::devices {

/// The kind of an acetabular reamer on an arm (KUKA LBR iiwa) that moves along one axis; travel in
/// metres.
const DeviceKind& reamerKind();

}  // namespace haptics::devices

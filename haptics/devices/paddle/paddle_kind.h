#pragma once

#include "haptics/devices/device_kind.h"

namespace haptics::devices {

/// The kind of a paddle on a sector pulley with one degree of freedom, like the Hapkit's: a finger
/// presses it from 0 to 30 degrees. It uses the punch's protocol (docs/punch-protocol.md) and has
/// no picture.
const DeviceKind& paddleKind();

}  // namespace haptics::devices

#pragma once

#include "haptics/devices/device_kind.h"

namespace haptics::devices {

/// A paddle on a sector pulley with one degree of freedom, as the Hapkit has it: a finger presses
/// it from 0 to 30 degrees. It uses the punch's protocol (docs/punch-protocol.md), and nothing is
/// seen while it is felt.
const DeviceKind& paddleKind();

}  // namespace haptics::devices

#pragma once

#include "haptics/devices/device_kind.h"

namespace haptics::devices {

/// The arthroscopic punch of the punch paper: one degree of freedom; travel in the units of its
/// handle, 0 open, 10 closed, which no paper gives a length.
const DeviceKind& punchKind();

}  // namespace haptics::devices

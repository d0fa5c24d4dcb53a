#pragma once

#include <cstdint>

#include "haptics/devices/device_kind.h"

namespace haptics::devices {

/// The kind of the arthroscopic punch of the punch paper: one degree of freedom; travel in units of
/// its handle, 0 open, 10 closed. No paper says how long a unit is.
const DeviceKind& punchKind();

/// Identifies the firmware that belongs to this program: the first eight bytes of the SHA-256 of
/// its sources.
extern const std::uint64_t kFirmwareBuild;

}  // namespace haptics::devices

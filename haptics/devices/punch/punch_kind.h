#pragma once

#include <cstdint>

#include "haptics/devices/device_kind.h"

namespace haptics::devices {

/// The arthroscopic punch of the punch paper: one degree of freedom; travel in the units of its
/// handle, 0 open, 10 closed, which no paper gives a length.
const DeviceKind& punchKind();

/// Which firmware this program was built with: the first eight bytes of the SHA-256 of its sources.
extern const std::uint64_t kFirmwareBuild;

}  // namespace haptics::devices

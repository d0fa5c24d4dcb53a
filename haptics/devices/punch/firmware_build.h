#pragma once

#include <cstdint>

namespace haptics::devices {

/// Which firmware this program was built with: the first eight bytes of the SHA-256 of its sources.
extern const std::uint64_t kFirmwareBuild;

}  // namespace haptics::devices

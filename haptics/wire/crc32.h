#pragma once

#include <stddef.h>
#include <stdint.h>

namespace haptics::wire {

namespace detail {
struct CrcTable {
  uint32_t entry[256] = {};
  constexpr CrcTable() noexcept {
    for (uint32_t byte = 0; byte < 256; ++byte) {
      uint32_t crc = byte;
      for (int bit = 0; bit < 8; ++bit)
        crc = (crc & 1U) != 0 ? (crc >> 1U) ^ 0xEDB88320U : crc >> 1U;
      entry[byte] = crc;
    }
  }
};
inline constexpr CrcTable kCrcTable;
}  // namespace detail

/// CRC-32 of @p count bytes as in zlib and IEEE 802.3: reflected polynomial 0xEDB88320, initial
/// value and final XOR 0xFFFFFFFF; the CRC of "123456789" is 0xCBF43926. @p before is the CRC of
/// the preceding bytes, 0 if there are none.
constexpr uint32_t crc32(const uint8_t* bytes, size_t count, uint32_t before = 0) noexcept {
  uint32_t crc = ~before;
  for (size_t i = 0; i < count; ++i) {
    crc = (crc >> 8U) ^ detail::kCrcTable.entry[(crc ^ bytes[i]) & 0xFFU];
  }
  return ~crc;
}

}  // namespace haptics::wire

#pragma once

#include <stddef.h>
#include <stdint.h>

namespace haptics::wire {

/// What COBS (Cheshire and Baker 1999) makes of @p count bytes at the most, without the zero that
/// ends a frame.
constexpr size_t largestCobs(size_t count) noexcept {
  return count + count / 254 + 1;
}

/// Consistent overhead byte stuffing: the same bytes without a zero among them. @p out has room for
/// largestCobs(count). How many were written.
constexpr size_t cobsEncode(const uint8_t* bytes, size_t count, uint8_t* out) noexcept {
  size_t written = 1;
  size_t code = 0;  // where the length of the present run goes
  uint8_t run = 1;
  for (size_t i = 0; i < count; ++i) {
    if (bytes[i] != 0) {
      out[written++] = bytes[i];
      ++run;
    }
    const bool isFull = run == 0xFF;
    if (bytes[i] == 0 || (isFull && i + 1 < count)) {
      out[code] = run;
      code = written++;
      run = 1;
    }
  }
  out[code] = run;
  return written;
}

/// Decodes the output of cobsEncode(). @p out has room for @p count bytes, and may be the input
/// itself. Returns the number of bytes; 0 if a run is longer than the input, or if it contains a
/// zero.
constexpr size_t cobsDecode(const uint8_t* bytes, size_t count, uint8_t* out) noexcept {
  size_t read = 0;
  size_t written = 0;
  while (read < count) {
    const uint8_t run = bytes[read++];
    if (run == 0 || read + run - 1 > count) return 0;
    for (uint8_t i = 1; i < run; ++i) {
      if (bytes[read] == 0) return 0;
      out[written++] = bytes[read++];
    }
    if (run != 0xFF && read < count) out[written++] = 0;
  }
  return written;
}

}  // namespace haptics::wire

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "haptics/wire/crc32.h"
#include "haptics/wire/fri_codec.h"

// Fuzzes the decoder: whatever comes, it answers; and what it takes can be written and read again.
// The first byte chooses the version, the message, and whether the rest is put into a sound frame.

namespace {

using namespace haptics::wire;
using namespace haptics::wire::fri;

void expect(bool isTrue) {
  if (!isTrue) std::abort();
}

template <typename Message>
void check(std::span<const std::uint8_t> datagram, Version version) {
  Message message;
  if (decode(datagram, version, message) != Refusal::None) {
    expect(message == Message{});
    return;
  }
  std::array<std::uint8_t, kLargestDatagram> once{};
  std::array<std::uint8_t, kLargestDatagram> twice{};
  const std::size_t size = encode(message, version, once);
  if (size == 0) {
    // Packed joints take up to 6 bytes less than the canonical ones, packed drive states 5.
    expect(datagram.size() + 60 > kLargestDatagram);
    return;
  }
  Message again;
  expect(decode({once.data(), size}, version, again) == Refusal::None);
  expect(encode(again, version, twice) == size && once == twice);
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t count) {
  if (count == 0) return 0;
  const auto version = static_cast<Version>(data[0] % kVersionNames.size());
  std::span<const std::uint8_t> datagram(data + 1, count - 1);
  std::array<std::uint8_t, kLargestDatagram> frame{};
  if ((data[0] & 0x80U) != 0 && version == Version::V2_7 && datagram.size() + 8 <= frame.size()) {
    const std::size_t size = datagram.size();
    std::copy(datagram.begin(), datagram.end(), frame.begin() + 4);
    const std::uint32_t crc = crc32(datagram.data(), size);
    for (unsigned i = 0; i < 4; ++i) {
      frame[i] = static_cast<std::uint8_t>(size >> (8 * i));
      frame[4 + size + i] = static_cast<std::uint8_t>(crc >> (8 * i));
    }
    datagram = {frame.data(), size + 8};
  }
  if ((data[0] & 0x40U) != 0) {
    check<CommandMessage>(datagram, version);
  } else {
    check<MonitoringMessage>(datagram, version);
  }
  return 0;
}

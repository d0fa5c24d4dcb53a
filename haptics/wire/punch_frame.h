#pragma once

#include <stddef.h>
#include <stdint.h>

#include "haptics/wire/crc32.h"
#include "haptics/wire/punch_messages.h"

namespace haptics::wire {

/// Largest size of @p count bytes after COBS (Cheshire and Baker 1999), without the zero that ends
/// a frame.
constexpr size_t largestCobsSize(size_t count) noexcept {
  return count + count / 254 + 1;
}

/// Consistent overhead byte stuffing: encodes @p bytes without zeros into @p out, which has space
/// for largestCobsSize(count) bytes. Returns the number of bytes written.
constexpr size_t cobsEncode(const uint8_t* bytes, size_t count, uint8_t* out) noexcept {
  size_t written = 1;
  size_t code = 0;  // position for the length of the present run
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

/// Decodes the output of cobsEncode(). @p out has space for @p count bytes, and may be the input
/// itself. Returns the number of bytes; 0 if a run exceeds the input, or the input contains a zero.
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

namespace haptics::wire::punch {

/// A decoded frame: type u8, sequence u16, sender's clock u32 [µs], payload, CRC-32 of all before;
/// little-endian throughout.
inline constexpr size_t kHeaderSize = 7;   ///< bytes before the payload
inline constexpr size_t kTrailerSize = 4;  ///< bytes after it: the CRC
inline constexpr size_t kLargestPayload = 2 + kTableChunk * 8;
inline constexpr size_t kLargestFrame = kHeaderSize + kLargestPayload + kTrailerSize;
/// Encoded, with the zero at its end.
inline constexpr size_t kLargestOnWire = largestCobsSize(kLargestFrame) + 1;

inline bool isFinite(float value) noexcept {
  return value - value == 0.0F;
}

/// Writes values in sequence, little-endian.
class Writer {
 public:
  explicit Writer(uint8_t* to) noexcept : to_(to) {}

  void operator()(const auto&... values) noexcept { (put(values), ...); }
  size_t size() const noexcept { return size_; }

 private:
  /// A whole number, a bool or an enumerator.
  template <typename T>
  void put(T value) noexcept {
    auto bits = static_cast<uint64_t>(value);
    for (size_t i = 0; i < sizeof value; ++i, bits >>= 8U)
      to_[size_++] = static_cast<uint8_t>(bits);
  }
  void put(float value) noexcept {
    uint32_t bits = 0;
    __builtin_memcpy(&bits, &value, sizeof bits);
    put(bits);
  }

  uint8_t* to_;
  size_t size_ = 0;
};

/// Reads values in sequence, little-endian; zeros beyond the end.
class Reader {
 public:
  Reader(const uint8_t* from, size_t count) noexcept : from_(from), count_(count) {}

  void operator()(auto&... values) noexcept { (get(values), ...); }
  /// Whether exactly all bytes were read, every bool was 0 or 1, and every float is finite.
  bool isSound() const noexcept { return isSound_ && at_ == count_; }

 private:
  uint64_t bits(size_t bytes) noexcept {
    uint64_t value = 0;
    for (size_t i = 0; i < bytes; ++i) {
      isSound_ = isSound_ && at_ < count_;
      if (at_ < count_) value |= static_cast<uint64_t>(from_[at_++]) << (8U * i);
    }
    return value;
  }

  /// A whole number or an enumerator.
  template <typename T>
  void get(T& value) noexcept {
    value = static_cast<T>(bits(sizeof value));
  }
  void get(bool& value) noexcept {
    const uint64_t read = bits(1);
    value = read == 1;
    isSound_ = isSound_ && read <= 1;
  }
  void get(float& value) noexcept {
    const auto read = static_cast<uint32_t>(bits(sizeof value));
    __builtin_memcpy(&value, &read, sizeof value);
    isSound_ = isSound_ && isFinite(value);
  }

  const uint8_t* from_;
  size_t count_;
  size_t at_ = 0;
  bool isSound_ = true;
};

/// A frame with a correct CRC; the payload points into the decoder's buffer.
struct Frame {
  Type type = Type::Stop;
  uint16_t sequence = 0;
  uint32_t time = 0;  ///< sender's clock [µs], wraps
  const uint8_t* payload = nullptr;
  size_t size = 0;
};

/// Encodes a frame, with the zero at its end, into @p wire, which has space for kLargestOnWire
/// bytes. Returns the number of bytes.
/// @param payload  up to kLargestPayload bytes.
inline size_t encodeFrame(
    Type type,
    uint16_t sequence,
    uint32_t time,
    const uint8_t* payload,
    size_t size,
    uint8_t* wire) noexcept {
  uint8_t plain[kLargestFrame];
  Writer writer(plain);
  writer(type, sequence, time);
  for (size_t i = 0; i < size; ++i) writer(payload[i]);
  writer(crc32(plain, writer.size()));
  const size_t stuffed = cobsEncode(plain, writer.size(), wire);
  wire[stuffed] = 0;
  return stuffed + 1;
}

/// Finds frames in a stream of bytes. Skips invalid ones up to the next zero, and counts them; does
/// not allocate.
class FrameDecoder {
 public:
  /// Returns true if @p byte ended a valid frame; @p frame is then valid until the next call.
  bool take(uint8_t byte, Frame& frame) noexcept {
    if (byte != 0) {
      if (count_ < sizeof bytes_) {
        bytes_[count_++] = byte;
      } else {
        isTooLong_ = true;
      }
      return false;
    }
    const size_t count = isTooLong_ ? 0 : cobsDecode(bytes_, count_, bytes_);
    const bool isEmpty = count_ == 0;  // an empty frame is ignored
    count_ = 0;
    isTooLong_ = false;
    if (isEmpty) return false;
    if (count >= kHeaderSize + kTrailerSize && hasValidCrc(count)) {
      Reader head(bytes_, kHeaderSize);
      head(frame.type, frame.sequence, frame.time);
      frame.payload = bytes_ + kHeaderSize;
      frame.size = count - kHeaderSize - kTrailerSize;
      return true;
    }
    ++damaged_;
    return false;
  }

  /// Number of invalid frames.
  uint32_t damaged() const noexcept { return damaged_; }

  /// Discards a partly received frame.
  void restart() noexcept {
    count_ = 0;
    isTooLong_ = false;
  }

 private:
  bool hasValidCrc(size_t count) const noexcept {
    uint32_t crc = 0;
    Reader(bytes_ + count - kTrailerSize, kTrailerSize)(crc);
    return crc == crc32(bytes_, count - kTrailerSize);
  }

  uint8_t bytes_[kLargestOnWire] = {};
  size_t count_ = 0;
  bool isTooLong_ = false;
  uint32_t damaged_ = 0;
};

}  // namespace haptics::wire::punch

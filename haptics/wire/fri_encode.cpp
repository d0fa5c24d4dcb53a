#include <algorithm>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstring>
#include <optional>

#include "haptics/wire/crc32.h"
#include "haptics/wire/fri_codec.h"
#include "haptics/wire/fri_fields.h"
#include "haptics/wire/protobuf_reader.h"

namespace haptics::wire::fri {
namespace {

/// Encodes fields into a buffer. After the first error it writes nothing more.
class Writer {
 public:
  Writer(std::span<std::uint8_t> out, Version version) noexcept : out_(out), version_(version) {}

  /// The number of bytes; 0 after an error.
  std::size_t size() const noexcept { return isSound_ ? size_ : 0; }

  template <typename T>
  void operator()(std::uint32_t number, const T& value, Versions versions) noexcept {
    if (isInVersions(version_, versions)) put(number, value);
  }

 private:
  template <typename T>
  void put(std::uint32_t number, const std::optional<T>& value) noexcept {
    if (value) put(number, *value);
  }

  void put(std::uint32_t number, Number auto value) noexcept {
    tag(number, Varint);
    putVarint(static_cast<std::uint64_t>(value));  // a negative int32 has ten bytes
  }

  void put(std::uint32_t number, double value) noexcept {
    tag(number, Fixed64);
    putFixed(value);
  }

  void put(std::uint32_t number, Choice auto value) noexcept {
    if (!isKnown(value)) return fail();
    if constexpr (std::same_as<decltype(value), ClientCommandMode>) {
      if (value == ClientCommandMode::CartesianPose && !isInVersions(version_, kSince2_5)) return;
    }
    put(number, static_cast<std::uint32_t>(value));
  }

  void put(std::uint32_t number, const Name& name) noexcept {
    if (name.size > name.bytes.size()) return fail();
    tag(number, Delimited);
    putVarint(name.size);
    for (const char c : name.text()) byte(static_cast<std::uint8_t>(c));
  }

  void put(std::uint32_t number, const Joints& joints) noexcept {
    putNested(number, [&] {
      for (const double joint : joints) put(1, joint);
    });
  }

  void put(std::uint32_t number, const Vector6& vector) noexcept {
    putNested(number, [&] { putPacked(1, vector); });
  }

  void put(std::uint32_t number, const BoundedArray<double, 12>& elements) noexcept {
    if (elements.count > mostElements(version_)) return fail();
    if (elements.count > 0) putPacked(number, {elements.begin(), elements.count});
  }

  template <typename T, std::size_t N>
  void put(std::uint32_t number, const BoundedArray<T, N>& list) noexcept {
    if (list.count > N) return fail();
    for (const T& item : list) put(number, item);
  }

  template <Message T>
  void put(std::uint32_t number, const T& message) noexcept {
    putNested(number, [&] { visit(message, *this); });
  }

  void putPacked(std::uint32_t number, std::span<const double> values) noexcept {
    tag(number, Delimited);
    putVarint(8 * values.size());
    for (const double value : values) putFixed(value);
  }

  /// Writes the content of a nested message after one byte for its length. If the length needs two
  /// bytes, moves the content by one byte.
  void putNested(std::uint32_t number, const auto& writeInside) noexcept {
    tag(number, Delimited);
    byte(0);
    const std::size_t begin = size_;
    writeInside();
    if (!isSound_) return;
    const std::size_t inside = size_ - begin;
    if (inside >= 0x80) {
      byte(0);
      if (!isSound_) return;
      std::memmove(&out_[begin + 1], &out_[begin], inside);
    }
    const std::size_t end = size_;
    size_ = begin - 1;
    putVarint(inside);  // below 2^14, as no datagram has that many bytes
    size_ = end;
  }

  void tag(std::uint32_t number, Wire wire) noexcept { putVarint(number << 3U | wire); }

  void putVarint(std::uint64_t value) noexcept {
    for (; value >= 0x80; value >>= 7U) byte(static_cast<std::uint8_t>(value | 0x80U));
    byte(static_cast<std::uint8_t>(value));
  }

  void putFixed(double value) noexcept {
    if (!std::isfinite(value)) return fail();
    const auto bits = std::bit_cast<std::uint64_t>(value);
    for (unsigned shift = 0; shift < 64; shift += 8) byte(static_cast<std::uint8_t>(bits >> shift));
  }

  void byte(std::uint8_t value) noexcept {
    if (size_ >= out_.size()) return fail();
    out_[size_++] = value;
  }

  void fail() noexcept { isSound_ = false; }

  std::span<std::uint8_t> out_;
  Version version_;
  std::size_t size_ = 0;
  bool isSound_ = true;
};

void putWord(std::uint8_t* bytes, std::uint32_t word) noexcept {
  for (unsigned i = 0; i < 4; ++i) bytes[i] = static_cast<std::uint8_t>(word >> (8 * i));
}

template <typename T>
std::size_t encodeAny(const T& message, Version version, std::span<std::uint8_t> out) noexcept {
  out = out.first(std::min(out.size(), kLargestDatagram));
  const bool isFramed = isInVersions(version, kSince2_7);
  const std::size_t frame = isFramed ? kFrameSize : 0;
  if (out.size() < frame) return 0;
  const std::size_t begin = frame / 2;
  Writer writer(out.subspan(begin, out.size() - frame), version);
  visit(message, writer);
  const std::size_t size = writer.size();  // never 0 for a message: the header is required
  if (size == 0 || !isFramed) return size;
  std::uint8_t* const bytes = out.data() + begin;
  putWord(out.data(), static_cast<std::uint32_t>(size));
  putWord(bytes + size, crc32(bytes, size));
  return size + frame;
}

}  // namespace

std::size_t encode(
    const MonitoringMessage& message, Version version, std::span<std::uint8_t> out) noexcept {
  return encodeAny(message, version, out);
}

std::size_t encode(
    const CommandMessage& message, Version version, std::span<std::uint8_t> out) noexcept {
  return encodeAny(message, version, out);
}

}  // namespace haptics::wire::fri

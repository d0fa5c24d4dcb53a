#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

/// Reads the protobuf wire format without heap, exceptions or recursion that a sender controls.
namespace haptics::wire::fri {

inline constexpr std::size_t kDeepest = 100;    ///< levels of nesting that protobuf allows
inline constexpr std::size_t kShortVarint = 5;  ///< longest varint of 32 bits [bytes]
inline constexpr std::size_t kLongVarint = 10;  ///< longest varint of 64 bits [bytes]

/// Wire types: how a field's content is encoded.
enum Wire : std::uint32_t {
  Varint = 0,
  Fixed64 = 1,
  Delimited = 2,
  Group = 3,
  EndOfGroup = 4,
  Fixed32 = 5
};

/// The tag before every field: its number and wire type.
struct Tag {
  std::uint32_t number = 0;
  std::uint32_t wire = 0;
};

/// Reads the fields of one message. After the first error it has no more fields, and all reads
/// return 0.
class Reader {
 public:
  explicit Reader(std::span<const std::uint8_t> bytes, std::size_t depth = kDeepest) noexcept
      : rest_(bytes), depth_(depth) {}

  bool isSound() const noexcept { return isSound_; }
  bool hasMore() const noexcept { return isSound_ && !rest_.empty(); }
  void fail() noexcept { isSound_ = false; }

  /// Bits beyond 64 are discarded, as in protobuf.
  std::uint64_t varint(std::size_t longest = kLongVarint) noexcept {
    std::uint64_t value = 0;
    const std::size_t most = std::min(longest, rest_.size());
    for (std::size_t i = 0; i < most; ++i) {
      value |= std::uint64_t{rest_[i] & 0x7FU} << (7 * i);
      if ((rest_[i] & 0x80U) == 0) {
        rest_ = rest_.subspan(i + 1);
        return value;
      }
    }
    fail();
    return 0;
  }

  double number() noexcept {
    const std::span<const std::uint8_t> bytes = take(8);
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i) bits |= std::uint64_t{bytes[i]} << (8 * i);
    return std::bit_cast<double>(bits);
  }

  std::span<const std::uint8_t> delimited() noexcept { return take(varint(kShortVarint)); }

  /// Returns a reader of the nested message that follows.
  Reader nested() noexcept {
    if (depth_ == 0) fail();
    return Reader(delimited(), depth_ - (depth_ == 0 ? 0 : 1));
  }

  Tag tag() noexcept {
    const auto both = static_cast<std::uint32_t>(varint(kShortVarint));
    if (both >> 3U == 0) fail();
    return {both >> 3U, both & 7U};
  }

  /// Skips an unknown field, including nested groups.
  void skip(Tag tag) noexcept {
    std::array<std::uint32_t, kDeepest> open{};
    std::size_t count = 0;
    while (isSound_) {
      if (tag.wire == Group) {
        if (count >= depth_) return fail();
        open[count++] = tag.number;
      } else if (tag.wire == EndOfGroup) {
        if (count == 0 || open[--count] != tag.number) return fail();
      } else {
        skipPlain(tag.wire);
      }
      if (count == 0) return;
      tag = this->tag();
    }
  }

 private:
  std::span<const std::uint8_t> take(std::uint64_t count) noexcept {
    if (!isSound_ || count > rest_.size()) {
      fail();
      return {};
    }
    const auto size = static_cast<std::size_t>(count);
    const std::span<const std::uint8_t> taken = rest_.first(size);
    rest_ = rest_.subspan(size);
    return taken;
  }

  void skipPlain(std::uint32_t wire) noexcept {
    if (wire == Varint) {
      varint();
    } else if (wire == Fixed64) {
      take(8);
    } else if (wire == Delimited) {
      delimited();
    } else if (wire == Fixed32) {
      take(4);
    } else {
      fail();
    }
  }

  std::span<const std::uint8_t> rest_;
  std::size_t depth_;  // levels of nesting that are still allowed
  bool isSound_ = true;
};

}  // namespace haptics::wire::fri

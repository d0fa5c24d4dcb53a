#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace study::storage {

/// A key of one participant: 256 random bits (docs/decisions/0040). Once it is destroyed, nobody
/// reads what was sealed with it, in whatever copy that may be.
///
/// Sealing and hashing use two keys that are derived from it (crypto_kdf of libsodium).
class SealingKey {
 public:
  using Bytes = std::array<unsigned char, 32>;

  explicit SealingKey(const Bytes& bytes) noexcept : bytes_(bytes) {}

  /// From the operating system's random numbers.
  static SealingKey drawn();

  const Bytes& bytes() const noexcept { return bytes_; }

  /// XChaCha20-Poly1305: 24 random bytes, then the sealed text and 16 bytes that prove it.
  /// @param place  where it will stand ("17/answered"): sealed text that was moved is not opened.
  std::vector<std::byte> seal(std::string_view text, std::string_view place) const;

  /// The same bytes for the same text in the same place, for what is stored once there: 24 bytes of
  /// a keyed hash stand for the random ones.
  std::vector<std::byte> sealRepeatably(std::string_view text, std::string_view place) const;

  /// std::nullopt if it was sealed with another key or for another place, or was changed.
  std::optional<std::string> open(std::span<const std::byte> sealed, std::string_view place) const;

  /// A key that only who has both can make.
  SealingKey joinedWith(const SealingKey& other) const;

  /// For hashes that tell nothing to anyone without this key.
  Bytes hashingKey() const;

 private:
  Bytes derived(unsigned purpose) const;
  std::vector<std::byte> sealed(
      std::string_view text,
      std::string_view place,
      const std::function<void(unsigned char*)>& writeNonce) const;

  Bytes bytes_;
};

}  // namespace study::storage

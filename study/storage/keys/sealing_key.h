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

/// A key of one participant: 256 random bits (docs/decisions/0040). Once it is destroyed, nothing
/// that was sealed with it can be read, in any copy.
///
/// Sealing and hashing use two keys that are derived from it (crypto_kdf of libsodium).
class SealingKey {
 public:
  using Bytes = std::array<unsigned char, 32>;

  explicit SealingKey(const Bytes& bytes) noexcept : bytes_(bytes) {}

  /// From the operating system's random numbers.
  static SealingKey drawn();

  const Bytes& bytes() const noexcept { return bytes_; }

  /// XChaCha20-Poly1305: a random nonce of 24 bytes, the ciphertext, and a tag of 16 bytes.
  /// @param place  associated data: where the result is stored ("17/answered"). Sealed text that
  ///     was moved elsewhere cannot be opened.
  std::vector<std::byte> seal(std::string_view text, std::string_view place) const;

  /// Like seal(), but deterministic: the nonce is a keyed hash of text and place. For places to
  /// which only one text is written.
  std::vector<std::byte> sealDeterministically(std::string_view text, std::string_view place) const;

  /// std::nullopt if it was sealed with another key or for another place, or was changed.
  std::optional<std::string> open(std::span<const std::byte> sealed, std::string_view place) const;

  /// A key derived from both keys; it cannot be computed from one of them.
  SealingKey joinedWith(const SealingKey& other) const;

  /// The derived key for keyed hashes, which reveal nothing without it.
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

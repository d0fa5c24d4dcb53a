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

/// A symmetric key of 256 random bits, for example of one participant (docs/decisions/0040). After
/// it is destroyed, data that were sealed with it cannot be read in any copy.
///
/// Sealing and hashing use two different keys that are derived from this one (crypto_kdf of
/// libsodium).
class SealingKey {
 public:
  using Bytes = std::array<unsigned char, 32>;

  explicit SealingKey(const Bytes& bytes) noexcept : bytes_(bytes) {}

  /// Drawn from the random number generator of the operating system.
  static SealingKey drawn();

  const Bytes& bytes() const noexcept { return bytes_; }

  /// Encrypts with XChaCha20-Poly1305. @return  a random nonce of 24 bytes, the ciphertext, and a
  /// tag of 16 bytes.
  /// @param place  associated data: where the result is stored ("17/answered"). The result cannot
  ///     be opened if it was moved to another place.
  std::vector<std::byte> seal(std::string_view text, std::string_view place) const;

  /// Like seal(), but deterministic: the nonce is a keyed hash of text and place. Only for places
  /// to which one text is ever written.
  std::vector<std::byte> sealDeterministically(std::string_view text, std::string_view place) const;

  /// std::nullopt if the text was sealed with another key or for another place, or was changed.
  std::optional<std::string> open(std::span<const std::byte> sealed, std::string_view place) const;

  /// A key derived from both keys, which cannot be computed from one of them alone.
  SealingKey joinedWith(const SealingKey& other) const;

  /// The derived key for keyed hashes.
  Bytes hashingKey() const;

 private:
  /// The key for a purpose, derived from this one.
  Bytes derived(unsigned purpose) const;
  /// Seals with the nonce that @p writeNonce writes.
  std::vector<std::byte> sealed(
      std::string_view text,
      std::string_view place,
      const std::function<void(unsigned char*)>& writeNonce) const;

  Bytes bytes_;
};

}  // namespace study::storage

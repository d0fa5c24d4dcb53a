#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "study/storage/keys/sealing_key.h"

namespace study::storage {

/// The cost of trying one passphrase (Argon2id of libsodium).
struct PassphraseCost {
  std::uint64_t operations = 3;
  std::uint64_t memory = 256ULL * 1024 * 1024;  ///< [bytes]

  /// For tests only: too cheap to protect a key.
  static constexpr PassphraseCost least() { return {.operations = 1, .memory = 8192}; }
};

/// A key, sealed with another key that is derived from a passphrase. The sealed key may be public
/// as long as the passphrase cannot be guessed.
struct WrappedKey {
  static constexpr std::size_t kSaltBytes = 16;

  std::array<unsigned char, kSaltBytes> salt{};
  PassphraseCost cost;
  std::vector<std::byte> sealed;

  /// @throws std::invalid_argument  if the passphrase is empty
  /// @throws StorageError  if the memory of @p cost is not available
  static WrappedKey make(
      const SealingKey::Bytes& key, std::string_view passphrase, const PassphraseCost& cost);

  /// The key; std::nullopt if the passphrase is wrong, or if the sealed key was changed.
  /// @throws StorageError  (Damaged) if the stored cost is outside of the limits of this program;
  ///     also if the memory that it needs is not available.
  std::optional<SealingKey::Bytes> opened(std::string_view passphrase) const;
};

}  // namespace study::storage

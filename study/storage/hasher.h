#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace study::storage {

/// A BLAKE2b-256 hash.
using Hash = std::array<std::byte, 32>;

/// BLAKE2b-256 of several fields, each preceded by its length, so that different lists of fields
/// have different input.
class Hasher {
 public:
  void add(std::string_view field);
  void add(const std::optional<std::int64_t>& number);
  void add(std::span<const std::byte> bytes);

  Hash finish() const;

  /// A keyed hash: without the key, the fields cannot be found by guessing.
  Hash finish(std::span<const unsigned char> key) const;

 private:
  std::string fields_;
};

/// BLAKE2b-256 of the bytes, without a length.
Hash hashOf(std::span<const std::byte> bytes);

/// The bytes of a hash in the type of a BLOB column.
std::vector<std::byte> asBytes(const Hash& hash);

/// The bytes of a key or secret from a BLOB column; std::nullopt unless there are exactly as many.
template <typename Bytes>
std::optional<Bytes> fixedBytes(std::span<const std::byte> stored) {
  Bytes bytes{};
  if (stored.size() != bytes.size()) return std::nullopt;
  std::transform(stored.begin(), stored.end(), bytes.begin(), std::to_integer<unsigned char>);
  return bytes;
}

/// Two digits for each byte, in lower case.
std::string inHexadecimal(std::span<const unsigned char> bytes);
std::string inHexadecimal(std::span<const std::byte> bytes);

/// Reads two digits for each of @p bytes. @return  false unless @p text has exactly these digits
bool readHexadecimal(std::string_view text, std::span<unsigned char> bytes);

/// An array of unsigned char; std::nullopt unless @p text has exactly its digits.
template <typename Bytes>
std::optional<Bytes> fromHexadecimal(std::string_view text) {
  Bytes bytes{};
  return readHexadecimal(text, bytes) ? std::optional(bytes) : std::nullopt;
}

/// Base64 (RFC 4648, with padding), for files and events that can hold text only.
std::string inBase64(std::span<const std::byte> bytes);

/// std::nullopt if @p text is not complete, valid Base64.
std::optional<std::vector<std::byte>> fromBase64(std::string_view text);

}  // namespace study::storage

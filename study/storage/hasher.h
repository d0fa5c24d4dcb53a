#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace study::storage {

using Hash = std::array<std::byte, 32>;

/// BLAKE2b-256 of some fields, each with its length before it, so that no two lists look alike.
class Hasher {
 public:
  void add(std::string_view field);
  void add(const std::optional<std::int64_t>& number);
  void add(std::span<const std::byte> bytes);

  Hash finish() const;

 private:
  std::string fields_;
};

/// BLAKE2b-256 of bytes as they are.
Hash hashOf(std::span<const std::byte> bytes);

/// As a value that goes into a column, and compares with what comes out of one.
std::vector<std::byte> asBytes(const Hash& hash);

std::string inHexadecimal(const Hash& hash);

}  // namespace study::storage

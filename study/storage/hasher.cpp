#include "study/storage/hasher.h"

#include <sodium.h>

namespace study::storage {
namespace {

constexpr int kBase64 = sodium_base64_VARIANT_ORIGINAL;

Hash hashWith(std::span<const unsigned char> key, std::span<const std::byte> bytes) {
  Hash hash{};
  crypto_generichash(
      reinterpret_cast<unsigned char*>(hash.data()),
      hash.size(),
      reinterpret_cast<const unsigned char*>(bytes.data()),
      bytes.size(),
      key.data(),
      key.size());
  return hash;
}

}  // namespace

void Hasher::add(std::string_view field) {
  fields_.append(std::to_string(field.size())).append(1, ':').append(field);
}

void Hasher::add(const std::optional<std::int64_t>& number) {
  add(number ? std::string_view(std::to_string(*number)) : std::string_view("-"));
}

void Hasher::add(std::span<const std::byte> bytes) {
  add(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

Hash Hasher::finish() const {
  return hashOf(std::as_bytes(std::span(fields_)));
}

Hash Hasher::finish(std::span<const unsigned char> key) const {
  return hashWith(key, std::as_bytes(std::span(fields_)));
}

Hash hashOf(std::span<const std::byte> bytes) {
  return hashWith({}, bytes);
}

std::vector<std::byte> asBytes(const Hash& hash) {
  return {hash.begin(), hash.end()};
}

std::string inHexadecimal(std::span<const unsigned char> bytes) {
  std::string text(2 * bytes.size() + 1, '\0');
  sodium_bin2hex(text.data(), text.size(), bytes.data(), bytes.size());
  text.pop_back();  // the terminating zero
  return text;
}

std::string inHexadecimal(std::span<const std::byte> bytes) {
  return inHexadecimal({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()});
}

bool readHexadecimal(std::string_view text, std::span<unsigned char> bytes) {
  std::size_t size = 0;
  const int code =
      sodium_hex2bin(bytes.data(), bytes.size(), text.data(), text.size(), nullptr, &size, nullptr);
  return code == 0 && size == bytes.size() && text.size() == 2 * size;
}

std::string inBase64(std::span<const std::byte> bytes) {
  std::string text(sodium_base64_encoded_len(bytes.size(), kBase64), '\0');
  const auto* from = reinterpret_cast<const unsigned char*>(bytes.data());
  sodium_bin2base64(text.data(), text.size(), from, bytes.size(), kBase64);
  text.pop_back();  // the terminating zero
  return text;
}

std::optional<std::vector<std::byte>> fromBase64(std::string_view text) {
  // one byte more: data() of an empty vector may be null
  std::vector<std::byte> bytes(text.size() + 1);
  std::size_t size = 0;
  auto* to = reinterpret_cast<unsigned char*>(bytes.data());
  // With nullptr for the end pointer, trailing characters are an error.
  const int code = sodium_base642bin(
      to, bytes.size(), text.data(), text.size(), nullptr, &size, nullptr, kBase64);
  if (code != 0) return std::nullopt;
  bytes.resize(size);
  return bytes;
}

}  // namespace study::storage

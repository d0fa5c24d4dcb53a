#include "study/collect/exchange/hexadecimal.h"

#include <sodium.h>

namespace study::collect {

std::string hexadecimalOf(std::span<const std::byte> bytes) {
  std::string text(2 * bytes.size() + 1, '\0');
  sodium_bin2hex(
      text.data(), text.size(), reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  text.pop_back();
  return text;
}

std::vector<std::byte> bytesOfHexadecimal(const std::string& text) {
  std::vector<std::byte> bytes(text.size() / 2);
  std::size_t size = 0;
  sodium_hex2bin(
      reinterpret_cast<unsigned char*>(bytes.data()),
      bytes.size(),
      text.data(),
      text.size(),
      nullptr,
      &size,
      nullptr);
  bytes.resize(size);
  return bytes;
}

}  // namespace study::collect

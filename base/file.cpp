#include "base/file.h"

#include <array>
#include <fstream>
#include <utility>

namespace base {

std::string readAll(std::istream& stream) {
  std::string text;
  std::array<char, 65536> part;
  do {
    stream.read(part.data(), part.size());
    text.append(part.data(), static_cast<std::size_t>(stream.gcount()));
  } while (stream);
  return text;
}

std::optional<std::string> readFile(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  auto text = readAll(stream);
  return stream.is_open() && !stream.bad() ? std::optional(std::move(text)) : std::nullopt;
}

}  // namespace base

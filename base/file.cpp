#include "base/file.h"

#include <array>

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

}  // namespace base

#include "haptics/recordings/decimal.h"

#include <array>
#include <charconv>
#include <system_error>

namespace haptics::recordings {

std::string decimal(double value, int digits) {
  std::array<char, 64> text{};
  const auto [end, error] = std::to_chars(
      text.data(), text.data() + text.size(), value, std::chars_format::fixed, digits);
  return error == std::errc{} ? std::string(text.data(), end) : "a very large number";
}

}  // namespace haptics::recordings

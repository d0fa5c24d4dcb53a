#include "questionnaires/json/characters.h"

#include <array>
#include <cstdint>

namespace questionnaires {
namespace {

/// The leading bytes from first to last begin a character of `length` bytes, whose second byte lies
/// between secondLeast and secondMost (table 3-7 of the Unicode standard).
struct Lead {
  std::uint8_t first;
  std::uint8_t last;
  std::size_t length;
  std::uint8_t secondLeast;
  std::uint8_t secondMost;
};

constexpr std::array kLeads{
    Lead{0x00, 0x7F, 1, 0x80, 0xBF},
    Lead{0xC2, 0xDF, 2, 0x80, 0xBF},
    Lead{0xE0, 0xE0, 3, 0xA0, 0xBF},
    Lead{0xE1, 0xEC, 3, 0x80, 0xBF},
    Lead{0xED, 0xED, 3, 0x80, 0x9F},
    Lead{0xEE, 0xEF, 3, 0x80, 0xBF},
    Lead{0xF0, 0xF0, 4, 0x90, 0xBF},
    Lead{0xF1, 0xF3, 4, 0x80, 0xBF},
    Lead{0xF4, 0xF4, 4, 0x80, 0x8F},
};

/// The length of the sound character that @p text begins with; 0 where it begins with none.
std::size_t soundLength(std::string_view text) noexcept {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  for (const auto& lead : kLeads) {
    if (byte(0) < lead.first || byte(0) > lead.last) continue;
    if (text.size() < lead.length) return 0;
    for (std::size_t i = 1; i < lead.length; ++i) {
      const std::uint8_t least = i == 1 ? lead.secondLeast : 0x80;
      const std::uint8_t most = i == 1 ? lead.secondMost : 0xBF;
      if (byte(i) < least || byte(i) > most) return 0;
    }
    return lead.length;
  }
  return 0;
}

}  // namespace

std::optional<std::size_t> charactersIn(std::string_view text) noexcept {
  std::size_t count = 0;
  while (!text.empty()) {
    const std::size_t length = soundLength(text);
    if (length == 0) return std::nullopt;
    text.remove_prefix(length);
    ++count;
  }
  return count;
}

}  // namespace questionnaires

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

#include "base/file.h"
#include "base/search.h"
#include "questionnaires/json/document.h"

namespace questionnaires {
namespace {

/// The first bytes from `first` to `last` begin a character of `length` bytes whose second byte is
/// from secondByteLeast to secondByteMost (table 3-7 of the Unicode standard).
struct LeadByteRange {
  std::uint8_t first;
  std::uint8_t last;
  std::size_t length;
  std::uint8_t secondByteLeast;
  std::uint8_t secondByteMost;
};

constexpr std::array kLeadByteRanges{
    LeadByteRange{0x00, 0x7F, 1, 0x80, 0xBF},
    LeadByteRange{0xC2, 0xDF, 2, 0x80, 0xBF},
    LeadByteRange{0xE0, 0xE0, 3, 0xA0, 0xBF},
    LeadByteRange{0xE1, 0xEC, 3, 0x80, 0xBF},
    LeadByteRange{0xED, 0xED, 3, 0x80, 0x9F},
    LeadByteRange{0xEE, 0xEF, 3, 0x80, 0xBF},
    LeadByteRange{0xF0, 0xF0, 4, 0x90, 0xBF},
    LeadByteRange{0xF1, 0xF3, 4, 0x80, 0xBF},
    LeadByteRange{0xF4, 0xF4, 4, 0x80, 0x8F},
};

/// The length of the UTF-8 character at the beginning of @p text [bytes]; 0 if it is not valid.
std::size_t validUtf8Length(std::string_view text) noexcept {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  for (const auto& lead : kLeadByteRanges) {
    if (byte(0) < lead.first || byte(0) > lead.last) continue;
    if (text.size() < lead.length) return 0;
    for (std::size_t i = 1; i < lead.length; ++i) {
      const std::uint8_t least = i == 1 ? lead.secondByteLeast : 0x80;
      const std::uint8_t most = i == 1 ? lead.secondByteMost : 0xBF;
      if (byte(i) < least || byte(i) > most) return 0;
    }
    return lead.length;
  }
  return 0;
}

}  // namespace

std::optional<std::size_t> utf8CharacterCount(std::string_view text) noexcept {
  std::size_t count = 0;
  while (!text.empty()) {
    const std::size_t length = validUtf8Length(text);
    if (length == 0) return std::nullopt;
    text.remove_prefix(length);
    ++count;
  }
  return count;
}

std::string readTextFile(const std::string& path, std::size_t most) {
  namespace fs = std::filesystem;
  std::error_code error;
  const auto status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) {
    throw base::UserError("There is no file " + path + ". Check the spelling and the folder.");
  }
  if (status.type() != fs::file_type::regular) {
    throw base::UserError(path + " is not a file that can be read. Give the name of a text file.");
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    throw base::UserError(
        path + " cannot be opened (" + std::generic_category().message(errno) +
        "). Check who may read it.");
  }
  if (fs::file_size(path, error) > most) {
    throw base::UserError(
        path + " is larger than " + std::to_string(most / 1'000'000) +
        " MB. No researcher's file needs that; is it the right file?");
  }
  auto text = base::readAll(file);
  if (file.bad())
    throw base::UserError(path + " could not be read to its end. Is the disk healthy?");
  return text;
}

std::string typeName(const Value& value) {
  switch (value.data.index()) {
    case 0:
      return "null";
    case 1:
      return "true or false";
    case 2:
    case 3:
      return "a number";
    case 4:
      return "a text";
    case 5:
      return "a list";
    default:
      return "an object";
  }
}

std::string shown(double value) {
  constexpr double kLargest = 1e15;  // the digits of a larger number do not help the reader
  if (std::abs(value) > kLargest) return "any size";
  std::array<char, 64> digits{};
  const auto end = std::to_chars(digits.begin(), digits.end(), value, std::chars_format::fixed);
  return end.ec == std::errc() ? std::string(digits.begin(), end.ptr) : std::to_string(value);
}

std::string shown(std::string_view text) {
  constexpr std::size_t kLongest = 80;
  const auto isInsideCharacter = [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) == 0x80;
  };
  std::size_t end = std::min(text.size(), kLongest);
  while (end > 0 && end < text.size() && isInsideCharacter(text[end])) --end;
  std::string result(text.substr(0, end));
  const bool isSound = utf8CharacterCount(result).has_value();
  const auto isUnprintable = [&](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 || byte == 0x7f || (byte > 0x7f && !isSound);
  };
  std::ranges::replace_if(result, isUnprintable, '?');
  return end < text.size() ? result + "…" : result;
}

bool isValidId(std::string_view id) noexcept {
  const auto letterOrDigit = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
  };
  constexpr std::size_t kLongest = 64;
  return !id.empty() && id.size() <= kLongest && letterOrDigit(id.front()) &&
         std::ranges::all_of(
             id, [&](char c) { return letterOrDigit(c) || c == '.' || c == '_' || c == '-'; });
}

std::optional<std::string_view> nearest(
    std::string_view word, std::span<const std::string_view> known) {
  constexpr std::size_t kLongestWord = 64;
  if (word.size() > kLongestWord) return std::nullopt;
  std::optional<std::string_view> best;
  std::size_t fewest = std::max<std::size_t>(2, word.size() / 3) + 1;
  for (const auto name : known) {
    const std::size_t longer = std::max(word.size(), name.size());
    if (longer - std::min(word.size(), name.size()) >= fewest) continue;
    const std::size_t edits = base::editDistance(word, name);
    if (edits < fewest && edits < longer) {
      fewest = edits;
      best = name;
    }
  }
  return best;
}

}  // namespace questionnaires

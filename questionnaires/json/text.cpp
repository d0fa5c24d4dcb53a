#include <array>
#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

#include "questionnaires/json/document.h"

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

std::string readTextFile(const std::string& path, std::size_t most) {
  namespace fs = std::filesystem;
  std::error_code error;
  const auto status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) {
    throw Error("There is no file " + path + ". Check the spelling and the folder.");
  }
  if (status.type() != fs::file_type::regular) {
    throw Error(path + " is not a file that can be read. Give the name of a text file.");
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    throw Error(
        path + " cannot be opened (" + std::generic_category().message(errno) +
        "). Check who may read it.");
  }
  if (fs::file_size(path, error) > most) {
    throw Error(
        path + " is larger than " + std::to_string(most / 1'000'000) +
        " MB. No researcher's file needs that; is it the right file?");
  }
  std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  if (file.bad()) throw Error(path + " could not be read to its end. Is the disk healthy?");
  return text;
}

}  // namespace questionnaires

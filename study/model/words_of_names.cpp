#include "study/model/words_of_names.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace study {
namespace {

constexpr std::size_t kShortest = 3;      // letters; shorter words occur in every text
constexpr std::size_t kShortestName = 2;  // letters, of a word that begins with a capital letter:
                                          // Bo, Øy
constexpr std::size_t kShortestStem = 4;  // letters, of a name that may have an ending

/// Lower-case letters without diacritics for À (U+00C0) to ſ (U+017F), so that "Łódź" and "lodz"
/// are the same name. × and ÷ are not letters.
constexpr std::string_view kPlainLetters =
    "aaaaaaaceeeeiiiidnooooo*ouuuuytsaaaaaaaceeeeiiiidnooooo*ouuuuyty"
    "aaaaaaccccccccddddeeeeeeeeeegggggggghhhhiiiiiiiiiiiijjkkklllllll"
    "lllnnnnnnnnnoooooooorrrrrrssssssssttttttuuuuuuuuuuuuwwyyyzzzzzzs";
constexpr unsigned kFirstMarked = 0xc0;

constexpr bool isContinued(char c) {
  return (static_cast<unsigned char>(c) & 0xc0U) == 0x80;
}

struct Letter {
  std::string plain = {};  ///< empty if it is not a letter
  bool isCapital = false;
  bool isMark = false;  ///< a combining accent, which belongs to the letter before it
};

/// A letter of two bytes in UTF-8.
Letter markedLetter(std::string_view bytes) {
  const unsigned code = ((static_cast<unsigned char>(bytes[0]) & 0x1fU) << 6U) |
                        (static_cast<unsigned char>(bytes[1]) & 0x3fU);
  constexpr unsigned kFirstAccent = 0x300;
  constexpr unsigned kLastAccent = 0x36f;
  if (code >= kFirstAccent && code <= kLastAccent) return {.isMark = true};
  const bool isLatin = code >= kFirstMarked && code < kFirstMarked + kPlainLetters.size();
  if (!isLatin) return {.plain = std::string(bytes)};  // a letter of another alphabet is kept
  constexpr unsigned kSharpS = 0xdf;
  if (code == kSharpS) return {.plain = "ss"};
  const char plain = kPlainLetters[code - kFirstMarked];
  if (plain == '*') return {};
  // In Latin-1, capitals come first. Above it, capitals and small letters alternate; capitals are
  // odd from U+0139 to U+0148 and from U+0179 on, and even elsewhere.
  const bool isOdd = (code >= 0x139 && code <= 0x148) || code >= 0x179;
  const bool isCapital = code <= 0xff ? code <= 0xde : (code % 2 == 1) == isOdd;
  return {.plain = {plain}, .isCapital = isCapital};
}

/// @param bytes  one character in UTF-8
Letter letterIn(std::string_view bytes) {
  const char first = bytes.front();
  if (first >= 'A' && first <= 'Z') {
    return {.plain = {static_cast<char>(first + 0x20)}, .isCapital = true};
  }
  if (first >= 'a' && first <= 'z') return {.plain = {first}};
  if (static_cast<unsigned char>(first) < 0x80) return {};
  return bytes.size() == 2 ? markedLetter(bytes) : Letter{.plain = std::string(bytes)};
}

struct Word {
  std::string plain = {};
  std::string_view written = {};
};

/// Whether @p letter after @p word stands for a mark: "ae" for ä or æ, "oe" for ö or ø, "ue" for ü,
/// "aa" for å.
bool isMark(const std::string& word, const std::string& letter) {
  if (word.empty()) return false;
  const char last = word.back();
  return (letter == "e" && (last == 'a' || last == 'o' || last == 'u')) ||
         (letter == "a" && last == 'a');
}

std::vector<Word> splitIntoWords(std::string_view text) {
  std::vector<Word> words;
  std::string word;
  std::size_t begin = 0;
  std::size_t stop = 0;
  std::size_t letters = 0;
  bool hasCapital = false;
  const auto end = [&] {
    if (letters >= (hasCapital ? kShortestName : kShortest)) {
      words.push_back({word, text.substr(begin, stop - begin)});
    }
    word.clear();
    letters = 0;
  };
  for (std::size_t i = 0; i < text.size();) {
    std::size_t size = 1;
    while (i + size < text.size() && isContinued(text[i + size])) ++size;
    const auto letter = letterIn(text.substr(i, size));
    const auto at = i;
    i += size;
    if (letter.isMark) {
      stop = i;
      continue;
    }
    if (letter.plain.empty()) {
      end();
      continue;
    }
    if (letters == 0) {
      hasCapital = letter.isCapital;
      begin = at;
    }
    stop = i;
    if (!isMark(word, letter.plain)) word += letter.plain;
    ++letters;
  }
  end();
  return words;
}

}  // namespace

std::vector<std::string> wordsIn(std::string_view text) {
  std::vector<std::string> words;
  for (auto& word : splitIntoWords(text)) words.push_back(std::move(word.plain));
  return words;
}

std::string wordNaming(std::string_view text, std::string_view name) {
  const auto names = wordsIn(name);
  for (const auto& word : splitIntoWords(text)) {
    const bool isNaming = std::ranges::any_of(names, [&](const auto& part) {
      return word.plain == part || (part.size() >= kShortestStem && word.plain.starts_with(part));
    });
    if (isNaming) return std::string(word.written);
  }
  return {};
}

}  // namespace study

#include "study/export/named_people.h"

#include <set>

#include "study/export/export_parts.h"
#include "study/export/public_people.h"
#include "study/words/counted.h"

namespace study {
namespace {

constexpr std::size_t kShortest = 3;      // letters; shorter words occur in every text
constexpr std::size_t kShortestName = 2;  // letters, of a word that begins with a capital letter:
                                          // Bo, Øy

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

/// A line on how many people can be re-identified by their cohort and background.
std::string describeClassSizes(const ClassSizes& classes) {
  if (classes.people == 0) return {};
  return "- " + std::to_string(classes.peopleInSmallClasses) + " of " +
         words::counted(classes.people, "person is", "people are") +
         " alone with their cohort and background: a reader who knows these finds the other "
         "answers. To publish data, make an export for the public instead.\n";
}

std::string namesInWords(const NameSearchResult& named) {
  if (named.areLocked) {
    return "- The names that the study keeps are behind a passphrase that was not given, so none "
           "was "
           "searched for here. Read free texts before you give them away.\n";
  }
  if (named.names == 0) {
    return "- The study keeps no names, so none could be searched for here. Read free texts before "
           "you give them away.\n";
  }
  std::string where;
  std::size_t cells = 0;
  for (const auto& [table, count] : named.cells) {
    where += (where.empty() ? "" : ", ") + table + ": " + std::to_string(count);
    cells += count;
  }
  if (cells > 0) {
    return "- THIS FOLDER NAMES PEOPLE: " + words::counted(cells, "cell has", "cells have") +
           " a word of a name that the study keeps apart (" + where +
           "). Do not give it away as it is.\n";
  }
  return "- No name that the study keeps apart is in this folder: " +
         words::counted(named.names, "word was", "words were") +
         " searched for in every text. Names of other people were not searched for: read free "
         "texts before you give them away.\n";
}

}  // namespace

std::vector<std::string> wordsIn(std::string_view text) {
  std::vector<std::string> words;
  std::string word;
  std::size_t letters = 0;
  bool hasCapital = false;
  const auto end = [&] {
    if (letters >= (hasCapital ? kShortestName : kShortest)) words.push_back(word);
    word.clear();
    letters = 0;
  };
  for (std::size_t i = 0; i < text.size();) {
    std::size_t size = 1;
    while (i + size < text.size() && isContinued(text[i + size])) ++size;
    const auto letter = letterIn(text.substr(i, size));
    i += size;
    if (letter.isMark) continue;
    if (letter.plain.empty()) {
      end();
      continue;
    }
    if (letters == 0) hasCapital = letter.isCapital;
    word += letter.plain;
    ++letters;
  }
  end();
  return words;
}

NameSearchResult searchForNames(Study& study, const std::vector<ExportedTable>& tables) {
  if (study.identities().isLocked()) return {.areLocked = true, .cells = {}};
  std::set<std::string> names;
  for (const auto& text : study.identities().texts()) {
    for (auto& word : wordsIn(text)) names.insert(std::move(word));
  }
  NameSearchResult named{.names = names.size(), .cells = {}};
  const auto isNaming = [&](const Cell& cell) {
    const auto* text = std::get_if<std::string>(&cell);
    if (text == nullptr) return false;
    for (const auto& word : wordsIn(*text)) {
      if (names.count(word) > 0) return true;
    }
    return false;
  };
  for (const auto& table : tables) {
    for (const auto& row : table.rows) {
      for (std::size_t i = 0; i < row.size(); ++i) {
        const auto& column = table.columns[i];
        // the operator may have typed the code
        const bool isTyped = column.isFreeText || column.name == "participant_id";
        if (isTyped && isNaming(row[i])) ++named.cells[table.name];
      }
    }
  }
  return named;
}

ClassSizes classSizesAsReleased(Study& study, const ExportOptions& options) {
  const PublicPeople people(study, options.runMode.value_or(RunMode::Live));
  std::vector<ReleasedColumn> columns;
  for (const auto& identifier : people.identifiers()) {
    if (identifier.name == kOrderColumn) continue;
    const bool isAsAnswered = options.isExact || identifier.levels.empty();
    columns.push_back(
        {identifier.name, 0, isAsAnswered ? identifier.exact : identifier.levels.front()});
  }
  constexpr std::size_t kTwo = 2;
  return classSizes(columns, people.count(), kTwo);
}

std::string identifiabilityInWords(Study& study, const ExportOptions& options) {
  if (options.runMode == RunMode::Simulated) return "- Nothing in this folder names a person.\n";
  return describeClassSizes(classSizesAsReleased(study, options)) +
         namesInWords(searchForNames(study, exportTables(study, options)));
}

}  // namespace study

#include "study/export/named_people.h"

#include <set>

#include "study/export/export_parts.h"
#include "study/export/public_people.h"
#include "study/words/counted.h"

namespace study {
namespace {

constexpr std::size_t kShortest = 3;  // letters: shorter words of names stand in every text

/// In lower case: ASCII, and the letters of Latin-1, which have two bytes in UTF-8 (Å is C3 85, å
/// is C3 A5). Other letters stay as they are.
std::string lowered(std::string_view text) {
  std::string lower(text);
  for (std::size_t i = 0; i < lower.size(); ++i) {
    const auto byte = static_cast<unsigned char>(lower[i]);
    const bool isAfterC3 = i > 0 && static_cast<unsigned char>(lower[i - 1]) == 0xc3;
    constexpr unsigned char kTimes = 0x97;  // ×, no letter
    const bool isCapital = isAfterC3 && byte >= 0x80 && byte <= 0x9e && byte != kTimes;
    if ((byte >= 'A' && byte <= 'Z') || isCapital) lower[i] = static_cast<char>(byte + 0x20);
  }
  return lower;
}

bool isLetter(char c) {
  return (c >= 'a' && c <= 'z') || static_cast<unsigned char>(c) >= 0x80;
}

std::size_t lettersIn(std::string_view word) {
  std::size_t letters = 0;
  for (const char c : word) letters += (static_cast<unsigned char>(c) & 0xc0U) != 0x80 ? 1 : 0;
  return letters;
}

/// What is told of people besides their answers.
std::string alikeInWords(const ClassSizes& classes) {
  if (classes.people == 0) return {};
  return "- Who knows cohort and background of somebody finds the rest: " +
         std::to_string(classes.inSmall) + " of " +
         words::counted(classes.people, "person is", "people are") +
         " alone with theirs. Publish with `--public` only.\n";
}

std::string namesInWords(const NamedPeople& named) {
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
         " searched for in every text. Nobody searched for names of others.\n";
}

}  // namespace

std::vector<std::string> wordsIn(std::string_view text) {
  const std::string lower = lowered(text);
  std::vector<std::string> words;
  std::string word;
  for (std::size_t i = 0; i <= lower.size(); ++i) {
    if (i < lower.size() && isLetter(lower[i])) {
      word += lower[i];
      continue;
    }
    if (lettersIn(word) >= kShortest) words.push_back(word);
    word.clear();
  }
  return words;
}

NamedPeople namedPeople(Study& study, const std::vector<ExportedTable>& tables) {
  if (study.identities().isLocked()) return {.areLocked = true, .cells = {}};
  std::set<std::string> names;
  for (const auto& text : study.identities().texts()) {
    for (auto& word : wordsIn(text)) names.insert(std::move(word));
  }
  NamedPeople named{.names = names.size(), .cells = {}};
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
        if (table.columns[i].isFreeText && isNaming(row[i])) ++named.cells[table.name];
      }
    }
  }
  return named;
}

ClassSizes alikeAsTold(Study& study, const ExportOptions& options) {
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
  return alikeInWords(alikeAsTold(study, options)) +
         namesInWords(namedPeople(study, exportTables(study, options)));
}

}  // namespace study

#include "study/export/named_people.h"

#include <set>

#include "study/export/export_parts.h"
#include "study/export/public_people.h"
#include "study/model/words_of_names.h"
#include "study/words/counted.h"

namespace study {
namespace {

/// A line on how many people can be re-identified by their cohort and background.
std::string describeClassSizes(const ClassSizes& classes) {
  if (classes.people == 0) return {};
  return "- " + std::to_string(classes.peopleInSmallClasses) + " of " +
         words::counted(classes.people, "person who completed is", "people who completed are") +
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

#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "study/export/export.h"
#include "study/export/k_anonymity.h"

namespace study {

/// The words of @p text of three letters or more, or of two with a capital, without case and marks
/// of Latin letters: "Åsgård" is "asgard". Letters of other alphabets stay as they are.
std::vector<std::string> wordsIn(std::string_view text);

/// Where an export names people.
struct NamedPeople {
  std::size_t names = 0;   ///< words of answers in identity.db that were searched for
  bool areLocked = false;  ///< names are behind a passphrase, and were not searched for
  std::map<std::string, std::size_t> cells;  ///< that hold one of them, by table
};

/// Searches every text of @p tables that somebody typed, participant codes as well, for the words
/// of every answer that names a person. What people wrote about others, and nicknames, are not
/// found.
NamedPeople namedPeople(Study& study, const std::vector<ExportedTable>& tables);

/// The people who completed, in classes that are alike in their cohort and in what an export with
/// @p options tells of them; k is 2, so that people in small classes are alone.
ClassSizes classSizesAsReleased(Study& study, const ExportOptions& options);

/// What an export for colleagues tells of people, in lines of a README: who can be found again, and
/// whether it names somebody.
std::string identifiabilityInWords(Study& study, const ExportOptions& options);

}  // namespace study

#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "study/export/export.h"
#include "study/export/k_anonymity.h"

namespace study {

/// The result of searching an export for names of participants.
struct NameSearchResult {
  std::size_t names = 0;   ///< number of words of answers in identity.db that were searched for
  bool areLocked = false;  ///< whether names are locked by a passphrase, so that they were not
                           ///< searched for
  std::map<std::string, std::size_t> cells;  ///< number of cells with one of these words, by table
};

/// Searches free texts and participant codes of @p tables for the words of all answers in
/// identity.db. Does not find nicknames, or names of other people.
NameSearchResult searchForNames(Study& study, const std::vector<ExportedTable>& tables);

/// The equivalence classes of people with completed sessions, by cohort and the facts about them
/// that an export with @p options contains. k is 2: ClassSizes::peopleInSmallClasses counts people
/// who are unique.
ClassSizes classSizesAsReleased(Study& study, const ExportOptions& options);

/// Lines of the README of an export that is not public: how many people can be re-identified, and
/// whether names were found.
std::string identifiabilityInWords(Study& study, const ExportOptions& options);

}  // namespace study

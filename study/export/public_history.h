#pragma once

#include <string>

#include "study/export/export.h"
#include "study/export/k_anonymity.h"

namespace study {

/// The people of a public export by what earlier ones of the same study said of them. Whoever has
/// both finds the same people in both by their opinions, and knows of each what either says, and
/// that the others came in between. So classes have to hold k people also with all exports laid
/// beside each other.
struct AfterEarlierExports {
  std::size_t earlier = 0;    ///< public exports of the same run mode before
  std::size_t newPeople = 0;  ///< that are in none of them
  ClassSizes together;        ///< of people who are alike in all exports
};

/// Reads the audit trail. What an earlier export said is computed again from the people who had
/// completed by then. Simulated sessions have no people, and nothing is compared.
AfterEarlierExports afterEarlierExports(Study& study, const ExportOptions& options);

/// @throws storage::StorageError  in words, if subtracting an earlier public export would lay bare
///     fewer people than the smallest class that @p options ask for.
void requireNothingLaidBare(Study& study, const ExportOptions& options);

}  // namespace study

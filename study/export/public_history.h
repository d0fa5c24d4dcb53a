#pragma once

#include <string>

#include "study/export/export.h"
#include "study/export/k_anonymity.h"

namespace study {

/// How a public export relates to earlier ones of the same study. A reader of both recognises the
/// same people by their answers, combines what the exports say of them, and knows that the others
/// joined in between. So classes need k people also after all exports are combined.
struct ExportHistory {
  std::size_t earlier = 0;    ///< public exports of the same run mode before
  std::size_t newPeople = 0;  ///< that are in none of them
  ClassSizes together;        ///< of people who are alike in all exports
};

/// Reads the audit trail. What an earlier export said is computed again from the people who had
/// completed by then. Simulated sessions have no people, and nothing is compared.
ExportHistory exportHistory(Study& study, const ExportOptions& options);

/// @throws storage::StorageError  in words, if subtracting an earlier public export would lay bare
///     fewer people than the smallest class that @p options ask for.
void requireSafeFromDifferencing(Study& study, const ExportOptions& options);

}  // namespace study

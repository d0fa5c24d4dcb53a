#pragma once

#include <string>

#include "study/export/export.h"
#include "study/export/k_anonymity.h"

namespace study {

/// How a public export relates to earlier ones of the same study. A reader of several exports can
/// match people by their answers, combine the released facts about them, and infer that the others
/// joined in between. Therefore each class needs k people after all exports are combined, too.
struct ExportHistory {
  std::size_t earlier = 0;    ///< public exports of the same run mode before
  std::size_t newPeople = 0;  ///< people who are in no earlier export
  ClassSizes together;        ///< classes of people with the same values in all exports
};

/// Finds earlier public exports in the audit trail, and recomputes what each released from the
/// sessions that were completed by then. Empty for simulated sessions.
ExportHistory exportHistory(Study& study, const ExportOptions& options);

/// @throws storage::StorageError  if combining the export with earlier ones would leave a class
///     with fewer people than the smallest class that @p options ask for.
void requireSafeFromDifferencing(Study& study, const ExportOptions& options);

}  // namespace study

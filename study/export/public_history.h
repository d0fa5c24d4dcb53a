#pragma once

#include "study/export/export.h"
#include "study/export/k_anonymity.h"

namespace study {

/// How a public export relates to earlier ones of the same study. A reader of several exports can
/// match people by their answers, combine the released facts about them, and infer which people
/// joined in between. Therefore each class must have k people even after all exports are combined.
struct ExportHistory {
  std::size_t earlier = 0;     ///< number of earlier public exports of the same run mode
  std::size_t newPeople = 0;   ///< number of people who are in no earlier export
  ClassSizes combinedClasses;  ///< classes of people with equal values in all exports
};

/// Finds earlier public exports in the audit trail, and recomputes from the sessions that were
/// completed at that time what each export released. Empty for simulated sessions.
ExportHistory exportHistory(Study& study, const ExportOptions& options);

/// Remembers the export of a collected study in a list of this account, for folders that are pulled
/// later. @throws storage::StorageError
void rememberPublicExport(Study& study, RunMode mode, std::size_t k);

/// @throws storage::StorageError  if a class has fewer than ExportOptions::publicClassSize people
/// after
///     the export is combined with earlier ones.
void requireSafeFromDifferencing(Study& study, const ExportOptions& options);

}  // namespace study

#include "study/session/restored_copy.h"

#include "study/storage/evidence/head_check.h"

namespace study {

std::size_t headsMissingIn(Study& study) {
  const auto station = storage::StationStore::find(storage::StationStore::usualFolder());
  if (!station) return 0;
  return missingHeads(storage::TrailHeads(study.database()), *station).size();
}

std::size_t noteRestoredCopy(Study& study, const std::string& reason) {
  const auto station = storage::StationStore::find(storage::StationStore::usualFolder());
  if (!station) return 0;
  const auto missing = missingHeads(storage::TrailHeads(study.database()), *station);
  if (missing.empty()) return 0;
  std::string names;
  for (const auto& head : missing) names += (names.empty() ? "" : " ") + nameOf(head);
  study.note(
      {.actor = storage::Actor::Operator,
       .kind = EventKind::RestoredCopy,
       .values = {{"reason", reason}, {"given_up", names}}});
  return missing.size();
}

}  // namespace study

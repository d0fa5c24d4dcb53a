#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "study/session/study.h"
#include "study/storage/erasure/byte_search.h"
#include "study/storage/erasure/erasure_list.h"
#include "study/storage/erasure/erasure_repository.h"

namespace study {

struct ErasureRequest {
  std::string participant;  ///< code
  storage::ErasureLevel level = storage::ErasureLevel::All;
  std::string reason;
  /// Seals the unsealed trail of an older release first, for the whole study.
  bool resealsTrail = false;
  /// Repeats in this copy an erasure of another copy. The trail is then not signed, because the
  /// study itself does not have these events.
  bool isAgain = false;
};

struct ErasureReport {
  storage::Erasure erasure;
  std::size_t sessions = 0;
  std::int64_t answers = 0;  ///< that were deleted
  std::size_t names = 0;     ///< that were deleted
  /// Names were deleted without being read, so texts has none of them.
  bool areNamesLocked = false;
  bool wasTrailResealed = false;
  storage::ByteSearch texts;  ///< texts by and about the participant
  /// Files of the study's folder that still contain one of these texts.
  std::vector<std::string> filesWithTexts;
  storage::ListedErasure listed;  ///< for other copies of the study
  std::string whyNotListed;       ///< empty: it was added to this station's list
};

/// Erases a participant. Only code, cohort, times, the drawn order, events without their details,
/// and the record of the erasure are left. The audit trail stays valid. The place is free again, as
/// after a withdrawal; no result counts the participant.
///
/// The decision is one transaction in study.db. Then the participant's keys are destroyed, and all
/// three files are rebuilt without free pages and logs. If that is interrupted, the next
/// Study::open() finishes it before anything can be read. Last, the erasure is added to this
/// station's list: opening any other copy of the study repeats it there.
/// @throws UserError  if there is no such participant, or it is a simulated one; if the reason is
///     missing or names the participant; if the trail is unsealed (of an older release) and
///     resealsTrail is not set
/// @throws storage::StorageError  (Busy) if a session of the participant is open, or another
///     program reads the study: then the rest is done when the study is opened next
ErasureReport erase(Study& study, const ErasureRequest& request);

/// Repeats in this copy an erasure that was done in another copy of the study; seals the trail
/// first if need be. @throws storage::StorageError
void repeatErasure(Study& study, const storage::ListedErasure& erasure);

/// Whether an erasure must be finished before the study may be read: an interrupted one, or one of
/// this station's list that was not repeated here. @param database  study.db
bool hasPendingErasures(storage::Database& database);

/// Finishes and repeats these erasures. @throws storage::StorageError
void finishPendingErasures(Study& study);

/// A remark on how many participants have unsealed events, which an older release wrote; empty:
/// none.
std::string remarkOnUnsealedTrail(Study& study);

/// The remarks of `palpate study verify` on erasures and on unsealed parts of the trail.
std::vector<std::string> remarksOnErasure(Study& study);

}  // namespace study

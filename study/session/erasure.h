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
  /// Seals the trail of an older release first, once and for the whole study.
  bool sealsTrailAgain = false;
  /// It was erased from another copy before. No head of this one is signed: the study would not
  /// have it.
  bool isAgain = false;
};

struct ErasureReport {
  storage::Erasure erasure;
  std::size_t sessions = 0;
  std::int64_t answers = 0;     ///< that were deleted
  std::size_t names = 0;        ///< that were deleted
  bool areNamesLocked = false;  ///< they were deleted without being read, or searched for
  bool wasTrailSealedAgain = false;
  storage::ByteSearch texts;  ///< what the participant wrote, and others of them
  /// Files of the folder that still hold one of these texts.
  std::vector<std::string> filesWithTexts;
  storage::ListedErasure listed;  ///< for other copies of the study
  std::string whyNotListed;       ///< empty: it is in the list of this station
};

/// Erases a participant. What is left is a tombstone: code, cohort, times, the order that was
/// drawn, the events without what they say, and that and why it was erased. The audit trail stays
/// sound. Places are free again, as after a withdrawal; no result counts the participant.
///
/// The decision is one transaction in study.db. Then the participant's keys are destroyed, and all
/// three files are built anew without their free pages and logs. If that is interrupted, the next
/// Study::open() goes on with it, so that nothing can be read before. Last, the erasure is listed
/// on this station: opening any other copy of the study erases there, too.
/// @throws UserError  if there is no such participant, or nobody real; if the reason is missing or
///     names the participant; if the trail is of an older release and is not to be sealed
/// @throws storage::StorageError  (Busy) if a session of the participant is open, or another
///     program reads the study: then the rest is done when the study is opened next
ErasureReport erase(Study& study, const ErasureRequest& request);

/// Erases what was erased from another copy of the study, whatever format it has. Does nothing
/// twice. @throws storage::StorageError
void eraseAgain(Study& study, const storage::ListedErasure& erasure);

/// Whether something is left to do before a study may be read: an erasure that was interrupted, or
/// one that this station has listed. @param database  study.db
bool isErasureOpen(storage::Database& database);

/// Does it. @throws storage::StorageError
void finishErasures(Study& study);

/// Says how many participants the trail speaks of in the open, because an older release wrote it;
/// empty: none.
std::string remarksOnOpenTrail(Study& study);

/// What `palpate study verify` says of erasures and of parts of the trail that are not sealed.
std::vector<std::string> remarksOnErasure(Study& study);

}  // namespace study

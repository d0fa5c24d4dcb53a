#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "study/session/study.h"
#include "study/storage/erasure/byte_search.h"
#include "study/storage/erasure/erasure_list.h"
#include "study/storage/erasure/erasure_repository.h"

namespace study {

/// What to erase.
struct ErasureRequest {
  std::string participant;  ///< code
  storage::ErasureLevel level = storage::ErasureLevel::All;
  std::string reason;
  /// Whether the unsealed trail of an older release is sealed first, for the whole study.
  bool resealsTrail = false;
  /// The request repeats in this copy an erasure of another copy. The trail is then not signed,
  /// because the study itself does not have these events.
  bool isRepetition = false;
};

/// The result of an erasure.
struct ErasureReport {
  storage::Erasure erasure;
  std::size_t sessions = 0;
  std::int64_t answers = 0;  ///< number of deleted answers
  std::size_t names = 0;     ///< number of deleted names
  /// The names were sealed and locked: they were deleted without being read, and texts lacks them.
  bool areNamesLocked = false;
  bool wasTrailResealed = false;
  storage::ByteSearch texts;  ///< texts by and about the participant
  /// Files of the study's folder that still contain one of these texts.
  std::vector<std::string> filesWithTexts;
  storage::ListedErasure listed;  ///< the erasure, for repeating it in other copies of the study
  /// In a study at several sites: the label of the station that recorded the participant, whose
  /// answers the server keeps until that station has pushed the erasure. Else empty.
  std::string stationToPush;
  /// The erasure was done in a folder that was pulled: the server and the station keep the answers.
  bool isInPulledFolder = false;
  std::string whyNotListed;  ///< why the erasure is not in this station's list; empty if it is
};

/// Erases a participant. Only the code, cohort, times, drawn order, events without their details,
/// and the record of the erasure are kept. The audit trail stays valid. The participant's place in
/// the design becomes free, as after a withdrawal; no result counts the participant.
///
/// The rows are erased and the erasure is recorded in one transaction of study.db. Then the
/// participant's keys are destroyed, and all three files are rebuilt without free pages and logs.
/// If this is interrupted, the next Study::open() finishes it before anything can be read. Last,
/// the erasure is added to this station's list, so that it is repeated in every other copy of the
/// study when this station opens the copy.
/// @throws UserError  if there is no such participant, or it is a simulated one; if the reason is
///     missing or names the participant; if the trail is unsealed (of an older release) and
///     resealsTrail is not set
/// @throws storage::StorageError  (Busy) if a session of the participant is open, or another
///     program reads the study: then the next Study::open() does the rest
ErasureReport erase(Study& study, const ErasureRequest& request);

/// Repeats in this copy an erasure that was done in another copy of the study; seals an unsealed
/// trail first. @throws storage::StorageError
void repeatErasure(Study& study, const storage::ListedErasure& erasure);

/// Whether an erasure must be finished before the study may be read: one that was interrupted, or
/// one of this station's list that was not repeated in this copy. @param database  study.db
bool hasPendingErasures(storage::Database& database);

/// Finishes interrupted erasures and repeats those of this station's list.
/// @throws storage::StorageError
void finishPendingErasures(Study& study);

/// A remark on the number of participants with unsealed events, which an older release wrote; empty
/// if there are none.
std::string remarkOnUnsealedTrail(Study& study);

/// The remarks of `palpate study verify` on erasures and on unsealed parts of the trail.
std::vector<std::string> remarksOnErasure(Study& study);

}  // namespace study

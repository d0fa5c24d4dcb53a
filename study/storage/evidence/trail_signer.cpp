#include "study/storage/evidence/trail_signer.h"

#include <exception>
#include <utility>

#include "study/model/event_kind.h"
#include "study/model/storage_error.h"
#include "study/storage/event_log.h"
#include "study/storage/evidence/head_check.h"
#include "study/storage/evidence/station_heads.h"

namespace study::storage {
namespace {

std::optional<StationStore> thisStation() {
  try {
    return StationStore::openOrCreate(StationStore::defaultFolder());
  } catch (const StorageError&) {
    return std::nullopt;  // 'palpate study verify' reports why the store cannot be opened
  }
}

/// Whether an event with this purpose explains why the trail differs from the one that was signed
/// before. The program writes such events only after checking that trail, or with a reason given by
/// the operator.
bool explainsAnotherTrail(std::string_view purpose) {
  using enum EventKind;
  return purpose == nameOf(RestoredCopy) || purpose == nameOf(ResealedTrail) ||
         purpose == nameOf(CollectedStudy);
}

/// Whether this station may sign the trail. A signature covers all events before it, so signing a
/// trail that was rewritten or cut off would make it look authentic.
bool maySign(const Database& study, const StationStore& station, std::string_view purpose) {
  if (explainsAnotherTrail(purpose)) return true;
  try {
    // Inside the transaction that signs, so that nothing is stored or signed meanwhile.
    const TrailHeads trail(study);
    return missingHeads(trail, readRecordedHeads(station, trail.study())).empty();
  } catch (const StorageError&) {
    return false;  // the station's list cannot be read
  }
}

}  // namespace

void TrailSigner::sign(Database& study, std::string_view purpose, const Moment& now) {
  const auto station = thisStation();
  if (!station || !maySign(study, *station, purpose)) {
    EventLog(study).append(
        {.when = now, .kind = EventKind::HeadNotSigned, .detail = std::string(purpose)});
    return;
  }
  signed_ = signHead(study, *station, purpose, asUtc(now.wall));
  EventLog(study).append(
      {.when = now, .kind = EventKind::SignedHead, .values = signed_->asValues()});
}

bool TrailSigner::recordSignedHead() noexcept {
  const auto head = std::exchange(signed_, std::nullopt);
  if (!head) return true;
  try {
    recordHead(StationStore::openOrCreate(StationStore::defaultFolder()), *head, folder_);
    return true;
  } catch (const std::exception&) {
    return false;
  }
}

void recordNewStudy(const Database& study, const std::filesystem::path& folder, const Moment& now) {
  const auto station = thisStation();
  if (!station) return;
  try {
    recordHead(
        *station, signHead(study, *station, nameOf(EventKind::MadeStudy), asUtc(now.wall)), folder);
  } catch (const StorageError&) {
    return;  // the first signed head covers the event MadeStudy, too
  }
}

}  // namespace study::storage

#include "study/storage/evidence/trail_signer.h"

#include <exception>
#include <utility>

#include "study/model/event_kind.h"
#include "study/model/storage_error.h"
#include "study/storage/event_log.h"
#include "study/storage/evidence/station_heads.h"

namespace study::storage {
namespace {

std::optional<StationStore> thisStation() {
  try {
    return StationStore::findOrMake(StationStore::usualFolder());
  } catch (const StorageError&) {
    return std::nullopt;  // 'palpate study verify' opens it, too, and says why
  }
}

}  // namespace

void TrailSigner::sign(Database& study, std::string_view purpose, const Moment& now) {
  const auto station = thisStation();
  if (!station) {
    EventLog(study).append(
        {.when = now, .kind = EventKind::HeadNotSigned, .detail = std::string(purpose)});
    return;
  }
  signed_ = signHead(study, *station, purpose, asUtc(now.wall));
  EventLog(study).append(
      {.when = now, .kind = EventKind::SignedHead, .values = signed_->asValues()});
}

bool TrailSigner::noteSigned() noexcept {
  const auto head = std::exchange(signed_, std::nullopt);
  if (!head) return true;
  try {
    noteHead(StationStore::findOrMake(StationStore::usualFolder()), *head, folder_);
    return true;
  } catch (const std::exception&) {
    return false;
  }
}

void noteNewStudy(const Database& study, const std::filesystem::path& folder, const Moment& now) {
  const auto station = thisStation();
  if (!station) return;
  try {
    noteHead(
        *station, signHead(study, *station, nameOf(EventKind::MadeStudy), asUtc(now.wall)), folder);
  } catch (const StorageError&) {
    return;  // the first head that is signed says the same
  }
}

}  // namespace study::storage

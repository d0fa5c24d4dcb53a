#include "study/collect/exchange/outbox.h"

#include <algorithm>
#include <utility>

#include "study/model/user_error.h"
#include "study/storage/hasher.h"
#include "study/storage/transfer/session_facts.h"

namespace study::collect {
namespace {

bool isTrialsEnd(const storage::StoredEvent& event) {
  return event.kind == nameOf(EventKind::KeptTrace) && event.session && event.step && event.attempt;
}

}  // namespace

Outbox::Outbox(const std::filesystem::path& folder, Clock& clock)
    : study_(Study::open(folder, clock, storage::Database::Access::ReadOnly)) {
  if (study_.station().isNone()) {
    throw UserError(
        folder.string() + (study_.isCollected()
                               ? " was put together of what several stations sent: there is "
                                 "nothing in it to be sent."
                               : " is a study of this computer alone: it was not made by 'palpate "
                                 "collect join', and nothing of it is collected."));
  }
  // In this order: a trial's samples are stored before the event of its end.
  study_.database().beginSnapshot();
  lastEvent_ = study_.events().last();
  study_.traces().database().beginSnapshot();
  study_.identities().database().beginSnapshot();
}

std::string Outbox::hashOf(std::int64_t event) {
  const auto found = study_.events().stored(event - 1, 1);
  return found.empty() ? std::string() : storage::inHexadecimal(found.front().hash);
}

Batch Outbox::emptyBatch(std::int64_t after) {
  return {.study = study(), .station = station().uuid, .after = hashOf(after)};
}

Batch Outbox::lastEventQuery() {
  return emptyBatch(0);
}

Batch Outbox::eventQuery(std::int64_t event) {
  Batch batch = emptyBatch(event - 1);
  batch.events = study_.events().stored(event - 1, 1);
  return batch;
}

/// Adds the rows of each session whose last event is in the batch, because that event has their
/// hash.
void Outbox::addSessions(Batch& batch) {
  for (const auto& mark : storage::lastSessionEvents(study_.database())) {
    const bool isHere = !batch.events.empty() && mark.lastEvent >= batch.events.front().seq &&
                        mark.lastEvent <= batch.events.back().seq;
    if (!isHere) continue;
    batch.sessions.push_back(
        {.number = static_cast<std::int64_t>(mark.session),
         .lastEvent = mark.lastEvent,
         .facts = asText(storage::sessionTablesOf(study_.database(), mark.session))});
    const auto key = study_.events().keyOf(mark.session);
    if (key) batch.keys.push_back({.participant = mark.participant, .key = *key});
  }
}

/// Sends the samples of trials that end in these events, before the events themselves.
bool Outbox::sendChunks(const Batch& events, const std::function<bool(const Batch&)>& send) {
  Batch part = lastEventQuery();
  std::size_t size = 0;
  for (const auto& event : events.events) {
    if (!isTrialsEnd(event)) continue;
    const VisitKey visit{
        SessionId{*event.session}, static_cast<int>(*event.step), static_cast<int>(*event.attempt)};
    for (auto& chunk : storage::chunksOf(study_.traces().database(), visit)) {
      size += chunk.data.size();
      part.chunks.push_back({.session = *event.session, .chunk = std::move(chunk)});
      if (size < limits_.traceBytes) continue;
      if (!send(part)) return false;
      part = lastEventQuery();
      size = 0;
    }
  }
  return part.chunks.empty() || send(part);
}

void Outbox::forEachBatch(std::int64_t after, const std::function<bool(const Batch&)>& send) {
  while (after < lastEvent_) {
    Batch batch = emptyBatch(after);
    batch.events = study_.events().stored(after, std::min(limits_.events, lastEvent_ - after));
    if (batch.events.empty()) return;
    addSessions(batch);
    if (!sendChunks(batch, send) || !send(batch)) return;
    after = batch.events.back().seq;
  }
}

}  // namespace study::collect

#include "study/collect/exchange/push.h"

#include <algorithm>

#include <fmt/format.h>

#include "study/collect/server/schema.h"
#include "study/storage/hasher.h"
#include "study/storage/protocol_repository.h"

namespace study::collect {
namespace {

[[noreturn]] void throwRefusal(const ServerAnswer& answer) {
  throw PushRefused(answer.refused, wordsFor(answer));
}

/// Requires that the server's last event is in this folder. Otherwise another copy of the folder
/// was continued, and the server records an incident.
void requireSameTrail(Outbox& outbox, Connection& server, const ServerAnswer& answer) {
  if (!answer.refused.empty()) throwRefusal(answer);
  const auto problem = disagreementWith(answer, outbox);
  if (problem.refused.empty()) return;
  const auto said =
      ingest(server, outbox.eventQuery(std::min(answer.lastEvent, outbox.lastEvent())));
  throwRefusal(said.refused.empty() ? problem : said);
}

}  // namespace

ServerAnswer disagreementWith(const ServerAnswer& answer, Outbox& outbox) {
  const auto last = outbox.lastEvent();
  if (answer.lastEvent > last) {
    return {
        .refused = "older_copy",
        .detail = fmt::format("events: {} there, {} here", answer.lastEvent, last)};
  }
  if (answer.lastEvent == 0 || outbox.hashOf(answer.lastEvent) == answer.head) return {};
  return {
      .refused = "fork",
      .detail = fmt::format("event {} is there with another hash", answer.lastEvent)};
}

ServerAnswer ingest(Connection& server, const Batch& batch) {
  const auto text = asText(batch);
  std::vector<std::vector<std::byte>> chunks;
  for (const auto& sent : batch.chunks) chunks.push_back(sent.chunk.data);
  return ingest(server, text, chunks);
}

ServerAnswer ingest(
    Connection& server,
    const std::string& text,
    const std::vector<std::vector<std::byte>>& chunks) {
  const auto digest =
      storage::fromHexadecimal<std::array<unsigned char, 32>>(storage::sha256(text)).value();
  const auto said = server.query(
      "SELECT palpate.ingest($1, $2, $3)",
      {text, Parameter::bytes(std::as_bytes(std::span(digest))), Parameter::arrayOfBytes(chunks)});
  return answerIn(said.text(0, 0));
}

PushResult push(
    Outbox& outbox, Connection& server, const std::function<void(const ServerAnswer&)>& sent) {
  requireSchema(server);
  auto answer = ingest(server, outbox.lastEventQuery());
  requireSameTrail(outbox, server, answer);
  PushResult pushed{.before = answer.lastEvent, .lastEvent = answer.lastEvent};
  outbox.forEachBatch(answer.lastEvent, [&](const Batch& batch) {
    answer = ingest(server, batch);
    if (!answer.refused.empty()) throwRefusal(answer);
    pushed.lastEvent = answer.lastEvent;
    ++pushed.batches;
    pushed.erased.insert(pushed.erased.end(), answer.erased.begin(), answer.erased.end());
    for (const auto& chunk : batch.chunks) pushed.traceBytes += chunk.chunk.data.size();
    if (sent) sent(answer);
    return true;
  });
  pushed.sessions = outbox.arrivalsBy(pushed.lastEvent);
  return pushed;
}

}  // namespace study::collect

#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "study/collect/exchange/outbox.h"
#include "study/collect/server/connection.h"

namespace study::collect {

/// What became of a push.
struct Pushed {
  std::int64_t before = 0;  ///< the last event that the server had
  std::int64_t have = 0;    ///< and has now
  std::uint64_t batches = 0;
  std::uint64_t traceBytes = 0;
  Outbox::Sessions sessions;
};

/// Sends what the server does not have. Whatever interrupts it, the next push goes on from what the
/// server then says; what is sent twice changes nothing.
/// @param sent  called after each batch; an exception that it throws ends the push.
/// @throws ServerError  @throws UserError  if the server refuses it, in words.
Pushed push(
    Outbox& outbox, Connection& server, const std::function<void(const Answer&)>& sent = {});

/// One call of ingest. @throws ServerError
Answer ingest(Connection& server, const Batch& batch);

/// The same of a batch that is a text already, with the bytes of its chunks.
Answer ingest(
    Connection& server, const std::string& text, const std::vector<std::vector<std::byte>>& chunks);

/// What this station noted of its last push of a study, for when there is no network.
struct NotedPush {
  std::string utc;  ///< empty: it never pushed
  std::int64_t have = 0;
};
NotedPush lastPush(const std::string& study, const std::string& station);
/// Does nothing if the station's list cannot be written: the server is asked anyway.
void notePush(const Outbox& outbox, std::int64_t have, const std::string& utc) noexcept;

}  // namespace study::collect

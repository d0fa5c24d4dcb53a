#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "study/collect/exchange/outbox.h"
#include "study/collect/server/connection.h"
#include "study/model/user_error.h"

namespace study::collect {

/// The result of a push.
struct PushResult {
  std::int64_t before = 0;     ///< the last event that the server had
  std::int64_t lastEvent = 0;  ///< the last event that it has now
  std::uint64_t batches = 0;
  std::uint64_t traceBytes = 0;
  Arrivals sessions;
  std::vector<ErasureReceipt> erased;
};

/// The server refuses what a station sends. what() says why, and what to do.
class PushRefused : public UserError {
 public:
  PushRefused(std::string name, const std::string& what)
      : UserError(what), name_(std::move(name)) {}

  /// the server's name of the refusal: "fork", "revoked"; "older_copy": the server has more events
  /// of this station than this folder
  const std::string& name() const noexcept { return name_; }

 private:
  std::string name_;
};

/// Sends the data that the server does not have. After an interruption, the next push continues
/// from the last event of the server; data that are sent twice change nothing.
/// @param sent  called after each batch; an exception that it throws ends the push.
/// @throws ServerError  (Release) if the server's schema is older or newer than this program's;
///     nothing is sent then. @throws PushRefused
PushResult push(
    Outbox& outbox, Connection& server, const std::function<void(const ServerAnswer&)>& sent = {});

/// Whether the trail that the server has of a station is another one than in this folder: as a
/// refusal ("fork", "older_copy"), or without one if it is the same.
/// @param answer  to Outbox::lastEventQuery()
ServerAnswer disagreementWith(const ServerAnswer& answer, Outbox& outbox);

/// Sends one batch (the server's function ingest). @throws ServerError
ServerAnswer ingest(Connection& server, const Batch& batch);

/// Sends a batch that is text already, with the bytes of its chunks.
ServerAnswer ingest(
    Connection& server, const std::string& text, const std::vector<std::vector<std::byte>>& chunks);

}  // namespace study::collect

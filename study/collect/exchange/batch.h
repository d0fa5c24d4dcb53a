#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "study/session/arrivals.h"
#include "study/storage/event_log.h"
#include "study/storage/keys/sealing_key.h"
#include "study/storage/trace_store.h"
#include "study/storage/transfer/session_facts.h"

// The messages between a station and the server, in JSON (docs/decisions/0054), with the number of
// their format.
namespace study::collect {

inline constexpr int kBatchFormat = 1;

/// The JSON text of a session. Equal rows give equal text on the station, on the server and in
/// every study, so that the SHA-256 can be compared.
std::string asText(const storage::SessionTables& facts);

/// Parses asText(). @throws storage::StorageError  (Damaged) for other text.
storage::SessionTables sessionTablesIn(const std::string& text);

/// A session in its state after its event `lastEvent`.
struct SentSession {
  std::int64_t number = 0;
  std::int64_t lastEvent = 0;
  std::string facts;  ///< asText()
};

/// The content key of a participant, with which the server opens details of the audit trail.
struct SentKey {
  std::string participant;
  storage::SealingKey key;
};

struct SentChunk {
  std::int64_t session = 0;
  storage::TraceChunk chunk;
};

/// The content of one transaction: consecutive events, and the data that belong to them.
struct Batch {
  std::string study;    ///< uuid
  std::string station;  ///< uuid
  std::string after;    ///< hash of the event before the first one; empty: the first one is event 1
  std::vector<storage::StoredEvent> events;
  std::vector<SentSession> sessions;
  std::vector<SentKey> keys;
  std::vector<SentChunk> chunks;
};

/// The JSON text of a batch, without the bytes of its chunks.
std::string asText(const Batch& batch);

/// The server's answer to a batch.
struct ServerAnswer {
  std::int64_t lastEvent = 0;  ///< the server has all events up to this number
  std::string head;            ///< hash of event `lastEvent`, hexadecimal; empty: there is none
  std::string refused;         ///< why the batch was refused ("fork"); empty: it was stored
  std::string detail;
  std::vector<ErasureReceipt> erased = {};  ///< of the batch's sessions
};

/// Parses an answer. @throws storage::StorageError  for other text.
ServerAnswer answerIn(const std::string& text);

/// Whether @p name is that of a refusal, by the server or of an older copy (PushRefused).
bool isRefusal(std::string_view name);

/// The message on a refusal: what it means, and what to do.
std::string wordsFor(const ServerAnswer& answer);

/// The message on a receipt, for the operator and the participant.
std::string wordsFor(const ErasureReceipt& receipt);

}  // namespace study::collect

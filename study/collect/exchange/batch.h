#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "study/session/arrivals.h"
#include "study/storage/event_log.h"
#include "study/storage/keys/sealing_key.h"
#include "study/storage/trace_store.h"
#include "study/storage/transfer/session_facts.h"

// What travels between a station and the server, in JSON (docs/decisions/0054). A program that
// writes another format says so with its number.
namespace study::collect {

inline constexpr int kBatchFormat = 1;

/// The text of one session: the same on the station, on the server and in every study that holds
/// it, so that its SHA-256 tells whether two of them say the same.
std::string asText(const storage::SessionFacts& facts);

/// @throws storage::StorageError  (Damaged) if it is none.
storage::SessionFacts factsIn(const std::string& text);

/// One session, as it stood after its event `asOf`.
struct SentSession {
  std::int64_t number = 0;
  std::int64_t asOf = 0;
  std::string facts;  ///< asText()
};

/// The content key of a participant, for the server to read what the audit trail says.
struct SentKey {
  std::string participant;
  storage::SealingKey key;
};

struct SentChunk {
  std::int64_t session = 0;
  storage::TraceChunk chunk;
};

/// What is sent in one transaction: events that follow each other, and what belongs to them.
struct Batch {
  std::string study;    ///< uuid
  std::string station;  ///< uuid
  std::string after;    ///< hash of the event before the first; empty: there is none
  std::vector<storage::StoredEvent> events;
  std::vector<SentSession> sessions;
  std::vector<SentKey> keys;
  std::vector<SentChunk> chunks;
};

/// All of a batch but the bytes of its chunks.
std::string asText(const Batch& batch);

/// What the server says to a batch.
struct Answer {
  std::int64_t have = 0;     ///< all events up to this one are there
  std::int64_t pending = 0;  ///< sessions whose rows are still to come
  std::string head;          ///< hash of event `have`, hexadecimal; empty: there is none
  std::string refused;       ///< why the batch was not taken ("fork"); empty: it was
  std::string detail;
  std::vector<ErasureReceipt> erased = {};  ///< of the batch's sessions
};

/// @throws storage::StorageError  if it is none.
Answer answerIn(const std::string& text);

/// What a refusal means, and what to do about it.
std::string wordsFor(const Answer& answer);

/// For the person who erases, and for the participant.
std::string wordsFor(const ErasureReceipt& receipt);

}  // namespace study::collect

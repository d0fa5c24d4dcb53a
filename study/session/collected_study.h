#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "study/model/clock.h"
#include "study/model/ids.h"
#include "study/session/study.h"
#include "study/storage/blinding_secret.h"
#include "study/storage/event_log.h"
#include "study/storage/keys/sealing_key.h"
#include "study/storage/trace_store.h"
#include "study/storage/transfer/event_spool.h"
#include "study/storage/transfer/session_facts.h"

namespace study {

/// Builds one study from the data that its stations recorded: an ordinary study folder that can be
/// verified, evaluated and exported. Its sessions cannot be continued.
///
/// Conditions and measurements are sealed with the collected study's own key. Sessions get new
/// numbers. The audit trails of the stations are appended one after another to a new trail, whose
/// first event lists them with the hash of the last event of each. The caller has checked the
/// stations' trails against their hashes and signatures.
class CollectedStudy {
 public:
  /// The study that the stations belong to.
  struct Origin {
    std::string uuid;
    std::uint64_t seed = 0;
    storage::BlindingSecret secret;  ///< the secrets of the stations are derived from it
    std::string createdUtc;
    std::vector<protocols::LoadedProtocol> protocols;  ///< all versions, the oldest first
  };

  /// The audit trail of one station, with the numbers that it has there.
  struct Trail {
    Station station;
    std::int64_t events = 0;
    std::string head;  ///< the hash of its last event, hexadecimal
  };

  /// Makes the folder under a temporary name beside @p folder. finish() renames it; without that
  /// the destructor removes it.
  /// @throws storage::StorageError  if there is such a folder, or it cannot be made.
  CollectedStudy(std::filesystem::path folder, Clock& clock, const Origin& origin);
  ~CollectedStudy();
  CollectedStudy(const CollectedStudy&) = delete;
  CollectedStudy& operator=(const CollectedStudy&) = delete;

  /// Adds one session of the station. @param number  its number at the station
  void add(std::int64_t number, const storage::SessionTables& facts);
  /// @param chunk  unsealed (storage::opened())
  void add(std::int64_t number, const storage::TraceChunk& chunk);
  /// Adds the content key of a participant of the station.
  void addKey(const std::string& participant, const storage::SealingKey& key);
  /// Adds the trail of a station, with its erasures. Call it after all sessions of this station
  /// were added, and before those of the next one.
  void add(const Trail& trail, std::vector<storage::StoredEvent> events);

  /// Writes and signs the trail, and renames the folder to its final name.
  /// @param reason  why the study was collected
  void finish(const std::string& reason);

 private:
  struct Files;
  void noteErasure(const storage::StoredEvent& event);
  /// Writes the events of all stations to the collected study's trail.
  void appendTrail(const std::string& reason);
  /// The event with its detail unsealed. @param own  the participant's content key
  storage::StoredEvent withDetailUnsealed(
      const storage::StoredEvent& event, const storage::SealingKey& own) const;

  std::filesystem::path target_;
  std::filesystem::path folder_;
  Clock& clock_;
  storage::BlindingSecret secret_;
  std::string protocolName_;
  std::unique_ptr<Files> files_;
  std::map<std::int64_t, SessionId> sessions_;  ///< sessions of the present station, by their
                                                ///< number at the station
  std::size_t sessionCount_ = 0;
  std::vector<Trail> trails_;
  std::unique_ptr<storage::EventSpool> events_;  ///< events with the new numbers of their sessions
  /// Index in events_ of the last event of each session; at std::nullopt, of the last event without
  /// a session.
  std::map<std::optional<std::int64_t>, std::size_t> lastEventOf_;
};

}  // namespace study

#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "study/collect/exchange/batch.h"
#include "study/collect/server/connection.h"
#include "study/session/collected_study.h"
#include "study/storage/event_log.h"
#include "study/storage/trace_store.h"
#include "study/storage/transfer/session_facts.h"

namespace study::collect {

/// A station as the server has it.
struct StationRow {
  std::int64_t id = 0;
  Station station;
  std::string key;  ///< its public key, as it was enrolled
  std::int64_t have = 0;
};

/// A session's row as the server has it. Nothing of it is checked yet.
struct SessionOnServer {
  std::int64_t number = 0;
  std::int64_t asOf = 0;
  std::string sha256;
  std::string facts;
};

/// As long as it exists, all is read as it was at one moment.
class Snapshot {
 public:
  explicit Snapshot(Connection& server);
  ~Snapshot();
  Snapshot(const Snapshot&) = delete;
  Snapshot& operator=(const Snapshot&) = delete;

 private:
  Connection& server_;
};

/// Reads a study from the server, as a role that may unblind it.
class ServerReader {
 public:
  /// @param name  of the study; empty: the only one. @param reason  kept on the server
  /// @throws UserError  if there is no reason, or no such study. @throws ServerError
  ServerReader(Connection& server, const std::string& name, const std::string& reason);

  /// @throws storage::StorageError  (Damaged) if secret or protocols are not what was stored.
  CollectedStudy::Origin origin();
  std::vector<StationRow> stations();
  std::vector<storage::StoredEvent> events(const StationRow& station);
  /// Calls @p take with each session, in the order of their numbers.
  void forEachSession(
      const StationRow& station, const std::function<void(const SessionOnServer&)>& take);
  std::vector<SentKey> keys(const StationRow& station);
  std::vector<storage::TraceChunk> chunks(const StationRow& station, std::int64_t session);

 private:
  std::vector<protocols::LoadedProtocol> protocols();

  Connection& server_;
  std::string ticket_;
};

}  // namespace study::collect

#pragma once

#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "study/collect/exchange/batch.h"
#include "study/collect/server/connection.h"
#include "study/session/collected_study.h"
#include "study/storage/event_log.h"
#include "study/storage/trace_store.h"
#include "study/storage/transfer/session_facts.h"

namespace study::collect {

/// A station in the server's tables.
struct StationRow {
  std::int64_t id = 0;
  Station station;
  std::string key;  ///< its public key, as it was enrolled
  std::int64_t lastEvent = 0;
};

/// A session in the server's tables. It is not verified yet.
struct SessionOnServer {
  std::int64_t number = 0;
  std::int64_t lastEvent = 0;
  std::string sha256;
  std::string facts;
  bool hasSamples = false;
};

/// A read transaction: while this object exists, all queries see the server in the state of one
/// moment.
class Snapshot {
 public:
  explicit Snapshot(Connection& server);
  ~Snapshot();
  Snapshot(const Snapshot&) = delete;
  Snapshot& operator=(const Snapshot&) = delete;

 private:
  Connection& server_;
};

/// Reads a study from the server; the connection's role must be allowed to unblind it. Several
/// threads may read at a time; their queries wait for each other.
class ServerReader {
 public:
  /// @param name  of the study; empty: the only one. @param reason  noted on the server
  /// @throws UserError  if there is no reason, or no such study. @throws ServerError
  ServerReader(Connection& server, const std::string& name, const std::string& reason);

  /// @throws storage::StorageError  (Damaged) if the secret has not its length, a protocol differs
  ///     from its hash, or there is no protocol.
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
  Rows query(const std::string& statement, const std::vector<Parameter>& parameters);

  std::mutex queryMutex_;  ///< a connection takes one query at a time
  Connection& server_;
  std::string ticket_;
};

}  // namespace study::collect

#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "protocols/model/loaded_protocol.h"
#include "study/bench/collect/work_time.h"
#include "study/collect/server/private_server.h"
#include "study/session/study.h"
#include "study/storage/event_log.h"
#include "study/storage/transfer/session_facts.h"

namespace study::bench {

/// The amounts of data that a station sent, and the times of the parts of the transfer.
struct StationPush {
  std::int64_t answers = 0;
  std::int64_t events = 0;
  std::uint64_t traceBytes = 0;
  WorkTime reading;    ///< reading its folder and writing batches
  WorkTime ingesting;  ///< ingest() of events and sessions
  WorkTime traces;     ///< ingest() of samples

  StationPush& operator+=(const StationPush& other) {
    answers += other.answers;
    events += other.events;
    traceBytes += other.traceBytes;
    reading += other.reading;
    ingesting += other.ingesting;
    traces += other.traces;
    return *this;
  }
};

/// A study on a private server, and stations that send sessions of simulated participants to it:
/// one that sends samples, and any number of others that send its sessions again without samples.
/// Each station has its own account, folder, audit trail and signature.
class ManyStations {
 public:
  /// The label of the station that sends samples.
  static constexpr const char* kRecorded = "recorded";

  /// @param folder  for the stations' folders; each exists only while its station sends
  /// @param participants  number at the station that sends samples
  ManyStations(
      const collect::PrivateServer& postgres, std::filesystem::path folder, int participants);

  const protocols::LoadedProtocol& protocol() const noexcept { return protocol_; }
  /// The transfer of the station that sends samples.
  const StationPush& recorded() const noexcept { return recorded_; }

  /// Adds a station at a new site, which sends at least @p answers answers.
  /// @param number  number of the station, from 1
  StationPush add(int number, std::int64_t answers);

  /// The label of station @p number.
  static std::string labelOf(int number);

 private:
  /// A recorded session, for sending it again from other stations.
  struct RecordedSession {
    storage::SessionTables facts;
    std::vector<storage::StoredEvent> events;
  };

  /// Creates a station, calls @p work to fill its folder, and sends everything.
  StationPush run(const std::string& label, const std::function<void(Study&)>& work) const;
  /// Simulates the sessions of the station that sends samples.
  void record(Study& study, int participants);
  /// Adds recorded sessions to @p study until it has at least @p answers answers.
  void repeat(Study& study, const std::string& label, std::int64_t answers) const;

  const collect::PrivateServer& postgres_;
  std::filesystem::path folder_;
  protocols::LoadedProtocol protocol_;
  std::vector<RecordedSession> sessions_;
  StationPush recorded_;
};

}  // namespace study::bench

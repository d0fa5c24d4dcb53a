#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "study/collect/exchange/batch.h"
#include "study/session/arrivals.h"
#include "study/session/backup.h"
#include "study/session/study.h"

namespace study::collect {

/// The data that a station has for the server: a snapshot of the study's folder at construction.
/// The events of the audit trail are numbered without gaps, each in the transaction of its change,
/// so the last number that the server has determines what is to be sent. Nothing is marked as sent.
class Outbox {
 public:
  /// @throws UserError  if the folder is no station's. @throws storage::StorageError
  Outbox(const std::filesystem::path& folder, Clock& clock);

  const std::string& study() const noexcept { return study_.uuid(); }
  const Station& station() const noexcept { return study_.station(); }
  std::int64_t lastEvent() const noexcept { return lastEvent_; }

  /// The hash of an event, hexadecimal; empty for event 0.
  std::string hashOf(std::int64_t event);

  /// The numbers of all sessions, and of the sessions that have arrived at a server that has all
  /// events up to @p event.
  Arrivals arrivalsBy(std::int64_t event) { return study::arrivalsBy(study_, event); }

  /// The number of heads of the audit trail that this station has noted and this folder lacks. If
  /// there are any, it is an older copy, and what is recorded in it is not signed until that is
  /// accepted (recordRestoredCopy()).
  std::size_t missingHeads() { return headsMissingIn(study_); }

  /// The largest content of one batch. A batch whose transaction fails is sent again.
  struct Limits {
    std::int64_t events = 2000;
    std::size_t traceBytes = std::size_t{8} * 1024 * 1024;
  };
  void setLimits(const Limits& limits) noexcept { limits_ = limits; }

  /// An empty batch, which the server answers with its last event.
  Batch lastEventQuery();

  /// A batch of the single event @p event, with which the server says whether it has the same
  /// event.
  Batch eventQuery(std::int64_t event);

  /// Calls @p send with all data after the event @p after, in order, in batches within the limits.
  /// Stops if @p send returns false.
  void forEachBatch(std::int64_t after, const std::function<bool(const Batch&)>& send);

 private:
  Batch emptyBatch(std::int64_t after);
  void addSessions(Batch& batch);
  bool sendChunks(const Batch& events, const std::function<bool(const Batch&)>& send);

  Study study_;
  std::int64_t lastEvent_ = 0;
  Limits limits_;
};

}  // namespace study::collect

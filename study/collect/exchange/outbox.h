#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "study/collect/exchange/batch.h"
#include "study/session/arrivals.h"
#include "study/session/study.h"

namespace study::collect {

/// What a station has for the server: the study's folder itself, as it was when this was made. The
/// audit trail numbers everything without a gap, in the transaction in which it happened; nothing
/// is marked as sent. What is to be sent follows from the last number that the server has.
class Outbox {
 public:
  /// @throws UserError  if the folder is no station's. @throws storage::StorageError
  Outbox(const std::filesystem::path& folder, Clock& clock);

  const std::string& study() const noexcept { return study_.uuid(); }
  const Station& station() const noexcept { return study_.station(); }
  std::int64_t lastEvent() const noexcept { return last_; }

  /// Hexadecimal; empty for event 0.
  std::string hashOf(std::int64_t event);

  /// How many of the sessions have all that the server needs in events up to @p event.
  Arrivals arrivalsBy(std::int64_t event) { return study::arrivalsBy(study_, event); }

  /// How much is sent in one transaction: what is lost on the way is sent again.
  struct Limits {
    std::int64_t events = 2000;
    std::size_t traceBytes = std::size_t{8} * 1024 * 1024;
  };
  void setLimits(const Limits& limits) noexcept { limits_ = limits; }

  /// An empty batch: it asks what the server has.
  Batch question();

  /// One event alone: whether the server has the same.
  Batch sample(std::int64_t event);

  /// Calls @p send with everything after the event @p after, in order, in parts that fit into a
  /// transaction. Stops if it returns false.
  void forEachBatch(std::int64_t after, const std::function<bool(const Batch&)>& send);

 private:
  Batch emptyBatch(std::int64_t after);
  void addSessions(Batch& batch);
  bool sendChunks(const Batch& events, const std::function<bool(const Batch&)>& send);

  Study study_;
  std::int64_t last_ = 0;
  Limits limits_;
};

}  // namespace study::collect

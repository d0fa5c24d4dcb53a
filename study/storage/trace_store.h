#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "study/model/ids.h"
#include "study/storage/database.h"

namespace study::storage {

/// What is kept of a tick: 28 bytes, little-endian, in this order (layout 1).
struct TraceSample {
  std::uint32_t tick = 0;          ///< of the trial
  float travel = 0.0F;             ///< [device's travel unit]
  float velocity = 0.0F;           ///< [device's travel unit / s]
  float desired = 0.0F;            ///< what the scene asked for [N]
  float force = 0.0F;              ///< what the device was told [N]
  float lateness = 0.0F;           ///< [µs]
  std::uint8_t status = 0;         ///< haptics::devices::DeviceStatus
  std::uint8_t interventions = 0;  ///< haptics::engine::ForceLimiter::Intervention
  std::uint8_t marks = 0;          ///< haptics::engine::TickSample::Mark
  std::uint8_t landmark = 0;       ///< haptics::models::CutDetector::Event
};

/// traces.db: chunks of about a second, each complete in itself with its hash; a power cut costs
/// the one under way. A connection belongs to one thread.
class TraceStore {
 public:
  explicit TraceStore(Database database) : database_(std::move(database)) {}

  /// One transaction; a chunk that is there already is not written again. @throws StorageError
  void add(const VisitKey& visit, int number, const std::vector<TraceSample>& samples);

  /// All samples of a trial, in order. @throws StorageError  (Damaged) if a chunk is not what was
  /// written.
  std::vector<TraceSample> read(const VisitKey& visit) const;

  std::int64_t sampleCount(const VisitKey& visit) const;

  /// Of all chunks of a trial in their order, for the audit trail: a chunk that is taken away, put
  /// elsewhere or written anew gives another one.
  std::string digest(const VisitKey& visit) const;

  /// The visits that have a trace.
  std::vector<VisitKey> visits() const;

  Database& database() noexcept { return database_; }

 private:
  void insert(const VisitKey& visit, int number, const std::vector<TraceSample>& samples);
  bool holds(const VisitKey& visit, int number, const std::vector<TraceSample>& samples) const;

  Database database_;
};

}  // namespace study::storage

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "study/model/ids.h"
#include "study/storage/database.h"

namespace study::storage {

/// The stored part of a tick: 36 bytes, little-endian, in this order (layout 2). A chunk without
/// torques is stored without the last two members, in 28 bytes per sample; release 0.1 stored all
/// chunks this way (layout 1).
struct TraceSample {
  std::uint32_t tick = 0;          ///< number of the tick in the trial
  float travel = 0.0F;             ///< [device's travel unit]
  float velocity = 0.0F;           ///< [device's travel unit / s]
  float desired = 0.0F;            ///< desired by the scene [N]
  float force = 0.0F;              ///< sent to the device after limiting [N]
  float lateness = 0.0F;           ///< of the loop's wake-up [µs]
  std::uint8_t status = 0;         ///< haptics::devices::DeviceStatus
  std::uint8_t interventions = 0;  ///< haptics::engine::ForceLimiter::Intervention
  std::uint8_t marks = 0;          ///< haptics::engine::TickSample::Mark
  std::uint8_t landmark = 0;       ///< haptics::models::CutDetector::Event
  float desiredTorque = 0.0F;      ///< desired by the scene, about the tool's axis [N·m]
  float torque = 0.0F;             ///< sent to the device after limiting [N·m]
};

/// A chunk as a row of the table.
struct TraceChunk {
  int step = 0;
  int attempt = 1;
  std::int64_t number = 0;
  std::int64_t samples = 0;
  std::int64_t layout = 0;
  std::vector<std::byte> data;
  std::vector<std::byte> hash;
};

/// traces.db: the samples of a trial in chunks of about one second, each complete and with a hash.
/// Chunks that are sealed with the study's key have layout 3 or 4 in place of 1 or 2. A power
/// failure loses only the chunk in progress. A connection may be used by one thread only.
class TraceStore {
 public:
  explicit TraceStore(Database database) : database_(std::move(database)) {}

  /// IfThereIsAKey: if the database has the study's key, traces that reveal the condition are
  /// sealed.
  enum class Sealing { IfThereIsAKey, Never };

  /// Stores a chunk in one transaction. Does nothing if the same chunk is stored already.
  /// @throws StorageError
  void add(
      const VisitKey& visit,
      int number,
      const std::vector<TraceSample>& samples,
      Sealing sealing = Sealing::IfThereIsAKey);

  /// All samples of a trial, in order.
  /// @throws StorageError  (Damaged) if a chunk differs from what was written; or if the key is
  ///     needed but not available.
  std::vector<TraceSample> read(const VisitKey& visit) const;

  /// The number of samples of a trial that are stored undamaged; needs no key.
  /// @throws StorageError  (Damaged) as read()
  std::int64_t intactSampleCount(const VisitKey& visit) const;

  /// The number of stored samples of a trial, without checking them.
  std::int64_t sampleCount(const VisitKey& visit) const;

  /// A hash of all chunks of a trial in order, for the audit trail. Removing, moving or rewriting a
  /// chunk changes it.
  std::string digest(const VisitKey& visit) const;

  /// The visits that have a trace.
  std::vector<VisitKey> visits() const;

  Database& database() noexcept { return database_; }

 private:
  /// The chunks of a trial. @throws StorageError  (Damaged) as read()
  std::vector<TraceChunk> intactChunks(const VisitKey& visit) const;
  /// Throws StorageError (Damaged) that names the second of the trial.
  [[noreturn]] void failAt(std::int64_t chunk) const;
  /// Whether this chunk is stored.
  bool holds(const VisitKey& visit, const TraceChunk& chunk) const;

  Database database_;
};

/// The chunks of a visit, in order. @param traces  traces.db
std::vector<TraceChunk> chunksOf(const Database& traces, const VisitKey& visit);

/// Inserts a chunk, inside the caller's transaction. @throws StorageError  if its hash does not
/// match.
void addChunk(Database& traces, SessionId session, const TraceChunk& chunk);

/// A chunk of a session, unsealed; an unsealed chunk is returned unchanged.
/// @param key  the key with which the chunk is sealed
/// @throws StorageError  (Damaged) if the chunk was sealed with another key or for another place.
TraceChunk opened(const TraceChunk& chunk, SessionId session, const SealingKey& key);

/// Seals @p chunk, which is unsealed, with @p key for the session @p session.
TraceChunk sealed(const TraceChunk& chunk, SessionId session, const SealingKey& key);

}  // namespace study::storage

#pragma once

#include <set>
#include <string_view>
#include <vector>

#include "study/model/ids.h"
#include "study/model/trial_record.h"
#include "study/storage/database.h"
#include "study/storage/fact_rows.h"

namespace study::storage {

/// The columns of trial and of cut that are the same in every file.
inline constexpr std::string_view kTrialColumns =
    "step, attempt, device, ending, verdict, verdict_reason, force_unit, travel_unit, duration_s, "
    "ticks, nominal_rate_hz, achieved_rate_hz, lateness_p50_us, lateness_p99_us, lateness_max_us, "
    "late_ticks, lost_samples, invalid_ticks, saturated_s, slewed_s, undefined_s, contact_s, "
    "largest_force_n, cuts, trace_samples";
inline constexpr std::string_view kCutColumns =
    "step, attempt, number, interception_travel, interception_n, yield_travel, yield_n, "
    "bottom_out_travel, bottom_out_n, opening_travel, opening_n, peak_n";

/// Trials and their cuts in the open, whether or not they are sealed in a file.
struct TrialRows {
  std::vector<FactRow> trials;
  std::vector<FactRow> cuts;
};

/// The tables of trials and their cuts.
class TrialRepository {
 public:
  explicit TrialRepository(Database& database) : database_(database) {}

  /// Writes a trial inside the caller's transaction. What was measured is sealed if the database
  /// has the study's key, but for simulated sessions.
  void add(const VisitKey& visit, const TrialRecord& record);

  /// Writes trials of another file. The same rows are sealed to the same bytes, at the same place
  /// with the same key.
  /// @param key  nullptr: nothing is sealed
  /// @param open  trials that are not sealed with it either
  /// @throws StorageError  if a row is not as this program knows it.
  void add(
      SessionId session,
      const TrialRows& rows,
      const SealingKey* key,
      const std::set<VisitKey>& open = {});

 private:
  bool isSimulated(SessionId session) const;
  void addSealed(
      const VisitKey& visit,
      const FactRow& trial,
      const std::vector<FactRow>& cuts,
      const SealingKey& key);

  Database& database_;
};

/// The trials of a session and their cuts, in order.
/// @throws StorageError  if a trial is sealed, and the key is not here or another.
TrialRows trialsOf(const Database& study, SessionId session);

}  // namespace study::storage

#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "study/model/ids.h"
#include "study/model/trial_record.h"
#include "study/storage/database.h"
#include "study/storage/named_rows.h"

namespace study::storage {

/// The columns of trial and of cut that do not depend on the file (no row numbers).
inline constexpr std::string_view kTrialColumns =
    "step, attempt, device, ending, verdict, verdict_reason, force_unit, travel_unit, duration_s, "
    "ticks, nominal_rate_hz, achieved_rate_hz, lateness_p50_us, lateness_p99_us, lateness_max_us, "
    "late_ticks, lost_samples, invalid_ticks, saturated_s, slewed_s, undefined_s, contact_s, "
    "largest_force_n, cuts, trace_samples";
inline constexpr std::string_view kCutColumns =
    "step, attempt, number, interception_travel, interception_n, yield_travel, yield_n, "
    "bottom_out_travel, bottom_out_n, opening_travel, opening_n, peak_n";

/// The columns that are sealed, in the order in which they are written to the sealed text.
inline constexpr std::string_view kMeasuredColumns =
    "verdict, verdict_reason, duration_s, ticks, nominal_rate_hz, achieved_rate_hz, "
    "lateness_p50_us, lateness_p99_us, lateness_max_us, late_ticks, lost_samples, invalid_ticks, "
    "saturated_s, slewed_s, undefined_s, contact_s, largest_force_n, cuts";
inline constexpr std::string_view kMeasuredColumnsOfCut =
    "interception_travel, interception_n, yield_travel, yield_n, bottom_out_travel, bottom_out_n, "
    "opening_travel, opening_n, peak_n";

/// What is before the name of a column of cut @p number in the sealed text of a trial.
inline std::string prefixOfCut(std::int64_t number) {
  return "cut_" + std::to_string(number) + "_";
}

/// Trials and their cuts, unsealed, even if they are sealed in a file.
struct UnsealedTrialRows {
  std::vector<NamedRow> trials;
  std::vector<NamedRow> cuts;
};

/// The tables of trials and their cuts.
class TrialRepository {
 public:
  explicit TrialRepository(Database& database) : database_(database) {}

  /// Inserts a trial inside the caller's transaction. If the database has the study's key, the
  /// measured values are sealed, except for simulated sessions.
  void add(const VisitKey& visit, const TrialRecord& record);

  /// The names of the devices on which a session's trials were felt, each once.
  std::vector<std::string> devices(SessionId session) const;

  /// Inserts trials from another file. Equal rows are sealed to equal bytes for the same place and
  /// key.
  /// @param key  nullptr: measured values are not sealed
  /// @param open  trials that are not sealed even with a key
  /// @throws StorageError  if a row is not in the form that this program knows.
  void add(
      SessionId session,
      const UnsealedTrialRows& rows,
      const SealingKey* key,
      const std::set<VisitKey>& open = {});

 private:
  bool isSimulated(SessionId session) const;
  void addSealed(
      const VisitKey& visit,
      const NamedRow& trial,
      const std::vector<NamedRow>& cuts,
      const SealingKey& key);

  Database& database_;
};

/// The trials of a session and their cuts, unsealed, in order.
/// @throws StorageError  if a trial is sealed and the key is missing or wrong.
UnsealedTrialRows trialsOf(const Database& study, SessionId session);

}  // namespace study::storage

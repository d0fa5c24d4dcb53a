#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "study/model/ids.h"
#include "study/model/run_mode.h"
#include "study/model/session_plan.h"
#include "study/model/session_state.h"
#include "study/storage/database.h"

namespace study::storage {

class Statement;

/// The state of a participant's place in the design.
enum class SlotState {
  Reserved,  ///< by a participant who has begun
  Consumed,  ///< by a participant who has finished
  Released,  ///< free for another participant
};

/// A session as a row of the table.
struct SessionRow {
  SessionId id{};
  std::string participant;  ///< code
  int number = 1;           ///< number among the participant's sessions, from 1
  ProtocolId protocol{};
  RunMode runMode = RunMode::Live;
  std::string cohort;
  std::string language;
  std::string site = {};     ///< empty in a study of one machine
  std::string station = {};  ///< label
  std::int64_t slot = 0;
  SlotState slotState = SlotState::Reserved;
  SessionState state = SessionState::Enrolled;
  int step = 0;     ///< index of the present step, from 0
  int attempt = 1;  ///< at the present step, from 1
  std::string startedUtc;
  std::optional<std::string> endedUtc;
  std::optional<std::string> endReason;

  bool operator==(const SessionRow&) const = default;
};

/// How a visit ended; Open if it has not ended.
enum class VisitStatus { Open, Finished, Skipped, Repeated, BrokenOff };

/// The tables of participants, sessions, steps and visits. All functions that write must be called
/// inside the caller's transaction.
class SessionRepository {
 public:
  explicit SessionRepository(Database& database) : database_(database) {}

  /// The lowest free place of a design. Each station has its own places.
  /// @param versions  those of the protocol that draw the same orders
  std::int64_t freeSlot(
      const std::vector<ProtocolId>& versions,
      RunMode mode,
      const std::string& cohort,
      const std::string& station = {}) const;

  /// The next unused participant code: P001, PILOT-001 or SIM-001; oslo_P001 at the station "oslo".
  std::string freeCode(RunMode mode, const std::string& station = {}) const;
  bool hasParticipant(const std::string& code) const;
  /// When the participant was enrolled; empty if there is no participant with that code.
  std::string enrolledUtc(const std::string& code) const;

  /// Inserts the participant (if new), session, steps and allocation; sets the session's id and
  /// number.
  /// @throws StorageError  if the code belongs to a participant of another cohort or run mode.
  void add(SessionRow& session, const std::vector<Step>& steps, const std::string& appVersion);
  void update(const SessionRow& session);

  SessionRow load(SessionId id) const;
  std::vector<SessionRow> all() const;

  /// Begins a visit.
  void openVisit(const VisitKey& visit, const std::string& utc);
  /// Closes an open visit; a visit that has ended is not changed.
  void closeVisit(
      const VisitKey& visit, VisitStatus status, const std::string& utc, const std::string& reason);
  /// The number of visits to a step.
  int attempts(SessionId session, int step) const;
  /// The status of a visit; Open for a step that was never begun.
  VisitStatus statusOf(const VisitKey& visit) const;
  /// Marks the visits to @p step and later steps as repeated, so that results ignore them. Visits
  /// that were broken off are not changed.
  void markRepeated(SessionId session, int step, const std::string& utc, const std::string& reason);

  /// Whether all conditions of the session are sealed with the study's key.
  bool isSealed(SessionId session) const;

 private:
  std::int64_t participantId(const SessionRow& session);
  void addSteps(const SessionRow& session, const std::vector<Step>& steps);

  Database& database_;
};

/// The statement for sessions, to which a condition and an order may be added. Its columns are
/// those that sessionIn() reads, and @p moreColumns, which begin with a comma. A file of an older
/// format that was opened for reading only has no columns of stations.
std::string selectSessions(const Database& database, const std::string& moreColumns = {});
inline constexpr int kSessionColumnCount = 17;
SessionRow sessionIn(const Statement& row);

/// Stores the condition of a step.
/// @param key  seals the condition; nullptr: it is stored unsealed
void addCondition(
    Database& study,
    SessionId session,
    std::int64_t step,
    const std::string& condition,
    const SealingKey* key);

/// The stored condition of every step that has one, with the index of the step.
/// @throws StorageError  if conditions are sealed and the key is not available.
std::vector<std::pair<int, std::string>> allocationOf(const Database& study, SessionId session);

/// The column of the table allocation AS a with sealed conditions; NULL in a file of an older
/// format that was opened for reading only.
const char* sealedColumn(const Database& database);

std::string_view nameOf(SlotState state) noexcept;
std::string_view nameOf(VisitStatus status) noexcept;
std::optional<VisitStatus> visitStatusNamed(std::string_view name) noexcept;

/// Returns the enumerator in @p value, which was looked up by the stored @p name.
/// @throws StorageError  (Damaged) if @p value is std::nullopt, because this program does not know
///     the name.
template <typename Value>
Value requireKnown(const std::optional<Value>& value, const std::string& name) {
  if (value) return *value;
  throw StorageError(
      "The study holds '" + name + "', which this program does not know. Is it damaged?",
      StorageError::Kind::Damaged);
}

}  // namespace study::storage

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

enum class SlotState {
  Reserved,  ///< held by somebody who has begun
  Consumed,  ///< by somebody who has finished
  Released,  ///< free for another
};

/// A session as it stands in its row.
struct SessionRow {
  SessionId id{};
  std::string participant;  ///< code
  int number = 1;           ///< of this participant's sessions
  ProtocolId protocol{};
  RunMode runMode = RunMode::Live;
  std::string cohort;
  std::string language;
  std::int64_t slot = 0;
  SlotState slotState = SlotState::Reserved;
  SessionState state = SessionState::Enrolled;
  int step = 0;
  int attempt = 1;
  std::string startedUtc;
  std::optional<std::string> endedUtc;
  std::optional<std::string> endReason;

  bool operator==(const SessionRow&) const = default;
};

/// How a visit ended, or that it has not.
enum class VisitStatus { Open, Finished, Skipped, Repeated, BrokenOff };

/// The tables of participants, sessions, their steps and visits. Everything that writes does so
/// inside the caller's transaction.
class SessionRepository {
 public:
  explicit SessionRepository(Database& database) : database_(database) {}

  /// The lowest place of a design that nobody holds.
  std::int64_t freeSlot(ProtocolId protocol, RunMode mode, const std::string& cohort) const;

  /// A code that nobody has: P001, or PILOT-001, SIM-001.
  std::string freeCode(RunMode mode) const;
  bool hasParticipant(const std::string& code) const;

  /// Writes participant (if new), session, steps and allocation; fills in the id and the number.
  /// @throws StorageError  if the code belongs to somebody of another cohort or run mode.
  void add(SessionRow& session, const std::vector<Step>& steps, const std::string& appVersion);
  void update(const SessionRow& session);

  SessionRow load(SessionId id) const;
  std::vector<SessionRow> all() const;
  bool hasLiveSession() const;

  void openVisit(const VisitKey& visit, const std::string& utc);
  /// Only a visit that is open; how another one ended stays.
  void closeVisit(
      const VisitKey& visit, VisitStatus status, const std::string& utc, const std::string& reason);
  /// How often a step has been begun.
  int attempts(SessionId session, int step) const;
  /// How a visit stands; a step that was never begun is open.
  VisitStatus statusOf(const VisitKey& visit) const;
  /// Whatever was finished from @p step on does not count any more: it is done again.
  void markRepeated(SessionId session, int step, const std::string& utc, const std::string& reason);

  /// The condition of every step that has one, as it was drawn.
  std::vector<std::pair<int, std::string>> allocation(SessionId session) const;

 private:
  std::int64_t participantId(const SessionRow& session);
  void addSteps(SessionId session, const std::vector<Step>& steps);

  Database& database_;
};

std::string_view nameOf(SlotState state) noexcept;
std::string_view nameOf(VisitStatus status) noexcept;
std::optional<VisitStatus> visitStatusNamed(std::string_view name) noexcept;

/// What a stored name stands for, which @p value holds. @throws StorageError  (Damaged) where it is
/// nothing that this program knows.
template <typename Value>
Value known(const std::optional<Value>& value, const std::string& name) {
  if (value) return *value;
  throw StorageError(
      "The study holds '" + name + "', which this program does not know. Is it damaged?",
      StorageError::Kind::Damaged);
}

}  // namespace study::storage

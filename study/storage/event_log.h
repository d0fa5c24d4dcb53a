#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/message.h"
#include "study/model/clock.h"
#include "study/model/ids.h"
#include "study/storage/database.h"

namespace study::storage {

enum class Actor { Participant, Operator, Program };

/// Something that happened.
struct Event {
  std::optional<VisitKey> visit;
  Moment when;
  Actor actor = Actor::Program;
  std::string kind;    ///< "answered", "finished_step", "note"
  std::string detail;  ///< one value or somebody's own words; may be empty
  /// Where a kind has more to say, by name: {"times", 3}, {"duration_s", 0.12}. Release 0.1 wrote a
  /// sentence instead, which is then in @ref detail (docs/decisions/0019).
  base::NamedArguments values = {};

  /// One of the values; nothing where it is not there.
  const base::Argument* value(std::string_view name) const noexcept;
};

/// What the event says besides its kind, in English.
std::string describe(const Event& event);

/// Everything that happened in a study, in order; only ever added to.
///
/// Every event carries a hash of itself and of the one before it (BLAKE2b-256): a line that is
/// changed, removed or slipped in shows, which SQLite's own check of a file does not (of 3,000
/// flipped bits it missed 1,571 that changed content). And it carries a hash of what the tables
/// said about its session by then, so that a row changed behind the program's back shows as well.
class EventLog {
 public:
  explicit EventLog(Database& database) : database_(database) {}

  /// Inside the caller's transaction, after everything else in it: the event vouches for what the
  /// tables say by then. @throws StorageError  also if the detail is no text.
  void append(const Event& event);

  /// What the chain ends with at present; empty before the first event.
  std::vector<std::byte> head() const;

  /// The number of the last event; 0 before the first.
  std::int64_t last() const;

  /// Whether the event that ended the chain with @p head has arrived.
  bool holds(const std::vector<std::byte>& head) const;

  /// The content hash in the last event of a session, or of the study itself; empty where format 1
  /// wrote it, nothing where there is no event.
  std::optional<std::vector<std::byte>> vouchedFor(std::optional<SessionId> session) const;

  /// Events of one session, or of all, in order.
  std::vector<Event> read(std::optional<SessionId> session = std::nullopt) const;

  /// The first place at which the chain is broken, in words; nothing where it holds.
  std::optional<std::string> firstBreak() const;

 private:
  Database& database_;
};

std::string_view nameOf(Actor actor) noexcept;

}  // namespace study::storage

#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/message.h"
#include "study/model/clock.h"
#include "study/model/event_kind.h"
#include "study/model/ids.h"
#include "study/storage/database.h"
#include "study/storage/identity_store.h"

namespace study::storage {

class Statement;

enum class Actor { Participant, Operator, Program };

/// An event of the audit trail.
struct Event {
  std::optional<VisitKey> visit;
  Moment when;
  Actor actor = Actor::Program;
  EventKind kind = EventKind::Unknown;
  std::string detail;  ///< one value, or a text that a person entered; may be empty
  /// The named values of kinds that have several: {"times", 3}, {"duration_s", 0.12}. Release 0.1
  /// wrote a sentence instead, which is then in @ref detail (docs/decisions/0019).
  base::NamedArguments values = {};
  std::string unknownName = {};  ///< name of the kind if only a later release knows it
  /// The detail cannot be read any more, because its participant was erased and the key destroyed.
  bool isErased = false;
  /// The detail reveals the condition and is sealed with the study's key, which is not available on
  /// this computer.
  bool isSealed = false;

  /// "answered", "finished_step", "note": the kind as it is stored.
  std::string_view name() const noexcept;

  /// The value named @p name; nullptr if there is none.
  const base::Argument* value(std::string_view name) const noexcept;
};

/// An event as a row of the table. Its detail may be sealed.
struct StoredEvent {
  std::int64_t seq = 0;  ///< number of the event in the trail, from 1
  std::optional<std::int64_t> session;
  std::optional<std::int64_t> step;
  std::optional<std::int64_t> attempt;
  std::string utc;
  std::int64_t monotonic = 0;  ///< [ns]
  std::string actor;
  std::string kind;
  std::string detail;
  std::vector<std::byte> content;  ///< hash of the tables' content; empty in rows of format 1
  std::vector<std::byte> sealed;   ///< the sealed detail; empty if the detail is not sealed
  std::vector<std::byte> hash;     ///< of this event and the hash of the event before it
};

/// The columns of an event, in the order in which storedEventIn() reads a row.
inline constexpr const char* kEventColumns =
    "seq, session_id, step, attempt, utc, monotonic_ns, actor, kind, detail, hash, content_hash, "
    "sealed";
StoredEvent storedEventIn(const Statement& row);

/// Inserts a row unchanged into a table with the columns kEventColumns.
void insertEvent(Database& database, const StoredEvent& event);

/// Detail and values of the event as English text.
std::string describe(const Event& event);

/// The audit trail: all events of a study in order. Events are never changed or deleted, except by
/// resealEvents().
///
/// Every event stores a hash of itself and of the hash before it (BLAKE2b-256), so that a changed,
/// removed or inserted row is detected. SQLite's integrity check does not detect these (of 3,000
/// flipped bits it missed 1,571 that changed content). Every event also stores a hash of the
/// tables' content about its session at that time, so that rows that another program changed are
/// detected as well.
///
/// The detail of a participant's event is sealed with the participant's content key, and the hash
/// of the tables is keyed with this key. The hash chain covers the sealed bytes, so it stays valid
/// when the key is destroyed (docs/decisions/0040). Events of participants without keys (simulated
/// ones, and those of older releases) are not sealed.
class EventLog {
 public:
  /// @param identities  holds the content keys; nullptr: nothing is sealed, and sealed details
  ///     cannot be read.
  explicit EventLog(Database& database, const IdentityStore* identities = nullptr)
      : database_(database), identities_(identities) {}

  /// Appends an event inside the caller's transaction. It must be the last change of the
  /// transaction, because it stores the hash of the tables' content.
  /// @throws StorageError  also if the detail is not valid UTF-8.
  void append(const Event& event);

  /// The hash of the last event; empty before the first.
  std::vector<std::byte> head() const;

  /// The number of events and the first 128 bits of the last hash in eight groups, to be read
  /// aloud: "812 events, 1a2b 3c4d 5e6f 7081 92a3 b4c5 d6e7 f809".
  std::string headAsText() const;

  /// Whether the trail contains an event with the hash in @p noted, a text that headAsText()
  /// returned earlier, with or without the number of events. If so, no event up to that one was cut
  /// off or rewritten.
  /// @throws UserError  if @p noted is not such a text.
  bool containsNotedHead(const std::string& noted) const;

  /// The number of the last event; 0 before the first.
  std::int64_t last() const;

  /// When the latest event of that kind was appended [ms since 1970]; std::nullopt if there is
  /// none.
  std::optional<std::int64_t> latestTimeOf(EventKind kind) const;

  /// The values of the event MadeStudy.
  base::NamedArguments valuesOfMadeStudy() const;

  /// The commitment to the study's secret in the event MadeStudy (BlindingSecret::commitment());
  /// empty in studies without a secret.
  std::string commitment() const;

  /// Whether the trail contains an event with the hash @p head.
  bool holds(const std::vector<std::byte>& head) const;

  /// The hash of the tables' content in the last event of a session, or in the last event without a
  /// session.
  struct Content {
    std::vector<std::byte> hash;  ///< empty if format 1 wrote the event
    bool isSealed = false;        ///< the hash is keyed with the participant's content key
  };
  /// std::nullopt if there is no such event.
  std::optional<Content> lastContent(std::optional<SessionId> session) const;

  /// The content key of a session's participant; std::nullopt if it was never drawn, or was
  /// destroyed.
  std::optional<SealingKey> keyOf(SessionId session) const;

  /// The key that seals an event of that kind: the participant's content key; for events that
  /// reveal the condition, joined with the study's key if the study is sealed.
  std::optional<SealingKey> keyOf(SessionId session, EventKind kind) const;

  /// The study's key; nullptr if it is not available on this computer, or if nothing is sealed with
  /// it.
  const SealingKey* studyKey() const noexcept { return database_.key(); }

  /// Rewrites the whole trail inside the caller's transaction: first @p event, then all other
  /// events in their order. Events of participants who have keys are sealed. Only the last event of
  /// each session keeps its hash of the tables, because earlier hashes would reveal something about
  /// the answers.
  void resealEvents(const Event& event);

  /// The first @p most rows after event number @p after, unchanged.
  std::vector<StoredEvent> stored(std::int64_t after, std::int64_t most) const;

  /// Stores a row unchanged, with its number and hash, so that its trail can be checked. The
  /// session of the event need not exist.
  void putStored(const StoredEvent& event);

  /// Appends an event of another trail as the next event of this one, inside the caller's
  /// transaction. Time, actor, kind and detail are kept; number and hash are those of this trail.
  /// @param event  with the session's number in this study; its detail is unsealed, unless it
  ///     cannot be
  /// @param key  the content key of its participant; nullptr: the event is not sealed
  /// @param hasContentHash  whether the event gets a hash of the tables: for the last event of a
  /// session
  void appendFromOtherTrail(const StoredEvent& event, const SealingKey* key, bool hasContentHash);

  /// Calls @p append, which appends many events, inside the caller's transaction. The triggers that
  /// protect the trail are removed meanwhile: with them SQLite would keep a journal for every
  /// statement.
  void appendMany(const std::function<void()>& append);

  /// The events of one session, or of the whole study, in order.
  std::vector<Event> read(std::optional<SessionId> session = std::nullopt) const;
  /// Events of one kind, in order.
  std::vector<Event> read(EventKind kind) const;

  /// Describes the first event at which the hash chain is broken; std::nullopt if it is intact.
  std::optional<std::string> firstBreak() const;

 private:
  /// The key that seals an event of @p kind, from the participant's key @p own.
  SealingKey sealingKeyFor(const SealingKey& own, EventKind kind) const;
  std::string selectEvents(const char* which) const;
  std::vector<Event> eventsIn(Statement& select) const;

  Database& database_;
  const IdentityStore* identities_;
};

/// The detail of a sealed event as text; std::nullopt if it was sealed with other keys.
/// @param own  the content key of the event's participant
/// @param study  the key of the study in which it was written; nullptr: not known
std::optional<std::string> unsealedDetail(
    const StoredEvent& event, const SealingKey& own, const SealingKey* study);

std::string_view nameOf(Actor actor) noexcept;

}  // namespace study::storage

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

enum class Actor { Participant, Operator, Program };

/// An event of the audit trail.
struct Event {
  std::optional<VisitKey> visit;
  Moment when;
  Actor actor = Actor::Program;
  EventKind kind = EventKind::Unknown;
  std::string detail;  ///< one value, or text that somebody entered; may be empty
  /// Named values of kinds that have several: {"times", 3}, {"duration_s", 0.12}. Release 0.1 wrote
  /// a sentence instead, which is then in @ref detail (docs/decisions/0019).
  base::NamedArguments values = {};
  std::string unknownName = {};  ///< of a kind that only a later release knows
  /// The detail cannot be read any more: its participant was erased, and the key destroyed.
  bool isErased = false;
  /// The detail reveals the condition and is sealed with the study's key, which is not available
  /// here.
  bool isSealed = false;

  /// "answered", "finished_step", "note": the kind as it is stored.
  std::string_view name() const noexcept;

  /// The value of that name; nullptr if there is none.
  const base::Argument* value(std::string_view name) const noexcept;
};

/// An event as its row stores it. Its detail may be sealed.
struct StoredEvent {
  std::int64_t seq = 0;
  std::optional<std::int64_t> session;
  std::optional<std::int64_t> step;
  std::optional<std::int64_t> attempt;
  std::string utc;
  std::int64_t monotonic = 0;  ///< [ns]
  std::string actor;
  std::string kind;
  std::string detail;
  std::vector<std::byte> content;  ///< hash of the tables; empty in rows of format 1
  std::vector<std::byte> sealed;   ///< the detail; empty if that is open
  std::vector<std::byte> hash;
};

/// Detail and values of the event as English text.
std::string describe(const Event& event);

/// The audit trail: all events of a study in order. Events are only ever added.
///
/// Every event carries a hash of itself and of the event before it (BLAKE2b-256), so that a
/// changed, removed or inserted row is detected. SQLite's integrity check does not detect these (of
/// 3,000 flipped bits it missed 1,571 that changed content). Every event also carries a hash of the
/// tables' content about its session at that time, so that a row which another program changed is
/// detected as well.
///
/// The detail of a participant's event is sealed with that participant's content key, and the hash
/// of the tables is keyed with it. The chain covers the sealed bytes, so that it stays valid when
/// the key is destroyed (docs/decisions/0040). Events of participants without keys (simulated ones,
/// and those of older releases) are not sealed.
class EventLog {
 public:
  /// @param identities  has the content keys; nullptr: nothing is sealed, and sealed details cannot
  ///     be read.
  explicit EventLog(Database& database, const IdentityStore* identities = nullptr)
      : database_(database), identities_(identities) {}

  /// Appends an event inside the caller's transaction. It must be the last change there, because it
  /// stores the hash of the tables' content.
  /// @throws StorageError  also if the detail is not valid UTF-8.
  void append(const Event& event);

  /// The hash of the last event; empty before the first.
  std::vector<std::byte> head() const;

  /// How many events there are, and the first 128 bits of the last one's hash in eight groups, to
  /// be read aloud: "812 events, 1a2b 3c4d 5e6f 7081 92a3 b4c5 d6e7 f809".
  std::string headAsText() const;

  /// Whether some event has the head @p noted, as headAsText() gave it earlier, with or without
  /// the number of events before it. Then nothing up to that event was cut off or rewritten.
  /// @throws UserError  if @p noted is not such a text.
  bool extends(const std::string& noted) const;

  /// The number of the last event; 0 before the first.
  std::int64_t last() const;

  /// The values of the event with which the study was made.
  base::NamedArguments madeStudy() const;

  /// The commitment to the study's secret in the first event (BlindingSecret::commitment()); empty
  /// in studies without one.
  std::string commitment() const;

  /// Whether the event with hash @p head is stored.
  bool holds(const std::vector<std::byte>& head) const;

  /// The hash of the tables in the last event of a session, or of the study itself.
  struct Content {
    std::vector<std::byte> hash;  ///< empty if format 1 wrote the event
    bool isSealed = false;        ///< the hash is keyed with the participant's content key
  };
  /// std::nullopt if there is no event.
  std::optional<Content> lastContent(std::optional<SessionId> session) const;

  /// The content key of a session's participant; std::nullopt if there is none (any more).
  std::optional<SealingKey> keyOf(SessionId session) const;

  /// The key that seals an event of that kind: the participant's content key; if the study is
  /// sealed, it is joined with the study's key for events that reveal the condition.
  std::optional<SealingKey> keyOf(SessionId session, EventKind kind) const;

  /// The study's key; nullptr if it is not available here, or nothing is sealed with it.
  const SealingKey* studyKey() const noexcept { return database_.key(); }

  /// Rewrites the whole trail inside the caller's transaction: first @p event, then all other
  /// events in their order. Events of participants who have keys are sealed. Of the hashes of
  /// tables only the last one of each session stays, because earlier ones would reveal something
  /// about answers.
  void resealEvents(const Event& event);

  /// Rows as they are: the first @p most after the event @p after.
  std::vector<StoredEvent> stored(std::int64_t after, std::int64_t most) const;

  /// Stores a row unchanged, with its number and hash, for a trail that is to be checked. The
  /// session of the event need not exist.
  void putStored(const StoredEvent& event);

  /// Appends what an event of another trail says, as the next event of this one, inside the
  /// caller's transaction. Time, actor, kind and text stay; number and hash are of this trail.
  /// @param event  with the session's number in this study; opened, unless it stays closed
  /// @param key  the content key of its participant; nullptr: there is none, and it is not sealed
  /// @param vouches  whether it carries a hash of the tables: the last event of a session
  void appendFrom(const StoredEvent& event, const SealingKey* key, bool vouches);

  /// Events of one session, or of all, in order.
  std::vector<Event> read(std::optional<SessionId> session = std::nullopt) const;

  /// A message on the first event at which the hash chain is broken; std::nullopt if it is intact.
  std::optional<std::string> firstBreak() const;

 private:
  SealingKey sealedWith(const SealingKey& own, EventKind kind) const;

  Database& database_;
  const IdentityStore* identities_;
};

/// What a sealed event says; std::nullopt if it was sealed with other keys.
/// @param own  the content key of its participant
/// @param study  the key of the study in which it was written; nullptr: it is not known
std::optional<std::string> openedDetail(
    const StoredEvent& event, const SealingKey& own, const SealingKey* study);

std::string_view nameOf(Actor actor) noexcept;

}  // namespace study::storage

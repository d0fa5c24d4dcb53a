#include "study/storage/event_log.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <map>
#include <stdexcept>
#include <utility>

#include "questionnaires/json/document.h"
#include "study/model/named_value.h"
#include "study/model/user_error.h"
#include "study/storage/content_hash.h"
#include "study/storage/events_of_release_0_1.h"
#include "study/storage/statement.h"
#include "study/storage/stored_values.h"

namespace study::storage {
namespace {

/// The associated data of a sealed detail: its place in the trail.
std::string placeOf(std::int64_t number, const std::string& kind) {
  return std::to_string(number) + "/" + kind;
}

/// An event as a row of the table. The writer gives the row its number.
struct Row : StoredEvent {
  Hash hashAfter(std::int64_t number, const std::vector<std::byte>& previous) const {
    Hasher hasher;
    hasher.add(std::span(previous));
    hasher.add(std::optional(number));
    hasher.add(session);
    hasher.add(step);
    hasher.add(attempt);
    hasher.add(utc);
    hasher.add(std::optional(monotonic));
    hasher.add(actor);
    hasher.add(kind);
    hasher.add(detail);
    if (!sealed.empty()) {  // rows of older formats were hashed without this field
      hasher.add("sealed");
      hasher.add(std::span<const std::byte>(sealed));
    }
    // Left out if empty: rows of format 1 were hashed without it.
    if (!content.empty()) hasher.add(std::span(content));
    return hasher.finish();
  }

  void seal(std::int64_t number, const SealingKey& key) {
    sealed = key.seal(detail, placeOf(number, kind));
    detail.clear();
  }
};

constexpr std::size_t kDigitsOfHead = 32;  // 128 bits: short enough to be read aloud

constexpr const char* kColumnsBeforeSealing =
    "seq, session_id, step, attempt, utc, monotonic_ns, actor, kind, detail, hash, content_hash, "
    "NULL";
constexpr int kFirstColumnAfterEvent = 12;

/// The columns of events; a file of an older format that was opened for reading only lacks the last
/// one.
const char* columnsIn(const Database& database) {
  return database.hasTable("erasure") ? kEventColumns : kColumnsBeforeSealing;
}

Row rowIn(const Statement& statement) {
  return {storedEventIn(statement)};
}

constexpr std::string_view kLimitCycle =
    ", at rest the force alternates by {limit_cycle_n:.3g} N at {limit_cycle_hz:.4g} Hz";
constexpr std::string_view kLeaps = ", leaps of the position {leaps}";
constexpr std::string_view kDrift = ", drift {drift_ppm:+.2f} ppm";

/// @throws StorageError  if @p words are not valid UTF-8, because they could not be exported.
void requireText(const std::string& words) {
  if (!questionnaires::utf8CharacterCount(words) || words.find('\0') != std::string::npos) {
    throw StorageError("What is to be noted is no sound UTF-8 text. Write it with other letters.");
  }
}

void requireText(const Event& event) {
  requireText(event.detail);
  for (const auto& [name, value] : event.values) {
    if (const auto* words = std::get_if<std::string>(&value)) requireText(*words);
  }
}

/// Reads detail and values of an event from the column `detail`: JSON, or a sentence of release
/// 0.1, none of which begins with '{' in kinds of events with values.
void readDetail(Event& event, const std::string& column) {
  event.detail = column;
  if (patternOf(event.kind).english.empty()) return;
  if (!column.starts_with('{')) {
    event.values = release_0_1::valuesIn(event.kind, column);
  } else if (auto values = valuesIn(column)) {
    event.values = std::move(*values);
    event.detail.clear();
  }
}

/// The milliseconds of a time: 381 for "2026-11-20T13:35:07.381Z"; 0 if it cannot be parsed.
/// SQLite's unixepoch() returns whole seconds only.
std::int64_t millisecondsIn(const std::string& utc) {
  constexpr std::size_t kMillisecondsAt = 20;
  std::int64_t milliseconds = 0;
  if (utc.size() < kMillisecondsAt + 3) return 0;
  std::from_chars(utc.data() + kMillisecondsAt, utc.data() + kMillisecondsAt + 3, milliseconds);
  return milliseconds;
}

Row rowOf(const Event& event) {
  Row row{StoredEvent{
      .utc = asUtc(event.when.wall),
      .monotonic = event.when.monotonic,
      .actor = std::string(nameOf(event.actor)),
      .kind = std::string(event.name()),
      .detail = event.values.empty() ? event.detail : asJson(event.values)}};
  if (event.visit) {
    row.session = static_cast<std::int64_t>(event.visit->session);
    row.step = event.visit->step;
    row.attempt = event.visit->attempt;
  }
  return row;
}

void insert(Database& database, std::int64_t seq, Row row, const Hash& hash) {
  row.seq = seq;
  row.hash = asBytes(hash);
  insertEvent(database, row);
}

/// The number of the next event, and the hash of the last one.
std::pair<std::int64_t, std::vector<std::byte>> nextNumberAndLastHash(const Database& database) {
  Statement last(database, "SELECT seq, hash FROM event ORDER BY seq DESC LIMIT 1");
  if (!last.step()) return {1, {}};
  return {last.number(0) + 1, last.blob(1)};
}

/// The keys of sessions; each is read once.
class Keys {
 public:
  explicit Keys(const EventLog& log) : log_(log) {}

  /// nullptr if the session has no key.
  const SealingKey* find(std::int64_t session) {
    const auto [found, isNew] = keys_.try_emplace(session);
    if (isNew) found->second = log_.keyOf(SessionId{session});
    return found->second ? &*found->second : nullptr;
  }

  /// Replaces a sealed detail by its text. False if it cannot be unsealed.
  bool open(Row& row) {
    const auto* key = find(row.session.value_or(0));
    auto detail = key != nullptr ? unsealedDetail(row, *key, log_.studyKey()) : std::nullopt;
    if (detail) row.detail = std::move(*detail);
    return detail.has_value();
  }

 private:
  const EventLog& log_;
  std::map<std::int64_t, std::optional<SealingKey>> keys_;
};

/// Whether the detail of events of that kind reveals the condition.
bool revealsCondition(EventKind kind) {
  return kind == EventKind::FinishedTrial || kind == EventKind::Passivity ||
         kind == EventKind::Torque || kind == EventKind::DeviceLink ||
         kind == EventKind::DeviceFault || kind == EventKind::View ||
         (kind >= EventKind::SafetyTooFast && kind <= EventKind::SafetyTorqueActive);
}

/// The triggers that forbid changes of events. The constructor drops them, so that the trail can be
/// rewritten.
class ProtectiveTriggers {
 public:
  explicit ProtectiveTriggers(Database& database) : database_(database) {
    Statement select(
        database,
        "SELECT name, sql FROM sqlite_schema WHERE type = 'trigger' AND tbl_name = 'event' "
        "ORDER BY rowid");
    std::string removals;
    while (select.step()) {
      removals += "DROP TRIGGER " + select.text(0) + ";";
      triggers_ += select.text(1) + ";";
    }
    select.reset();
    database.execute(removals);
  }
  /// Creates the triggers again. Must be called before the transaction is committed.
  void recreate() { database_.execute(triggers_); }

 private:
  Database& database_;
  std::string triggers_;
};

constexpr std::array<std::string_view, 3> kActors{"participant", "operator", "program"};

Actor actorNamed(std::string_view name) {
  return valueNamed<Actor>(kActors, name).value_or(Actor::Program);
}

}  // namespace

void insertEvent(Database& database, const StoredEvent& event) {
  Statement insert(
      database,
      std::string("INSERT INTO event (") + kEventColumns + ") VALUES (?,?,?,?,?,?,?,?,?,?,?,?)");
  insert.bindAll(
      event.seq,
      event.session,
      event.step,
      event.attempt,
      event.utc,
      event.monotonic,
      event.actor,
      event.kind,
      event.detail,
      event.hash);
  if (!event.content.empty()) insert.bind(11, std::span<const std::byte>(event.content));
  if (!event.sealed.empty()) insert.bind(12, std::span<const std::byte>(event.sealed));
  insert.run();
}

StoredEvent storedEventIn(const Statement& row) {
  return {
      .seq = row.number(0),
      .session = row.optionalNumber(1),
      .step = row.optionalNumber(2),
      .attempt = row.optionalNumber(3),
      .utc = row.text(4),
      .monotonic = row.number(5),
      .actor = row.text(6),
      .kind = row.text(7),
      .detail = row.text(8),
      .content = row.blob(10),
      .sealed = row.blob(11),
      .hash = row.blob(9)};
}

std::string_view nameOf(Actor actor) noexcept {
  return kActors[static_cast<std::size_t>(actor)];
}

std::string_view Event::name() const noexcept {
  return kind == EventKind::Unknown ? std::string_view(unknownName) : nameOf(kind);
}

const base::Argument* Event::value(std::string_view name) const noexcept {
  const auto found =
      std::ranges::find_if(values, [&](const auto& entry) { return entry.first == name; });
  return found == values.end() ? nullptr : &found->second;
}

std::string describe(const Event& event) {
  if (event.isErased) return "(erased)";
  if (event.isSealed) return "(sealed)";
  const auto pattern = patternOf(event.kind);
  if (pattern.english.empty() || event.values.empty()) return event.detail;
  const auto* countedValue = event.value(pattern.countedValue);
  const bool isOne = countedValue != nullptr && *countedValue == base::Argument(std::int64_t{1});
  try {
    std::string words = base::filled(isOne ? pattern.singular : pattern.english, event.values);
    if (event.value("drift_ppm") != nullptr) words += base::filled(kDrift, event.values);
    if (event.value("leaps") != nullptr) words += base::filled(kLeaps, event.values);
    if (event.value("limit_cycle_n") != nullptr) words += base::filled(kLimitCycle, event.values);
    return words;
  } catch (const std::runtime_error&) {
    return asJson(event.values);  // a later release may have stored other values
  }
}

std::optional<std::string> unsealedDetail(
    const StoredEvent& event, const SealingKey& own, const SealingKey* study) {
  const auto place = placeOf(event.seq, event.kind);
  auto detail = own.open(event.sealed, place);
  return detail || study == nullptr ? detail : study->joinedWith(own).open(event.sealed, place);
}

void EventLog::append(const Event& event) {
  requireText(event);
  Row row = rowOf(event);
  // An Erased event is never sealed. Its hash of the tables needs no key, because the answers are
  // deleted.
  const bool isSealed = event.visit && event.kind != EventKind::Erased;
  const auto key = isSealed ? keyOf(event.visit->session) : std::nullopt;
  row.content = asBytes(
      event.visit ? contentHash(database_, event.visit->session, key ? &*key : nullptr)
                  : contentHash(database_));
  const auto [seq, previous] = nextNumberAndLastHash(database_);
  if (key) row.seal(seq, *keyOf(event.visit->session, event.kind));
  insert(database_, seq, row, row.hashAfter(seq, previous));
}

void EventLog::resealEvents(const Event& event) {
  std::vector<Row> rows;
  std::map<std::int64_t, std::size_t> lastOf;  // index of the last event of every session
  Keys keys(*this);
  {
    Statement select(
        database_, std::string("SELECT ") + kEventColumns + " FROM event ORDER BY seq");
    while (select.step()) {
      Row row = rowIn(select);
      // A detail that cannot be unsealed is kept sealed: its participant was erased.
      if (!row.sealed.empty() && keys.open(row)) row.sealed.clear();
      if (row.session) lastOf[*row.session] = rows.size();
      rows.push_back(std::move(row));
    }
  }
  ProtectiveTriggers guards(database_);
  database_.execute("DELETE FROM event");
  append(event);
  std::vector<std::byte> previous = head();
  std::int64_t seq = 1;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Row& row = rows[i];
    ++seq;
    const bool isOpen = row.session && row.sealed.empty() && row.kind != nameOf(EventKind::Erased);
    if (const auto* key = isOpen ? keys.find(*row.session) : nullptr) {
      row.seal(seq, *keyOf(SessionId{*row.session}, eventKindNamed(row.kind)));
      row.content.clear();
      if (lastOf.at(*row.session) == i) {
        row.content = asBytes(contentHash(database_, SessionId{*row.session}, key));
      }
    }
    const auto hash = row.hashAfter(seq, previous);
    insert(database_, seq, row, hash);
    previous = asBytes(hash);
  }
  guards.recreate();
}

std::vector<StoredEvent> EventLog::stored(std::int64_t after, std::int64_t most) const {
  Statement select(
      database_,
      std::string("SELECT ") + columnsIn(database_) +
          " FROM event WHERE seq > ? ORDER BY seq LIMIT ?");
  select.bindAll(after, most);
  std::vector<StoredEvent> events;
  while (select.step()) events.push_back(rowIn(select));
  return events;
}

void EventLog::putStored(const StoredEvent& event) {
  insertEvent(database_, event);
}

void EventLog::appendFromOtherTrail(
    const StoredEvent& event, const SealingKey* key, bool hasContentHash) {
  Row row{event};
  const bool isToBeSealed =
      key != nullptr && row.session && row.sealed.empty() && row.kind != nameOf(EventKind::Erased);
  row.content.clear();
  if (hasContentHash) {
    row.content = asBytes(
        row.session ? contentHash(database_, SessionId{*row.session}, isToBeSealed ? key : nullptr)
                    : contentHash(database_));
  }
  const auto [seq, previous] = nextNumberAndLastHash(database_);
  if (isToBeSealed) row.seal(seq, sealingKeyFor(*key, eventKindNamed(row.kind)));
  insert(database_, seq, row, row.hashAfter(seq, previous));
}

void EventLog::appendMany(const std::function<void()>& append) {
  ProtectiveTriggers guards(database_);
  append();
  guards.recreate();
}

std::vector<std::byte> EventLog::head() const {
  return nextNumberAndLastHash(database_).second;
}

std::string EventLog::headAsText() const {
  Statement select(database_, "SELECT seq, lower(hex(hash)) FROM event ORDER BY seq DESC LIMIT 1");
  if (!select.step()) return {};
  std::string words = std::to_string(select.number(0)) + " events,";
  const auto hash = select.text(1);
  if (hash.size() < kDigitsOfHead) return {};  // the file is damaged
  for (std::size_t i = 0; i < kDigitsOfHead; i += 4) words += " " + hash.substr(i, 4);
  return words;
}

bool EventLog::containsNotedHead(const std::string& noted) const {
  const auto comma = noted.find(',');
  std::string digits;
  for (const char c : noted.substr(comma == std::string::npos ? 0 : comma + 1)) {
    if (c != ' ') digits += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  const bool isHead = digits.size() == kDigitsOfHead &&
                      digits.find_first_not_of("0123456789abcdef") == std::string::npos;
  if (!isHead) {
    throw UserError(
        "'" + noted +
        "' is no head of an audit trail: that has eight groups of four digits or "
        "letters a to f. 'palpate study verify' prints it.");
  }
  Statement select(database_, "SELECT 1 FROM event WHERE substr(lower(hex(hash)), 1, ?) = ?");
  select.bindAll(kDigitsOfHead, digits);
  return select.step();
}

std::int64_t EventLog::last() const {
  Statement last(database_, "SELECT coalesce(max(seq), 0) FROM event");
  last.step();
  return last.number(0);
}

std::optional<std::int64_t> EventLog::latestTimeOf(EventKind kind) const {
  Statement latest(
      database_, "SELECT utc, unixepoch(utc) FROM event WHERE kind = ? ORDER BY utc DESC LIMIT 1");
  latest.bindAll(study::nameOf(kind));
  if (!latest.step()) return std::nullopt;
  return latest.number(1) * 1000 + millisecondsIn(latest.text(0));
}

base::NamedArguments EventLog::valuesOfMadeStudy() const {
  // The first event, or the second if the trail was sealed again: its first event is then
  // ResealedTrail.
  Statement first(
      database_, "SELECT detail FROM event WHERE seq <= 2 AND kind = ? ORDER BY seq LIMIT 1");
  first.bindAll(study::nameOf(EventKind::MadeStudy));
  if (!first.step()) return {};
  return valuesIn(first.text(0)).value_or(base::NamedArguments());
}

std::string EventLog::commitment() const {
  return storedText(valuesOfMadeStudy(), "secret");
}

bool EventLog::holds(const std::vector<std::byte>& head) const {
  Statement select(database_, "SELECT 1 FROM event WHERE hash = ?");
  select.bindAll(std::span(head));
  return select.step();
}

std::optional<EventLog::Content> EventLog::lastContent(std::optional<SessionId> session) const {
  Statement select(
      database_,
      std::string("SELECT ") + columnsIn(database_) +
          " FROM event WHERE session_id IS ? ORDER BY seq DESC LIMIT 1");
  select.bindAll(session ? std::optional(static_cast<std::int64_t>(*session)) : std::nullopt);
  if (!select.step()) return std::nullopt;
  const Row row = rowIn(select);
  return Content{.hash = row.content, .isSealed = !row.sealed.empty()};
}

std::optional<SealingKey> EventLog::keyOf(SessionId session) const {
  if (identities_ == nullptr) return std::nullopt;
  Statement select(
      database_,
      "SELECT p.code FROM session AS s JOIN participant AS p ON p.id = s.participant_id "
      "WHERE s.id = ?");
  select.bindAll(session);
  if (!select.step()) return std::nullopt;
  return identities_->key(IdentityStore::Key::Content, select.text(0));
}

std::optional<SealingKey> EventLog::keyOf(SessionId session, EventKind kind) const {
  const auto own = keyOf(session);
  return own ? std::optional(sealingKeyFor(*own, kind)) : std::nullopt;
}

SealingKey EventLog::sealingKeyFor(const SealingKey& own, EventKind kind) const {
  const auto* key = revealsCondition(kind) ? database_.key() : nullptr;
  return key != nullptr ? key->joinedWith(own) : own;
}

std::string EventLog::selectEvents(const char* which) const {
  return std::string("SELECT ") + columnsIn(database_) + ", unixepoch(utc) FROM event " + which +
         " ORDER BY seq";
}

std::vector<Event> EventLog::read(std::optional<SessionId> session) const {
  Statement select(database_, selectEvents(session ? "WHERE session_id = ?" : ""));
  if (session) select.bindAll(*session);
  return eventsIn(select);
}

std::vector<Event> EventLog::read(EventKind kind) const {
  Statement select(database_, selectEvents("WHERE kind = ?"));
  select.bindAll(nameOf(kind));
  return eventsIn(select);
}

std::vector<Event> EventLog::eventsIn(Statement& select) const {
  std::vector<Event> events;
  Keys keys(*this);
  while (select.step()) {
    Row row = rowIn(select);
    const bool isOpen = row.sealed.empty() || keys.open(row);
    Event event{.actor = actorNamed(row.actor), .kind = eventKindNamed(row.kind)};
    if (event.kind == EventKind::Unknown) event.unknownName = row.kind;
    const bool isHidden = !isOpen && studyKey() == nullptr && revealsCondition(event.kind) &&
                          keys.find(row.session.value_or(0)) != nullptr;
    event.isSealed = isHidden;
    event.isErased = !isOpen && !isHidden;
    if (isOpen) readDetail(event, row.detail);
    if (row.session) {
      event.visit = VisitKey{
          SessionId{*row.session},
          static_cast<int>(row.step.value_or(0)),
          static_cast<int>(row.attempt.value_or(1))};
    }
    event.when = {
        select.number(kFirstColumnAfterEvent) * 1000 + millisecondsIn(row.utc), row.monotonic};
    events.push_back(std::move(event));
  }
  return events;
}

std::optional<std::string> EventLog::firstBreak() const {
  Statement select(
      database_, std::string("SELECT ") + columnsIn(database_) + " FROM event ORDER BY seq");
  std::vector<std::byte> previous;
  std::int64_t expected = 1;
  while (select.step()) {
    const auto seq = select.number(0);
    if (seq != expected) {
      return "event " + std::to_string(expected) + " is missing from the audit trail";
    }
    const auto stored = select.blob(9);
    if (stored != asBytes(rowIn(select).hashAfter(seq, previous))) {
      return "event " + std::to_string(seq) + " (" + select.text(7) + ", " + select.text(4) +
             ") has been changed since it was written";
    }
    previous = stored;
    ++expected;
  }
  return std::nullopt;
}

}  // namespace study::storage

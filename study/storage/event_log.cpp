#include "study/storage/event_log.h"

#include <array>

#include <sodium.h>

#include "study/storage/statement.h"

namespace study::storage {
namespace {

using Hash = std::array<std::byte, 32>;

/// What is hashed: every field with its length before it, so that no two events look alike.
class Hasher {
 public:
  Hasher() { crypto_generichash_init(&state_, nullptr, 0, sizeof(Hash)); }

  void add(std::string_view text) {
    const std::string length = std::to_string(text.size()) + ":";
    update(length);
    update(text);
  }
  void add(const std::optional<std::int64_t>& number) {
    add(number ? std::to_string(*number) : std::string("-"));
  }
  void add(const std::vector<std::byte>& bytes) {
    add(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
  }

  Hash finish() {
    Hash hash{};
    crypto_generichash_final(&state_, reinterpret_cast<unsigned char*>(hash.data()), hash.size());
    return hash;
  }

 private:
  void update(std::string_view text) {
    crypto_generichash_update(
        &state_, reinterpret_cast<const unsigned char*>(text.data()), text.size());
  }

  crypto_generichash_state state_{};
};

/// An event as it stands in a row.
struct Row {
  std::optional<std::int64_t> session;
  std::optional<std::int64_t> step;
  std::optional<std::int64_t> attempt;
  std::string utc;
  std::int64_t monotonic = 0;
  std::string actor;
  std::string kind;
  std::string detail;

  Hash hashAfter(std::int64_t seq, const std::vector<std::byte>& previous) const {
    Hasher hasher;
    hasher.add(previous);
    hasher.add(std::optional(seq));
    hasher.add(session);
    hasher.add(step);
    hasher.add(attempt);
    hasher.add(utc);
    hasher.add(std::optional(monotonic));
    hasher.add(actor);
    hasher.add(kind);
    hasher.add(detail);
    return hasher.finish();
  }
};

constexpr const char* kColumns =
    "seq, session_id, step, attempt, utc, monotonic_ns, actor, kind, detail, hash";

Row rowIn(const Statement& statement) {
  return {
      .session = statement.optionalNumber(1),
      .step = statement.optionalNumber(2),
      .attempt = statement.optionalNumber(3),
      .utc = statement.text(4),
      .monotonic = statement.number(5),
      .actor = statement.text(6),
      .kind = statement.text(7),
      .detail = statement.text(8)};
}

Actor actorNamed(std::string_view name) {
  if (name == "participant") return Actor::Participant;
  return name == "operator" ? Actor::Operator : Actor::Program;
}

}  // namespace

std::string_view nameOf(Actor actor) noexcept {
  switch (actor) {
    case Actor::Participant:
      return "participant";
    case Actor::Operator:
      return "operator";
    case Actor::Program:
      return "program";
  }
  return {};
}

void EventLog::append(const Event& event) {
  Row row{
      .utc = asUtc(event.when.wall),
      .monotonic = event.when.monotonic,
      .actor = std::string(nameOf(event.actor)),
      .kind = event.kind,
      .detail = event.detail};
  if (event.visit) {
    row.session = static_cast<std::int64_t>(event.visit->session);
    row.step = event.visit->step;
    row.attempt = event.visit->attempt;
  }
  std::int64_t seq = 1;
  std::vector<std::byte> previous;
  Statement last(database_, "SELECT seq, hash FROM event ORDER BY seq DESC LIMIT 1");
  if (last.step()) {
    seq = last.number(0) + 1;
    previous = last.blob(1);
  }
  const Hash hash = row.hashAfter(seq, previous);
  Statement insert(
      database_, "INSERT INTO event (" + std::string(kColumns) + ") VALUES (?,?,?,?,?,?,?,?,?,?)");
  insert.bind(1, seq)
      .bind(2, row.session)
      .bind(3, row.step)
      .bind(4, row.attempt)
      .bind(5, row.utc)
      .bind(6, row.monotonic)
      .bind(7, row.actor)
      .bind(8, row.kind)
      .bind(9, row.detail)
      .bind(10, std::span<const std::byte>(hash));
  insert.run();
}

std::vector<std::byte> EventLog::head() const {
  Statement last(database_, "SELECT hash FROM event ORDER BY seq DESC LIMIT 1");
  return last.step() ? last.blob(0) : std::vector<std::byte>();
}

std::vector<Event> EventLog::read(std::optional<SessionId> session) const {
  Statement select(
      database_,
      "SELECT " + std::string(kColumns) + ", unixepoch(utc) FROM event" +
          (session ? " WHERE session_id = ?" : "") + " ORDER BY seq");
  if (session) select.bind(1, static_cast<std::int64_t>(*session));
  std::vector<Event> events;
  while (select.step()) {
    const Row row = rowIn(select);
    Event event{.actor = actorNamed(row.actor), .kind = row.kind, .detail = row.detail};
    if (row.session) {
      event.visit = VisitKey{
          SessionId{*row.session},
          static_cast<int>(row.step.value_or(0)),
          static_cast<int>(row.attempt.value_or(1))};
    }
    const std::string milliseconds = row.utc.size() > 23 ? row.utc.substr(20, 3) : "0";
    event.when = {select.number(10) * 1000 + std::stoll(milliseconds), row.monotonic};
    events.push_back(std::move(event));
  }
  return events;
}

std::optional<std::string> EventLog::firstBreak() const {
  Statement select(database_, "SELECT " + std::string(kColumns) + " FROM event ORDER BY seq");
  std::vector<std::byte> previous;
  std::int64_t expected = 1;
  while (select.step()) {
    const auto seq = select.number(0);
    if (seq != expected) {
      return "event " + std::to_string(expected) + " is missing from the audit trail";
    }
    const auto stored = select.blob(9);
    const Hash hash = rowIn(select).hashAfter(seq, previous);
    if (stored != std::vector<std::byte>(hash.begin(), hash.end())) {
      return "event " + std::to_string(seq) + " (" + select.text(7) + ", " + select.text(4) +
             ") has been changed since it was written";
    }
    previous = stored;
    ++expected;
  }
  return std::nullopt;
}

}  // namespace study::storage

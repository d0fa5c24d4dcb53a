#include "study/collect/exchange/station_trail.h"

#include <algorithm>
#include <memory>
#include <set>
#include <span>
#include <utility>

#include "study/model/event_kind.h"
#include "study/model/session_state.h"
#include "study/storage/content_hash.h"
#include "study/storage/evidence/trail_heads.h"
#include "study/storage/hasher.h"
#include "study/storage/protocol_repository.h"
#include "study/storage/statement.h"
#include "study/storage/stored_values.h"
#include "study/storage/study_schema.h"

namespace study::collect {
namespace {

using storage::Statement;

/// A study in memory with these events and no sessions.
std::unique_ptr<storage::Database> trailOf(
    const std::string& study, std::span<const storage::StoredEvent> events) {
  auto database =
      std::make_unique<storage::Database>(storage::Database::inMemory(storage::studySchema()));
  // Events were compared with their numbers before.
  database->execute("PRAGMA foreign_keys = OFF; DROP TRIGGER an_event_is_added_at_the_end");
  storage::Transaction transaction(*database);
  Statement row(
      *database,
      "INSERT INTO study (id, uuid, seed, random_version, app_version, created_utc) "
      "VALUES (1, ?, '', 0, '', '')");
  row.bindAll(study);
  row.run();
  storage::EventLog log(*database);
  for (const auto& event : events) log.putStored(event);
  transaction.commit();
  return database;
}

storage::IdentityStore storeOf(const std::vector<SentKey>& keys) {
  storage::IdentityStore identities(storage::Database::inMemory(storage::identitySchema()));
  storage::Transaction transaction(identities.database());
  for (const auto& key : keys) identities.putContentKey(key.participant, key.key);
  transaction.commit();
  return identities;
}

std::string nameOf(const VisitKey& visit) {
  return "step " + std::to_string(visit.step + 1) + ", attempt " + std::to_string(visit.attempt);
}

}  // namespace

/// The facts in the trail about trials.
struct StationTrail::Trials {
  std::map<VisitKey, std::string> traces;  ///< digests
  std::set<VisitKey> open;  ///< trials whose measurements are not sealed with the station's key
};

StationTrail::StationTrail(
    const CollectedStudy::Origin& study,
    const StationRow& station,
    std::vector<storage::StoredEvent> events,
    const std::vector<SentKey>& keys,
    std::int64_t bundleSignedUpTo)
    : station_(station.station),
      key_(study.secret.of(station.station.label).bytes()),
      events_(std::move(events)),
      identities_(storeOf(keys)),
      traces_(storage::Database::inMemory(storage::traceSchema())) {
  checkTrail(study, station, bundleSignedUpTo);
  for (std::int64_t i = 0; i < signedUpTo_; ++i) {
    const auto& event = events_[static_cast<std::size_t>(i)];
    if (event.session) lastEvents_[*event.session] = event.seq;
    if (event.kind == study::nameOf(EventKind::AmendedProtocol)) ++versions_;
  }
  storage::Transaction transaction(*database_);
  storage::ProtocolRepository protocols(*database_);
  for (const auto& protocol : study.protocols) protocols.add(protocol, "", "");
  transaction.commit();
}

void StationTrail::checkTrail(
    const CollectedStudy::Origin& study, const StationRow& station, std::int64_t bundleSignedUpTo) {
  // Drops the events from the first missing number on, because they cannot be checked; event n is
  // then the n-th of events_.
  std::int64_t whole = 0;
  const auto isNext = [&](const storage::StoredEvent& event) { return event.seq == ++whole; };
  events_.erase(std::ranges::find_if_not(events_, isNext), events_.end());
  bundleSignedUpTo = std::min(bundleSignedUpTo, static_cast<std::int64_t>(events_.size()));
  database_ = trailOf(study.uuid, events_);
  const storage::EventLog log(*database_);
  const auto broken = log.firstBreak();
  if (broken) problems_.push_back(*broken);
  if (static_cast<std::int64_t>(events_.size()) != station.lastEvent) {
    problems_.push_back(
        std::to_string(events_.size()) + " of " + std::to_string(station.lastEvent) +
        " events that the server acknowledged are there");
  }
  const auto made = log.valuesOfMadeStudy();
  const bool isOurs = storage::storedText(made, "site") == station_.site &&
                      storage::storedText(made, "station") == station_.label &&
                      storage::storedText(made, "station_uuid") == station_.uuid;
  if (!isOurs && !events_.empty()) {
    problems_.emplace_back("its trail did not begin with the enrolment of this station");
  }
  const storage::TrailHeads heads(*database_);
  for (const auto& problem : heads.checkSignatures(station.key).problems) {
    problems_.push_back(problem);
  }
  std::vector<std::int64_t> ends;
  for (const auto& each : heads.all()) {
    if (each.head.key != station.key) {
      problems_.push_back(
          "event " + std::to_string(each.seq) +
          " is signed by another station than the one that was enrolled");
    } else if (each.isSound && isOurs) {
      ends.push_back(each.seq);
    }
  }
  if (isOurs && bundleSignedUpTo > (ends.empty() ? 0 : ends.back()))
    ends.push_back(bundleSignedUpTo);
  const auto upTo = [&](std::int64_t end) {
    return trailOf(study.uuid, std::span(events_).first(static_cast<std::size_t>(end)));
  };
  // Events before the first break of the chain are as the station signed them.
  const auto isUnbroken = [&](std::int64_t end) {
    return !storage::EventLog(*upTo(end)).firstBreak();
  };
  const auto end = broken ? std::partition_point(ends.begin(), ends.end(), isUnbroken) : ends.end();
  if (end != ends.begin()) signedUpTo_ = *std::prev(end);
  if (signedUpTo_ < static_cast<std::int64_t>(events_.size())) database_ = upTo(signedUpTo_);
}

std::string StationTrail::describeUnsignedPart() const {
  const auto last = static_cast<std::int64_t>(events_.size());
  if (last == signedUpTo_) return {};
  return "events " + std::to_string(signedUpTo_ + 1) + " to " + std::to_string(last) +
         " have no sound signature of the station, and are left out";
}

std::string StationTrail::head() const {
  return signedUpTo_ == 0
             ? std::string("-")
             : storage::inHexadecimal(events_[static_cast<std::size_t>(signedUpTo_ - 1)].hash);
}

std::vector<storage::StoredEvent> StationTrail::takeEvents() {
  events_.resize(static_cast<std::size_t>(signedUpTo_));
  return std::move(events_);
}

std::vector<std::string> StationTrail::problemsOf(
    std::int64_t session,
    std::int64_t lastEvent,
    const storage::SessionTables& facts,
    const std::vector<storage::TraceChunk>& chunks) {
  std::vector<std::string> problems;
  const bool isHere =
      storage::textIn(facts, "session", "site") == station_.site &&
      storage::textIn(facts, "session", "station") == station_.label &&
      storage::textIn(facts, "participant", "code").starts_with(station_.label + "_");
  if (!isHere) problems.emplace_back("its rows are of another site, station or code");
  Trials recorded;
  std::optional<std::string> traceProblem;
  if (!chunks.empty() || !storage::rowsIn(facts, "trial").empty()) {
    const storage::Transaction rolledBack(*database_);
    storage::addSessionTablesAs(*database_, facts, SessionId{session}, nullptr, {});
    recorded = trialsOf(session);
    traceProblem = firstProblemOfTraces(session, chunks, recorded);
  }
  // At the station, data that reveal the conditions are sealed, unless the session was simulated or
  // the protocol has no blinding. Tries both ways.
  std::vector<const storage::SealingKey*> keysToTry{nullptr};
  if (storage::textIn(facts, "session", "run_mode") != study::nameOf(RunMode::Simulated)) {
    keysToTry.insert(keysToTry.begin(), &key_);
  }
  const auto& last = events_.at(static_cast<std::size_t>(lastEvent - 1));
  const bool isSame = std::ranges::any_of(keysToTry, [&](const auto* key) {
    const storage::Transaction rolledBack(*database_);
    storage::addSessionTablesAs(*database_, facts, SessionId{session}, key, recorded.open);
    return agrees(session, last);
  });
  if (!isSame) problems.emplace_back("its rows do not agree with the audit trail");
  if (traceProblem) problems.push_back(*traceProblem);
  return problems;
}

/// The hash of a session's rows covers the row numbers of participant and protocol in the station's
/// file. These are not sent. They count from 1 and are found by trying.
bool StationTrail::agrees(std::int64_t session, const storage::StoredEvent& recorded) {
  if (recorded.content.empty()) return false;
  Statement row(
      *database_,
      "SELECT s.participant_id, p.code, v.sha256 FROM session AS s JOIN participant AS p "
      "ON p.id = s.participant_id JOIN protocol AS v ON v.id = s.protocol_id WHERE s.id = ?");
  row.bindAll(session);
  row.step();
  auto participant = row.number(0);
  const auto code = row.text(1);
  const auto hash = row.text(2);
  row.reset();
  std::vector<std::int64_t> people;
  if (const auto known = participants_.find(code); known != participants_.end()) {
    people.push_back(known->second);
  } else {
    std::int64_t next = 1;
    for (const auto& [name, number] : participants_) next = std::max(next, number + 1);
    people.push_back(next);
    for (std::int64_t i = session; i >= 1; --i) people.push_back(i);
  }
  for (const auto person : people) {
    Statement(*database_, "UPDATE participant SET id = ? WHERE id = ?")
        .bindAll(person, participant)
        .run();
    participant = person;
    for (std::int64_t version = 1; version <= versions_; ++version) {
      const auto other = protocols_.find(version);
      if (other != protocols_.end() && other->second != hash) continue;
      Statement(*database_, "UPDATE session SET participant_id = ?, protocol_id = ? WHERE id = ?")
          .bindAll(person, version, session)
          .run();
      if (!agreesWithNumbers(session, recorded)) continue;
      participants_[code] = person;
      protocols_[version] = hash;
      return true;
    }
  }
  return false;
}

bool StationTrail::agreesWithNumbers(std::int64_t session, const storage::StoredEvent& recorded) {
  const storage::EventLog log(*database_, &identities_);
  const auto key = recorded.sealed.empty() ? std::nullopt : log.keyOf(SessionId{session});
  if (!recorded.sealed.empty() && !key) return false;
  return storage::asBytes(storage::contentHash(
             *database_, SessionId{session}, key ? &*key : nullptr)) == recorded.content;
}

StationTrail::Trials StationTrail::trialsOf(std::int64_t session) const {
  Trials trials;
  for (const auto& event : storage::EventLog(*database_, &identities_).read(SessionId{session})) {
    if (!event.visit || event.isErased || event.isSealed) continue;
    if (event.kind == EventKind::KeptTrace) trials.traces[*event.visit] = event.detail;
    // Each trial has one Passivity event, which is sealed if the trial is. The trail is read
    // without the key, so an event that can be read belongs to a trial that is not sealed.
    if (event.kind == EventKind::Passivity) trials.open.insert(*event.visit);
  }
  return trials;
}

/// Compares samples with their trials and with the digests in the trail.
std::optional<std::string> StationTrail::firstProblemOfTraces(
    std::int64_t session, const std::vector<storage::TraceChunk>& chunks, const Trials& recorded) {
  std::set<VisitKey> visits;
  for (const auto& chunk : chunks) {
    const VisitKey visit{SessionId{session}, chunk.step, chunk.attempt};
    if (storage::asBytes(storage::hashOf(chunk.data)) != chunk.hash) {
      return nameOf(visit) + ": samples differ from their hash";
    }
    try {
      storage::opened(chunk, SessionId{session}, key_);
    } catch (const storage::StorageError& error) {
      return nameOf(visit) + ": " + error.what();
    }
    visits.insert(visit);
  }
  const storage::Transaction rolledBack(traces_.database());
  for (const auto& chunk : chunks) storage::addChunk(traces_.database(), SessionId{session}, chunk);
  for (const auto& visit : visits) {
    const auto kept = recorded.traces.find(visit);
    if (kept == recorded.traces.end()) {
      return nameOf(visit) + ": samples that the audit trail does not know";
    }
    if (traces_.digest(visit) != kept->second) {
      return nameOf(visit) + ": the samples are not those that were recorded";
    }
  }
  Statement trials(
      *database_, "SELECT step, attempt, trace_samples FROM trial WHERE session_id = ?");
  trials.bindAll(session);
  while (trials.step()) {
    const VisitKey visit{
        SessionId{session}, static_cast<int>(trials.number(0)), static_cast<int>(trials.number(1))};
    if (traces_.sampleCount(visit) != trials.number(2)) {
      return nameOf(visit) + ": not all samples are there";
    }
  }
  return std::nullopt;
}

}  // namespace study::collect

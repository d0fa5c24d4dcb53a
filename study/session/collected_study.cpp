#include "study/session/collected_study.h"

#include <algorithm>
#include <memory>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "base/joined.h"
#include "base/random.h"
#include "study/model/new_file.h"
#include "study/model/study_files.h"
#include "study/storage/erasure/erasure_repository.h"
#include "study/storage/map/study_keys.h"
#include "study/storage/statement.h"
#include "study/storage/stored_values.h"
#include "study/storage/study_schema.h"

namespace study {
namespace {

namespace fs = std::filesystem;
using storage::Database;
using storage::Transaction;

/// File of the EventSpool in the folder; it is removed when the trail is written.
constexpr const char* kSpoolFile = "waiting.db";

/// The versions of the protocol that live sessions used.
std::set<ProtocolId> liveProtocols(const Database& study) {
  storage::Statement live(
      study, "SELECT DISTINCT protocol_id FROM session WHERE run_mode = 'live'");
  std::set<ProtocolId> protocols;
  while (live.step()) protocols.insert(ProtocolId{live.number(0)});
  return protocols;
}

}  // namespace

/// The three databases, each in one transaction.
struct CollectedStudy::Files {
  explicit Files(const StudyFiles& names)
      : study(Database::create(names.study(), storage::studySchema())),
        traces(Database::create(names.traces(), storage::traceSchema())),
        identities(Database::create(names.identity(), storage::identitySchema())) {}

  void begin() {
    studyTransaction = std::make_unique<Transaction>(study);
    traceTransaction = std::make_unique<Transaction>(traces.database());
    identityTransaction = std::make_unique<Transaction>(identities.database());
  }
  void commit() {
    identityTransaction->commit();
    traceTransaction->commit();
    studyTransaction->commit();
    studyTransaction.reset();
    traceTransaction.reset();
    identityTransaction.reset();
  }

  Database study;
  storage::TraceStore traces;
  storage::IdentityStore identities;
  std::unique_ptr<Transaction> studyTransaction;
  std::unique_ptr<Transaction> traceTransaction;
  std::unique_ptr<Transaction> identityTransaction;
};

CollectedStudy::CollectedStudy(fs::path folder, Clock& clock, const Origin& origin)
    : target_(std::move(folder)),
      folder_(makeFolderBeside(target_)),
      clock_(clock),
      secret_(origin.secret),
      protocolName_(origin.protocols.at(0).protocol.study.id) {
  fs::create_directory(folder_ / "exports");
  files_ = std::make_unique<Files>(StudyFiles{folder_});
  const bool isOpen = std::ranges::any_of(
      origin.protocols, [](const auto& protocol) { return protocol.protocol.isOpenLabel; });
  if (isOpen) {
    files_->identities.put(origin.secret);
  } else {
    storage::storeStudyKey(origin.secret, target_);
    files_->identities.storeFingerprintSecret(origin.secret.forFingerprints());
    files_->study.setKey(storage::SealingKey(origin.secret.bytes()));
  }
  files_->begin();
  events_ = std::make_unique<storage::EventSpool>((folder_ / kSpoolFile).string());
  storage::ProtocolRepository protocols(files_->study);
  for (const auto& protocol : origin.protocols) {
    protocols.add(protocol, "collected", asUtc(clock.now().wall));
  }
  storage::Statement insert(
      files_->study,
      "INSERT INTO study (id, uuid, seed, random_version, app_version, created_utc) "
      "VALUES (1, ?, ?, ?, ?, ?)");
  insert.bindAll(
      origin.uuid,
      std::to_string(origin.seed),
      base::kRandomVersion,
      appVersion(),
      origin.createdUtc);
  insert.run();
}

CollectedStudy::~CollectedStudy() {
  if (files_ == nullptr) return;
  files_.reset();
  events_.reset();
  std::error_code ignored;
  fs::remove_all(folder_, ignored);  // the study was never complete
}

void CollectedStudy::add(std::int64_t number, const storage::SessionTables& facts) {
  sessions_[number] = storage::addSessionTables(files_->study, facts);
  ++sessionCount_;
}

/// Records as finished an erasure that was done at a station, so that Study::open() does not repeat
/// it.
void CollectedStudy::noteErasure(const storage::StoredEvent& event) {
  const auto row = storage::SessionRepository(files_->study).load(SessionId{*event.session});
  storage::ErasureRepository erasures(files_->study);
  if (erasures.hasErasedAnswersOf(row.participant)) return;
  const auto values = storage::valuesIn(event.detail).value_or(base::NamedArguments{});
  erasures.add(
      {.participant = row.participant,
       .level = storage::erasureLevelNamed(storage::storedText(values, "level"))
                    .value_or(storage::ErasureLevel::Answers),
       .reason = "erased at the station " + row.station,
       .utc = event.utc,
       .finishedUtc = event.utc});
}

void CollectedStudy::add(std::int64_t number, const storage::TraceChunk& chunk) {
  const auto id = sessions_.at(number);
  const auto* key = files_->study.key();
  const auto mode = storage::SessionRepository(files_->study).load(id).runMode;
  const bool isSealed = key != nullptr && mode != RunMode::Simulated;
  storage::addChunk(
      files_->traces.database(), id, isSealed ? storage::sealed(chunk, id, *key) : chunk);
}

void CollectedStudy::addKey(const std::string& participant, const storage::SealingKey& key) {
  files_->identities.putContentKey(participant, key);
}

void CollectedStudy::add(const Trail& trail, std::vector<storage::StoredEvent> events) {
  for (auto& event : events) {
    if (event.session) event.session = static_cast<std::int64_t>(sessions_.at(*event.session));
    if (event.session && event.kind == nameOf(EventKind::Erased)) noteErasure(event);
    lastEventOf_[event.session] = events_->count();
    events_->put(event);
  }
  trails_.push_back(trail);
  sessions_.clear();
}

void CollectedStudy::appendTrail(const std::string& reason) {
  const auto inWords = [](const Trail& trail) {
    return fmt::format("{}: {} events, {}", trail.station.label, trail.events, trail.head);
  };
  storage::EventLog log(files_->study, &files_->identities);
  const Moment now = clock_.now();
  log.append(
      {.when = now,
       .actor = storage::Actor::Operator,
       .kind = EventKind::CollectedStudy,
       .values = {
           {"sessions", static_cast<std::int64_t>(sessionCount_)},
           {"stations", static_cast<std::int64_t>(trails_.size())},
           {"events", static_cast<std::int64_t>(events_->count()) + 1},
           {"trails", base::joined(trails_, ", ", inWords)},
           {"reason", reason}}});
  log.append(
      {.when = now,
       .kind = EventKind::MadeStudy,
       .values = {{"study", protocolName_}, {"secret", secret_.commitment()}}});
  std::size_t place = 0;
  std::optional<std::int64_t> session;  // the session that key belongs to; events of a session are
                                        // adjacent
  std::optional<storage::SealingKey> key;
  const auto append = [&](const storage::StoredEvent& event) {
    if (event.session != session) {
      session = event.session;
      key = session ? log.keyOf(SessionId{*session}) : std::nullopt;
    }
    log.appendFromOtherTrail(
        key ? withDetailUnsealed(event, *key) : event,
        key ? &*key : nullptr,
        lastEventOf_.at(event.session) == place++);
  };
  log.appendMany([&] { events_->forEach(append); });
}

/// The event of a session with its detail unsealed.
storage::StoredEvent CollectedStudy::withDetailUnsealed(
    const storage::StoredEvent& event, const storage::SealingKey& own) const {
  // A detail is sealed with its place in the trail as associated data; here this is the station's
  // trail.
  const SessionId session{*event.session};
  const auto station = storage::SessionRepository(files_->study).load(session).station;
  const storage::SealingKey study(secret_.of(station).bytes());
  auto open = event;
  auto detail = event.sealed.empty() ? std::nullopt : storage::unsealedDetail(event, own, &study);
  if (!detail) return open;
  open.detail = std::move(*detail);
  open.sealed.clear();
  // The trace is sealed with another key here, so its digest differs from the station's.
  if (open.kind == nameOf(EventKind::KeptTrace)) {
    open.detail = files_->traces.digest(
        {session, static_cast<int>(event.step.value()), static_cast<int>(event.attempt.value())});
  }
  return open;
}

void CollectedStudy::finish(const std::string& reason) {
  for (const auto id : liveProtocols(files_->study)) {
    storage::ProtocolRepository(files_->study).freeze(id, asUtc(clock_.now().wall));
  }
  appendTrail(reason);
  events_.reset();
  fs::remove(folder_ / kSpoolFile);
  files_->commit();
  files_.reset();
  {
    auto study = Study::open(folder_, clock_);
    study.transact([&] { study.signTrail(nameOf(EventKind::CollectedStudy)); });
  }
  moveIntoPlace(folder_, target_);
}

}  // namespace study

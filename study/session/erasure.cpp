#include "study/session/erasure.h"

#include <algorithm>
#include <set>

#include "base/text_table.h"
#include "study/model/user_error.h"
#include "study/model/words_of_names.h"
#include "study/session/identity_evidence.h"
#include "study/session/verification.h"
#include "study/storage/erasure/byte_search.h"
#include "study/storage/erasure/erased_rows.h"
#include "study/storage/evidence/station_heads.h"
#include "study/storage/hasher.h"
#include "study/storage/lease.h"
#include "study/storage/statement.h"
#include "study/storage/stored_values.h"
#include "study/words/counted.h"

namespace study {
namespace {

using Key = storage::IdentityStore::Key;
using storage::Erasure;
using storage::StationStore;
using storage::StorageError;

// Shorter texts occur in other people's answers, too, and are not searched for.
constexpr std::size_t kShortestText = 8;  // [bytes]
constexpr std::size_t kShortestName = 4;  // [bytes]

std::vector<storage::SessionRow> sessionsOf(Study& study, const std::string& participant) {
  auto sessions = study.sessions().all();
  std::erase_if(sessions, [&](const auto& row) { return row.participant != participant; });
  return sessions;
}

void requireReason(Study& study, const ErasureRequest& request) {
  if (base::isBlank(request.reason)) {
    throw UserError("Say why, without a name: it stays in the audit trail (--reason \"…\").");
  }
  if (study.identities().isLocked()) return;
  for (const auto& name : study.identities().names(request.participant)) {
    const auto word = wordNaming(request.reason, name.text);
    if (word.empty()) continue;
    throw UserError(
        "'" + word +
        "' is part of what is to be erased, and the reason stays in the audit trail. Give a reason "
        "without it.");
  }
}

void requireErasable(Study& study, const ErasureRequest& request) {
  const auto sessions = sessionsOf(study, request.participant);
  if (sessions.empty()) {
    throw UserError(
        "There is no participant '" + request.participant +
        "' in this study. 'palpate study status' lists the codes.");
  }
  if (sessions.front().runMode == RunMode::Simulated) {
    throw UserError(
        "'" + request.participant +
        "' was simulated: there is no person to erase. To try an erasure, run a pilot (palpate "
        "study "
        "run --pilot) and erase that participant.");
  }
  for (const auto& row : sessions) {
    const auto holder = storage::Lease::holder(study.database(), row.id);
    if (!holder || !holder->isAlive) continue;
    throw StorageError(
        "A session of '" + request.participant + "' is open, on " + holder->station + " (process " +
            std::to_string(holder->pid) + "). Close it there first.",
        StorageError::Kind::Busy);
  }
  requireReason(study, request);
}

bool isSealed(Study& study, const std::string& participant) {
  const auto sessions = sessionsOf(study, participant);
  return std::ranges::none_of(sessions, [&](const auto& row) {
    return storage::hasUnsealedEvents(study.database(), row.id);
  });
}

/// The codes of all participants of live and pilot sessions.
std::set<std::string> participantCodes(Study& study) {
  std::set<std::string> codes;
  for (const auto& row : study.sessions().all()) {
    if (row.runMode != RunMode::Simulated) codes.insert(row.participant);
  }
  return codes;
}

/// Signs the last event of the trail before the trail is sealed again.
std::optional<storage::SignedHead> signLastHead(Study& study) {
  try {
    return storage::signHead(
        study.database(),
        StationStore::openOrCreate(StationStore::defaultFolder()),
        nameOf(EventKind::ResealedTrail),
        asUtc(study.clock().now().wall));
  } catch (const StorageError&) {
    return std::nullopt;  // signTrail() then appends HeadNotSigned
  }
}

/// Notes the last head of the unsealed trail in this station's list only. With it, an older copy
/// can be distinguished from the trail that was sealed again.
void noteLastHead(Study& study, const storage::SignedHead& head) {
  try {
    storage::recordHead(
        StationStore::openOrCreate(StationStore::defaultFolder()), head, study.folder());
  } catch (const StorageError&) {
    return;  // the head of the new trail is noted in any case
  }
}

void verifyAndResealTrail(Study& study, const ErasureRequest& request) {
  // Tampered data must not be sealed, because verification would then accept them.
  if (!verify(study, {}, {.isOlderCopy = request.isRepetition}).isSound()) {
    throw StorageError(
        "The audit trail is not sealed again, because the study is not sound: 'palpate study "
        "verify' says what is wrong. Nothing was changed.",
        StorageError::Kind::Damaged);
  }
  for (const auto& code : participantCodes(study)) {
    if (!study.identities().hasDrawnKeys(code)) {
      study.identities().drawKeys(code);
    } else if (!isSealed(study, code)) {  // setting a passphrase drew the Identity key only
      study.identities().drawMissingKey(Key::Content, code);
    }
  }
  const auto events = study.events();
  const auto head = events.head();
  storage::Hash hash{};
  std::copy_n(head.begin(), std::min(head.size(), hash.size()), hash.begin());
  const auto end = signLastHead(study);
  study.transact([&] {
    study.events().resealEvents(
        {.when = study.clock().now(),
         .actor = storage::Actor::Operator,
         .kind = EventKind::ResealedTrail,
         .values = {
             {"events", events.last()},
             {"head", storage::inHexadecimal(hash)},
             {"reason", request.reason}}});
    study.signTrail(nameOf(EventKind::ResealedTrail));
  });
  if (end) noteLastHead(study, *end);
}

/// Texts (notes, reasons) that operators typed in sessions of this participant, but not in sessions
/// of others.
std::set<std::string> operatorTextsAbout(Study& study, const std::string& participant) {
  std::set<SessionId> theirs;
  for (const auto& row : sessionsOf(study, participant)) theirs.insert(row.id);
  std::set<std::string> texts;
  std::set<std::string> others;
  for (const auto& event : study.events().read()) {
    if (!event.visit || event.actor != storage::Actor::Operator) continue;
    if (event.kind == EventKind::Erased) continue;  // the reason of an erasure is kept
    auto& found = theirs.count(event.visit->session) > 0 ? texts : others;
    found.insert(event.detail);
    const auto reason = storage::storedValue<std::string>(event.values, "reason");
    if (reason) found.insert(*reason);
  }
  for (const auto& text : others) texts.erase(text);
  return texts;
}

/// Ignores what stays in the study with or without the participant: options of questions and other
/// words of the protocol with its files, in all versions, and the reason of this erasure.
void ignoreTextsThatStay(storage::ByteSearch& search, Study& study, const std::string& reason) {
  search.ignorePartsOf(reason);
  const auto protocols = study.protocols();
  for (const auto id : protocols.all()) {
    const auto protocol = protocols.load(id);
    search.ignorePartsOf(protocol.text);
    for (const auto& file : protocol.files) search.ignorePartsOf(file.text);
  }
}

/// The texts by and about the participant that the erasure deletes.
storage::ByteSearch textsOf(Study& study, const ErasureRequest& request) {
  storage::ByteSearch search;
  if (erasesNames(request.level) && !study.identities().isLocked()) {
    for (const auto& name : study.identities().names(request.participant)) {
      search.add(name.text, kShortestName);
    }
  }
  if (erasesAnswers(request.level)) {
    for (const auto& text : storage::textsAbout(study.database(), request.participant)) {
      search.add(text, kShortestText);
    }
    for (const auto& text : operatorTextsAbout(study, request.participant)) {
      search.add(text, kShortestText);
    }
  }
  ignoreTextsThatStay(search, study, request.reason);
  return search;
}

/// Erases the rows and records the erasure, inside a transaction. @return the number of deleted
/// answers
std::int64_t eraseRows(Study& study, Erasure& erasure, bool isRepetition) {
  std::int64_t answers = 0;
  const Moment now = study.clock().now();
  erasure.utc = asUtc(now.wall);
  erasure.id = storage::ErasureRepository(study.database()).add(erasure);
  storage::Event erased{
      .when = now,
      .actor = storage::Actor::Operator,
      .kind = EventKind::Erased,
      .values = {
          {"participant", erasure.participant},
          {"level", std::string(nameOf(erasure.level))},
          {"reason", erasure.reason}}};
  if (isRepetition) erased.values.emplace_back("again", std::int64_t{1});
  if (erasesAnswers(erasure.level)) {
    for (const auto& row : sessionsOf(study, erasure.participant)) {
      answers += storage::eraseAnswers(study.database(), row.id, erasure.utc);
      auto ofSession = erased;
      ofSession.visit = VisitKey{row.id, row.step, row.attempt};
      study.events().append(ofSession);
    }
  }
  study.events().append(erased);
  // If names are kept, their fingerprints were in details that can no longer be opened. Note the
  // fingerprints again.
  const auto keptFingerprints =
      erasesNames(erasure.level) ? std::string() : fingerprintsOf(study, erasure.participant);
  if (!keptFingerprints.empty()) {
    study.events().append(
        {.when = now, .kind = EventKind::NotedIdentities, .values = {{"rows", keptFingerprints}}});
  }
  if (!isRepetition) study.signTrail(nameOf(EventKind::Erased));
  return answers;
}

storage::ListedErasure asListed(Study& study, const Erasure& erasure) {
  return {
      .study = study.uuid(),
      .participant = erasure.participant,
      .enrolledUtc = study.sessions().enrolledUtc(erasure.participant),
      .level = erasure.level,
      .utc = erasure.utc};
}

/// Adds the erasure to this station's list. @return  why it could not be added; empty if it was
std::string listOnStation(const storage::ListedErasure& erasure) {
  try {
    storage::addListedErasure(erasure);
    return {};
  } catch (const StorageError& error) {
    return error.what();
  }
}

/// The part of an erasure outside of its transaction: destroys keys, deletes traces, rebuilds the
/// files without deleted rows. May be repeated after an interruption.
void finish(Study& study, const Erasure& erasure) {
  if (erasesNames(erasure.level)) study.identities().destroy(Key::Identity, erasure.participant);
  if (erasesAnswers(erasure.level)) {
    study.identities().destroy(Key::Content, erasure.participant);
    std::vector<SessionId> sessions;
    for (const auto& row : sessionsOf(study, erasure.participant)) sessions.push_back(row.id);
    storage::eraseTraces(study.traces().database(), sessions);
  }
  storage::purge(study.identities().database());
  storage::purge(study.database());
  if (erasesAnswers(erasure.level)) storage::purge(study.traces().database());
  storage::ErasureRepository(study.database()).finish(erasure.id, asUtc(study.clock().now().wall));
}

ErasureReport eraseParticipant(Study& study, const ErasureRequest& request) {
  ErasureReport report{
      .erasure = {
          .participant = request.participant, .level = request.level, .reason = request.reason}};
  if (erasesAnswers(request.level) && !isSealed(study, request.participant)) {
    if (!request.resealsTrail) {
      throw UserError(
          "An older release wrote the audit trail of this study, with the answers in the open. It "
          "is sealed once, for all participants, before the first of them is erased: back up the "
          "study, then add --reseal. Heads that were noted before are not found in it any more.");
    }
    verifyAndResealTrail(study, request);
    report.wasTrailResealed = true;
  }
  report.texts = textsOf(study, request);
  report.sessions = sessionsOf(study, request.participant).size();
  if (erasesNames(request.level)) {
    report.names = study.identities().count(request.participant);
    report.areNamesLocked = report.names > 0 && study.identities().isLocked();
  }
  study.database().execute("PRAGMA secure_delete = ON");
  study.transact([&] { report.answers = eraseRows(study, report.erasure, request.isRepetition); });
  study.retryWithReservedSpace([&] { finish(study, report.erasure); });
  report.filesWithTexts = report.texts.filesIn(
      study.folder(),
      {&study.database(), &study.traces().database(), &study.identities().database()});
  report.listed = asListed(study, report.erasure);
  return report;
}

}  // namespace

ErasureReport erase(Study& study, const ErasureRequest& request) {
  requireErasable(study, request);
  const auto station = sessionsOf(study, request.participant).front().station;
  auto report = eraseParticipant(study, request);
  if (erasesAnswers(request.level)) report.stationToPush = station;
  report.isInPulledFolder = study.isCollected();
  report.whyNotListed = listOnStation(report.listed);
  return report;
}

void repeatErasure(Study& study, const storage::ListedErasure& erasure) {
  eraseParticipant(
      study,
      {.participant = erasure.participant,
       .level = erasure.level,
       .reason = "erased from another copy on " + erasure.utc,
       .resealsTrail = true,
       .isRepetition = true});
}

bool hasPendingErasures(storage::Database& database) {
  if (!storage::ErasureRepository(database).unfinished().empty()) return true;
  storage::Statement uuid(database, "SELECT uuid FROM study WHERE id = 1");
  return uuid.step() &&
         !storage::erasuresToRepeat(database, storage::listedErasures(uuid.text(0))).empty();
}

void finishPendingErasures(Study& study) {
  for (const auto& erasure : storage::ErasureRepository(study.database()).unfinished()) {
    study.retryWithReservedSpace([&] { finish(study, erasure); });
    listOnStation(asListed(study, erasure));  // the interrupted erasure did not get this far
  }
  const auto listed = storage::listedErasures(study.uuid());
  for (const auto& erasure : storage::erasuresToRepeat(study.database(), listed)) {
    repeatErasure(study, erasure);
  }
}

std::string remarkOnUnsealedTrail(Study& study) {
  std::uint64_t open = 0;
  for (const auto& code : participantCodes(study)) open += isSealed(study, code) ? 0 : 1;
  if (open == 0) return {};
  return "an older release wrote what it says of " +
         words::counted(open, "participant", "participants") +
         " in the open; 'palpate study erase --reseal' seals it";
}

std::vector<std::string> remarksOnErasure(Study& study) {
  std::vector<std::string> remarks;
  for (const auto& event : study.events().read(EventKind::ResealedTrail)) {
    remarks.push_back("it was sealed again on " + asUtc(event.when.wall) + ": " + describe(event));
  }
  if (auto open = remarkOnUnsealedTrail(study); !open.empty()) remarks.push_back(std::move(open));
  for (const auto& erasure : storage::ErasureRepository(study.database()).all()) {
    remarks.push_back(
        erasure.participant + " was erased (" + std::string(nameOf(erasure.level)) + ") on " +
        erasure.utc + ": " + erasure.reason);
  }
  return remarks;
}

}  // namespace study

#include "study/session/verification.h"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <set>

#include "study/model/study_files.h"
#include "study/session/drawn_plan.h"
#include "study/session/erasure.h"
#include "study/session/identity_evidence.h"
#include "study/storage/answer_repository.h"
#include "study/storage/content_hash.h"
#include "study/storage/events_of_release_0_1.h"
#include "study/storage/evidence/head_check.h"
#include "study/storage/evidence/schema_check.h"
#include "study/storage/evidence/witness_file.h"
#include "study/storage/records.h"
#include "study/storage/statement.h"
#include "study/storage/stored_values.h"
#include "study/storage/study_schema.h"

namespace study {
namespace {

using Problems = std::vector<std::string>;

constexpr const char* kTraceCheckTitle = "every trial has its trace, sample for sample";
// estimated share of the duration before traces are read
constexpr double kShareBeforeTraces = 0.2;

std::string nameOf(const VisitKey& visit) {
  return "session " + std::to_string(static_cast<std::int64_t>(visit.session)) + ", step " +
         std::to_string(visit.step + 1) + ", attempt " + std::to_string(visit.attempt);
}

Problems files(Study& study) {
  Problems problems;
  for (auto* database :
       {&study.database(), &study.traces().database(), &study.identities().database()}) {
    const auto found = database->integrityCheckProblems();
    if (!found.empty()) problems.push_back(found);
  }
  return problems;
}

storage::Findings schemas(Study& study) {
  storage::Findings findings;
  const std::array<std::pair<storage::Database*, const storage::Schema*>, 3> all{
      {{&study.database(), &storage::studySchema()},
       {&study.traces().database(), &storage::traceSchema()},
       {&study.identities().database(), &storage::identitySchema()}}};
  for (const auto& [database, schema] : all) {
    auto found = storage::checkSchema(*database, *schema);
    findings.problems.insert(findings.problems.end(), found.problems.begin(), found.problems.end());
  }
  return findings;
}

std::optional<storage::StationStore> thisStation() {
  return storage::StationStore::find(storage::StationStore::defaultFolder());
}

storage::Findings signatures(Study& study) {
  const auto station = thisStation();
  return storage::TrailHeads(study.database())
      .checkSignatures(station ? station->publicKey() : std::string());
}

/// The heads that this station has noted of a study so far, to be compared with its trail.
class StationNotes {
 public:
  explicit StationNotes(const Study& study) {
    try {
      station_ = thisStation();
      if (station_) listed_ = storage::readRecordedHeads(*station_, study.uuid());
    } catch (const storage::StorageError& error) {
      whyNot_ = error.what();
    }
  }

  storage::Findings compareWith(Study& study, bool isOlderCopy) const {
    if (!whyNot_.empty()) return {.problems = {whyNot_}};
    if (!station_) return {.remarks = {"this account has noted nothing of any study"}};
    return storage::checkStation(
        storage::TrailHeads(study.database()), *station_, listed_, isOlderCopy);
  }

 private:
  std::optional<storage::StationStore> station_;
  storage::RecordedHeads listed_;
  std::string whyNot_;
};

std::vector<std::string> remarksOn(Study& study) {
  try {
    return remarksOnErasure(study);
  } catch (const storage::StorageError&) {
    return {};  // a damaged file is reported by the checks
  }
}

/// Checks that the files are undamaged; a remark says if other accounts may read them.
storage::Findings filesAndRights(Study& study) {
  storage::Findings findings{.problems = files(study)};
  if (auto remark = describeOtherAccess(study.folder()); !remark.empty()) {
    findings.remarks.push_back(std::move(remark));
  }
  return findings;
}

Problems auditTrail(Study& study) {
  const auto broken = study.events().firstBreak();
  return broken ? Problems{*broken} : Problems{};
}

/// Compares the hash of the tables with the one in the last event. Events of format 1 have none.
void checkContent(
    Study& study, std::optional<SessionId> session, const std::string& name, Problems& problems) {
  const auto said = study.events().lastContent(session);
  if (!said) {
    problems.push_back("the audit trail knows nothing of " + name);
    return;
  }
  const auto key = said->isSealed ? study.events().keyOf(*session) : std::nullopt;
  if (said->isSealed && !key) {
    problems.push_back(
        "what the audit trail says of " + name + " cannot be read: the key is missing in " +
        study.identities().database().path());
    return;
  }
  const auto& database = study.database();
  const auto found = session ? storage::contentHash(database, *session, key ? &*key : nullptr)
                             : storage::contentHash(database);
  if (!said->hash.empty() && said->hash != storage::asBytes(found)) {
    problems.push_back("the data of " + name + " do not agree with the audit trail");
  }
}

Problems contents(Study& study) {
  Problems problems;
  checkContent(study, {}, "the study itself", problems);
  for (const auto& row : study.sessions().all()) {
    checkContent(study, row.id, row.participant, problems);
  }
  return problems;
}

/// The records without conditions, so that no key is needed. orders() checks the conditions.
storage::Records recordsOf(Study& study) {
  return storage::Records(study.database(), storage::Records::Conditions::LeftOut);
}

/// Whether the event in the audit trail records the answer that the table has.
bool isOf(const storage::Event& event, const GivenAnswer& answer) {
  const bool isOfRelease01 = !event.detail.empty();
  return isOfRelease01 ? event.detail == storage::release_0_1::detailOf(answer)
                       : event.values == storage::valuesOf(answer);
}

/// Checks that the last event about each answer of a session agrees with the table.
void checkAnswers(Study& study, SessionId session, Problems& problems) {
  std::map<std::pair<VisitKey, std::string>, storage::Event> said;
  for (auto& event : study.events().read(session)) {
    if (event.kind == EventKind::Retracted && event.visit) said.erase({*event.visit, event.detail});
    if (event.kind != EventKind::Answered || !event.visit) continue;
    const auto id = storage::storedValue<std::string>(event.values, "item");
    if (!id || event.value("kept_apart") != nullptr) continue;
    const std::pair key{*event.visit, *id};
    said.insert_or_assign(key, std::move(event));
  }
  for (const auto& record : recordsOf(study).answers(session)) {
    const std::pair key{record.step.visit, record.answer.item};
    const auto found = said.find(key);
    if (found == said.end() || !isOf(found->second, record.answer)) {
      problems.push_back(
          "the answer to " + record.answer.item + " (" + nameOf(record.step.visit) +
          ") is not what the audit trail says");
    }
    if (found != said.end()) said.erase(found);
  }
  for (const auto& [key, event] : said) {
    problems.push_back("the answer to " + key.second + " (" + nameOf(key.first) + ") is missing");
  }
}

Problems answers(Study& study) {
  // Includes sessions that only the audit trail or only the table of answers has, and sessions
  // whose own row is missing.
  storage::Statement select(
      study.database(),
      "SELECT session_id FROM event WHERE session_id IS NOT NULL "
      "UNION SELECT session_id FROM answer ORDER BY 1");
  std::vector<SessionId> sessions;
  while (select.step()) sessions.push_back(SessionId{select.number(0)});
  Problems problems;
  for (const auto session : sessions) checkAnswers(study, session, problems);
  return problems;
}

storage::Findings identities(Study& study) {
  if (study.isCollected()) {
    return {.remarks = {"names of people stay at their stations: there are none here to look at"}};
  }
  auto findings = checkIdentities(study);
  if (study.identities().isLocked()) {
    findings.remarks.push_back(
        "names are behind a passphrase: that they are what was written is checked, and not what "
        "they say");
  }
  for (const auto& row : study.identities().damaged()) {
    findings.problems.push_back(
        study.identities().database().path() + ": what is kept of " + row +
        " is not what was written");
  }
  return findings;
}

Problems protocolHashes(Study& study) {
  Problems problems;
  for (const auto id : study.protocols().all()) {
    const auto changes = study.protocols().changes(id);
    problems.insert(problems.end(), changes.begin(), changes.end());
  }
  return problems;
}

std::vector<std::pair<int, std::string>> conditionsOf(const std::vector<Step>& plan) {
  std::vector<std::pair<int, std::string>> conditions;
  for (std::size_t i = 0; i < plan.size(); ++i) {
    if (!plan[i].condition.empty()) conditions.emplace_back(static_cast<int>(i), plan[i].condition);
  }
  return conditions;
}

storage::Findings orders(Study& study) {
  storage::Findings findings;
  const bool canRead = !study.isSealed() || study.hasKey();
  if (canRead) {
    // throws if the secret is lost or wrong, also in a study without sessions
    study.secretFor(RunMode::Live);
  } else {
    findings.remarks.push_back(
        "those of live and pilot sessions are sealed, and this account does not have the key: it "
        "is checked that they are unchanged, but not what they say");
  }
  for (const auto& row : study.sessions().all()) {
    if (study.isSealed() && row.runMode != RunMode::Simulated) {
      // Without the key, a forger can relabel a simulated session as live, but cannot seal its
      // order.
      if (!study.sessions().isSealed(row.id)) {
        findings.problems.push_back("the order of " + row.participant + " is not sealed");
        continue;
      }
      if (!canRead) continue;
    }
    const auto allotted = storage::allocationOf(study.database(), row.id);
    const bool isDrawn =
        allotted == conditionsOf(drawnPlan(study, row)) ||
        (study.isCollected() && allotted == conditionsOf(planFromStudySeed(study, row)));
    if (!isDrawn) {
      findings.problems.push_back(
          "the order of " + row.participant + " is not the one that was drawn");
    }
  }
  return findings;
}

/// The digests of all traces according to the audit trail.
std::map<VisitKey, std::string> keptTraces(Study& study) {
  std::map<VisitKey, std::string> kept;
  for (const auto& event : study.events().read(EventKind::KeptTrace)) {
    if (event.visit) kept[*event.visit] = event.detail;
  }
  return kept;
}

void checkTrace(
    Study& study, const storage::StoredTrial& trial, const std::string& kept, Problems& problems) {
  const auto& visit = trial.step.visit;
  try {
    const auto samples = study.traces().intactSampleCount(visit);
    if (samples != trial.traceSamples) {
      problems.push_back(
          nameOf(visit) + ": " + std::to_string(samples) + " of " +
          std::to_string(trial.traceSamples) + " samples are there");
    }
    if (!kept.empty() && kept != study.traces().digest(visit)) {
      problems.push_back(nameOf(visit) + ": the trace is not the one that was recorded");
    }
  } catch (const storage::StorageError& error) {
    problems.push_back(nameOf(visit) + ": " + error.what());
  }
}

Problems traces(Study& study, const Progress& progress) {
  Problems problems;
  std::set<VisitKey> expected;
  auto kept = keptTraces(study);
  const auto trials = recordsOf(study).trials();
  for (const auto& trial : trials) {
    const double done = static_cast<double>(expected.size()) / static_cast<double>(trials.size());
    announceProgress(
        progress, kShareBeforeTraces + (1.0 - kShareBeforeTraces) * done, kTraceCheckTitle);
    expected.insert(trial.step.visit);
    checkTrace(study, trial, kept[trial.step.visit], problems);
  }
  for (const auto& visit : study.traces().visits()) {
    if (expected.count(visit) > 0) continue;
    const auto session = study.sessions().load(visit.session);
    const bool isUnderWay = session.state == SessionState::InTrial && session.step == visit.step;
    if (!isUnderWay) problems.push_back(nameOf(visit) + ": a trace without a trial");
  }
  return problems;
}

/// While this object exists, the study's connections read its three files in the state of one
/// moment.
class ConsistentSnapshot {
 public:
  explicit ConsistentSnapshot(Study& study)
      : databases_{&study.database(), &study.traces().database(), &study.identities().database()} {
    for (int tries = 0; tries < kMostTries; ++tries) {
      if (takeSnapshots(study)) return;
      end();
    }
    throw storage::StorageError(
        study.folder().string() +
            " is being written all the time, so that its files cannot be compared. Try again when "
            "less goes on.",
        storage::StorageError::Kind::Busy);
  }
  ~ConsistentSnapshot() { end(); }
  ConsistentSnapshot(const ConsistentSnapshot&) = delete;
  ConsistentSnapshot& operator=(const ConsistentSnapshot&) = delete;

 private:
  static constexpr int kMostTries = 1000;

  /// Takes a snapshot of each file; returns whether all are of one moment: every change ends with
  /// an event in study.db, and there is no new one after the last snapshot.
  bool takeSnapshots(Study& study) {
    try {
      for (auto* database : databases_) database->beginSnapshot();
      auto now = storage::Database::open(
          StudyFiles{study.folder()}.study(),
          storage::studySchema(),
          storage::Database::Access::ReadOnly);
      return storage::EventLog(study.database()).last() == storage::EventLog(now).last();
    } catch (const storage::StorageError&) {
      return true;  // a damaged file is reported by the checks
    }
  }

  void end() noexcept {
    for (auto* database : databases_) {
      database->scheduleRollback();
      try {
        database->rollBackIfScheduled();
      } catch (const storage::StorageError&) {
        continue;  // the next transaction of this connection rolls back first
      }
    }
  }

  std::array<storage::Database*, 3> databases_;
};

}  // namespace

std::string describeOtherAccess(const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  std::error_code error;
  const auto rights = fs::status(folder, error).permissions();
  const auto has = [&](fs::perms some) { return (rights & some) != fs::perms::none; };
  // A folder shared with a group is writable for it, and setgid: new files belong to the group.
  const bool isShared = has(fs::perms::set_gid) && has(fs::perms::group_write);
  if (error || (!has(fs::perms::others_all) && (isShared || !has(fs::perms::group_all)))) return {};
  return std::string(
             "other accounts of this computer may enter the folder, and read what is in it. "
             "Close it: chmod -R ") +
         (isShared ? "o-rwx '" : "go-rwx '") + folder.string() + "'";
}

bool Verification::isSound() const noexcept {
  return std::ranges::all_of(checks, [](const Check& check) { return check.problems.empty(); });
}

Verification verify(Study& study, const Progress& progress, const VerifyOptions& options) {
  constexpr double kChecksBeforeTraces = 10.0;
  const StationNotes noted(study);  // before the snapshot, which then has all that was signed
  const ConsistentSnapshot moment(study);
  Verification result;
  const auto runCheck = [&](const char* what,
                            const std::function<storage::Findings(Study&)>& findingsOf) {
    const auto done = static_cast<double>(result.checks.size()) / kChecksBeforeTraces;
    announceProgress(progress, kShareBeforeTraces * done, what);
    storage::Findings found;
    try {
      found = findingsOf(study);
    } catch (const storage::StorageError& error) {
      found.problems.push_back(error.what());
    }
    result.checks.push_back({what, std::move(found.problems), std::move(found.remarks)});
  };
  const auto check = [&](const char* what, const std::function<Problems(Study&)>& problemsOf) {
    runCheck(what, [&](Study& checkedStudy) {
      return storage::Findings{.problems = problemsOf(checkedStudy)};
    });
  };
  runCheck("the database files are whole", filesAndRights);
  runCheck("the structure of the database is unchanged", schemas);
  check("the audit trail is unbroken", auditTrail);
  result.checks.back().remarks = remarksOn(study);
  runCheck("every signature matches the events before it", signatures);
  runCheck(
      "the audit trail continues everything that this station signed",
      [&](Study& checkedStudy) { return noted.compareWith(checkedStudy, options.isOlderCopy); });
  check("all data agree with the audit trail", contents);
  check("every answer is what the audit trail says", answers);
  runCheck("names are as they were entered", identities);
  check("every protocol is what its hash says", protocolHashes);
  runCheck("every order is the one that was drawn", orders);
  if (!options.notedHead.empty()) {
    const bool isHeld = study.events().containsNotedHead(options.notedHead);
    Problems problems;
    if (!isHeld) {
      problems.push_back(
          "no event has the head " + options.notedHead +
          ": the end was cut off since, or the trail was written "
          "anew");
    }
    result.checks.push_back({"the audit trail goes on from what was noted of it", problems});
  }
  if (!options.witness.empty()) {
    const auto witness = storage::readWitness(options.witness);
    runCheck(
        "the audit trail goes on from every head in the witness file", [&](Study& checkedStudy) {
          return checkWitness(storage::TrailHeads(checkedStudy.database()), witness);
        });
  }
  result.head = study.events().headAsText();
  check(kTraceCheckTitle, [&](Study& checkedStudy) { return traces(checkedStudy, progress); });
  return result;
}

}  // namespace study

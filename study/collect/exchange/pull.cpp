#include "study/collect/exchange/pull.h"

#include <algorithm>
#include <future>
#include <memory>
#include <set>
#include <utility>

#include "study/collect/exchange/server_reader.h"
#include "study/collect/exchange/station_trail.h"
#include "study/model/user_error.h"
#include "study/session/collected_study.h"
#include "study/session/verification.h"
#include "study/storage/erasure/erasure_list.h"
#include "study/storage/protocol_repository.h"

namespace study::collect {
namespace {

using storage::StorageError;

bool isErased(const storage::SessionTables& facts) {
  return storage::textIn(facts, "session", "state") == nameOf(SessionState::Erased);
}

/// Adds an erasure of a station to this computer's list of erasures. Copies from earlier pulls
/// repeat the erasures of that list when they are opened next.
void addToErasureList(const std::string& study, const storage::SessionTables& facts) {
  storage::addListedErasure(
      {.study = study,
       .participant = storage::textIn(facts, "participant", "code"),
       .enrolledUtc = storage::textIn(facts, "participant", "created_utc"),
       .level = storage::ErasureLevel::Answers,
       .utc = storage::textIn(facts, "session", "ended_utc")});
}

/// Adds the data of one station to the collected study.
class StationPull {
 public:
  /// Reads the audit trail of the station and verifies it. Any thread.
  StationPull(
      ServerReader& reader,
      const StationRow& station,
      const CollectedStudy::Origin& origin,
      CollectedStudy& study)
      : reader_(reader),
        station_(station),
        studyUuid_(origin.uuid),
        study_(study),
        keys_(reader.keys(station)),
        trail_(origin, station, reader.events(station), keys_) {}

  /// Verifies the sessions of the station, and adds those that are sound.
  PulledStation run() {
    pulled_.label = station_.station.label;
    pulled_.problems = trail_.problems();
    if (const auto part = trail_.describeUnsignedPart(); !part.empty())
      pulled_.problems.push_back(part);
    reader_.forEachSession(station_, [&](const SessionOnServer& session) { take(session); });
    for (const auto& [number, last] : trail_.lastEvents()) {
      if (seenSessions_.count(number) == 0) pulled_.incomplete.push_back(nameOf(number));
    }
    for (const auto& key : keys_) study_.addKey(key.participant, key.key);
    const CollectedStudy::Trail trail{
        .station = station_.station, .events = trail_.signedUpTo(), .head = trail_.head()};
    pulled_.events = trail.events;
    auto events = trail_.takeEvents();
    std::erase_if(events, [&](const storage::StoredEvent& event) {
      return event.session && addedSessions_.count(*event.session) == 0;
    });
    study_.add(trail, std::move(events));
    return std::move(pulled_);
  }

 private:
  static std::string nameOf(std::int64_t session) { return "session " + std::to_string(session); }

  void take(const SessionOnServer& session) {
    seenSessions_.insert(session.number);
    const auto last = trail_.lastEvents().find(session.number);
    if (last == trail_.lastEvents().end() || session.lastEvent > last->second) {
      leaveOut(session.number, "it is not signed");
    } else if (session.lastEvent < last->second) {
      pulled_.incomplete.push_back(nameOf(session.number));
    } else {
      takeSigned(session);
    }
  }

  void takeSigned(const SessionOnServer& session) {
    storage::SessionTables facts;
    std::vector<storage::TraceChunk> chunks;
    std::vector<std::string> problems;
    try {
      if (storage::sha256(session.facts) != session.sha256) {
        problems.emplace_back("its rows differ from their hash");
      }
      facts = sessionTablesIn(session.facts);
      if (session.hasSamples) chunks = reader_.chunks(station_, session.number);
      for (auto& problem : trail_.problemsOf(session.number, session.lastEvent, facts, chunks)) {
        problems.push_back(std::move(problem));
      }
      for (auto& chunk : chunks) {
        chunk = storage::opened(chunk, SessionId{session.number}, trail_.key());
      }
    } catch (const StorageError& error) {
      problems.emplace_back(error.what());
    }
    for (const auto& problem : problems) leaveOut(session.number, problem);
    if (problems.empty()) add(session.number, facts, chunks);
  }

  void leaveOut(std::int64_t session, const std::string& why) {
    pulled_.problems.push_back(nameOf(session) + " is left out: " + why);
  }

  void add(
      std::int64_t number,
      const storage::SessionTables& facts,
      const std::vector<storage::TraceChunk>& chunks) {
    study_.add(number, facts);
    for (const auto& chunk : chunks) {
      pulled_.traceBytes += chunk.data.size();
      study_.add(number, chunk);
    }
    addedSessions_.insert(number);
    ++pulled_.sessions;
    if (!isErased(facts)) return;
    ++pulled_.erased;
    addToErasureList(studyUuid_, facts);
  }

  ServerReader& reader_;
  const StationRow& station_;
  const std::string& studyUuid_;
  CollectedStudy& study_;
  std::vector<SentKey> keys_;
  StationTrail trail_;
  PulledStation pulled_;
  std::set<std::int64_t> seenSessions_;
  std::set<std::int64_t> addedSessions_;
};

/// The problems that 'study verify' finds.
std::vector<std::string> problemsOf(
    const std::filesystem::path& folder, Clock& clock, const Progress& progress) {
  auto study = Study::open(folder, clock, storage::Database::Access::ReadOnly);
  std::vector<std::string> problems;
  for (const auto& check : verify(study, progress).checks) {
    for (const auto& problem : check.problems) problems.push_back(check.what + ": " + problem);
  }
  return problems;
}

}  // namespace

bool PullResult::isSound() const noexcept {
  return problems.empty() && std::ranges::all_of(stations, [](const PulledStation& station) {
           return station.problems.empty();
         });
}

std::size_t PullResult::sessions() const noexcept {
  std::size_t sessions = 0;
  for (const auto& station : stations) sessions += station.sessions;
  return sessions;
}

PullResult pull(
    Connection& server, const PullRequest& request, Clock& clock, const Progress& progress) {
  std::error_code error;
  if (std::filesystem::exists(request.folder, error)) {
    throw UserError(
        request.folder.string() +
        " is there already. Nothing is ever overwritten: choose another folder.");
  }
  ServerReader reader(server, request.study, request.reason);
  const Snapshot snapshot(server);
  const auto origin = reader.origin();
  CollectedStudy study(request.folder, clock, origin);
  PullResult pulled;
  const auto stations = reader.stations();
  // While the sessions of one station are added, another thread verifies the trail of the next.
  const auto verifyTrail = [&](std::size_t i) {
    return std::async(std::launch::async, [&, i] {
      return std::make_unique<StationPull>(reader, stations[i], origin, study);
    });
  };
  std::future<std::unique_ptr<StationPull>> next;
  if (!stations.empty()) next = verifyTrail(0);
  for (std::size_t i = 0; i < stations.size(); ++i) {
    announceProgress(
        progress,
        static_cast<double>(i) / static_cast<double>(stations.size()),
        stations[i].station.label);
    const auto station = next.get();
    if (i + 1 < stations.size()) next = verifyTrail(i + 1);
    pulled.stations.push_back(station->run());
  }
  study.finish(request.reason);
  pulled.problems = problemsOf(request.folder, clock, progress);
  return pulled;
}

}  // namespace study::collect

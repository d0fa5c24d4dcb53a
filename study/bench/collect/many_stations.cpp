#include "study/bench/collect/many_stations.h"

#include <utility>

#include <fmt/format.h>

#include "study/app/command_options.h"
#include "study/cohort/simulated_participant.h"
#include "study/collect/app/options.h"
#include "study/collect/exchange/administration.h"
#include "study/collect/exchange/enrolment.h"
#include "study/collect/exchange/push.h"
#include "study/collect/server/schema.h"
#include "study/model/new_file.h"

namespace study::bench {
namespace {

namespace fs = std::filesystem;
using collect::Connection;

constexpr const char* kProtocolOfSites = "punch-counterbalanced";
constexpr const char* kStudy = "bench";
constexpr std::uint64_t kSeedOfSites = 20'261'125;

std::int64_t answersIn(const storage::SessionTables& facts) {
  const auto rows = facts.find("answer");
  return rows == facts.end() ? 0 : static_cast<std::int64_t>(rows->second.size());
}

/// Sends all data of a folder as 'palpate collect push' does. Returns amounts and times.
StationPush pushAll(collect::Outbox& outbox, Connection& server) {
  StationPush sent;
  WorkWatch watch(server);
  outbox.forEachBatch(0, [&](const collect::Batch& batch) {
    const auto text = collect::asText(batch);
    std::vector<std::vector<std::byte>> chunks;
    for (const auto& each : batch.chunks) {
      sent.traceBytes += each.chunk.data.size();
      chunks.push_back(each.chunk.data);
    }
    sent.reading += watch.elapsed();
    watch.start();
    const auto answer = collect::ingest(server, text, chunks);
    (chunks.empty() ? sent.ingesting : sent.traces) += watch.elapsed();
    if (!answer.refused.empty()) throw UserError(collect::wordsFor(answer));
    sent.events += static_cast<std::int64_t>(batch.events.size());
    for (const auto& session : batch.sessions) {
      sent.answers += answersIn(collect::sessionTablesIn(session.facts));
    }
    watch.start();
    return true;
  });
  return sent;
}

}  // namespace

ManyStations::ManyStations(
    const collect::PrivateServer& postgres, fs::path folder, int participants)
    : postgres_(postgres),
      folder_(std::move(folder)),
      protocol_(app::loadValidProtocol(kProtocolOfSites)) {
  Connection owner(postgres_.server());
  collect::installSchema(owner);
  collect::addStudyOrVersion(owner, kStudy, protocol_, kSeedOfSites);
  recorded_ = run(kRecorded, [&](Study& study) { record(study, participants); });
}

std::string ManyStations::labelOf(int number) {
  return "site" + std::to_string(number);
}

StationPush ManyStations::add(int number, std::int64_t answers) {
  const auto label = labelOf(number);
  return run(label, [&](Study& study) { repeat(study, label, answers); });
}

StationPush ManyStations::run(
    const std::string& label, const std::function<void(Study&)>& work) const {
  const TemporaryFolder own(folder_);
  const collect::StationFolderOverride account(own / "account");
  const auto station = storage::StationStore::openOrCreate(storage::StationStore::defaultFolder());
  std::string role;
  {
    Connection owner(postgres_.server());
    const auto enrolled = collect::enrolStation(
        owner, {.study = kStudy, .site = label, .label = label, .key = station.publicKey()});
    writeNewFile(own / "enrolment", enrolled.file);
    role = enrolled.role;
  }
  SimulatedClock clock;
  collect::join(own / "enrolment", own / "study", clock);
  {
    auto study = Study::open(own / "study", clock);
    work(study);
  }
  collect::Outbox outbox(own / "study", clock);
  Connection server(postgres_.server(), role);
  return pushAll(outbox, server);
}

void ManyStations::record(Study& study, int participants) {
  SimulatedClock clock;
  simulateCohorts(study, clock, participants, kSeedOfSites, [](const auto&) {});
  study.transact([&] { study.signTrail("simulated"); });
  const auto events = study.events().stored(0, study.events().last());
  for (const auto& row : study.sessions().all()) {
    RecordedSession session{
        .facts = storage::sessionTablesOf(study.database(), row.id), .events = {}};
    session.facts["trial"].clear();
    session.facts["cut"].clear();
    for (const auto& event : events) {
      const bool isOfTrial = event.kind == nameOf(EventKind::KeptTrace);
      if (event.session == static_cast<std::int64_t>(row.id) && !isOfTrial) {
        session.events.push_back(event);
      }
    }
    sessions_.push_back(std::move(session));
  }
}

void ManyStations::repeat(Study& study, const std::string& label, std::int64_t answers) const {
  study.transact([&] {
    auto log = study.events();
    std::int64_t number = 0;
    for (std::int64_t left = answers; left > 0; ++number) {
      const auto& recorded = sessions_[static_cast<std::size_t>(number) % sessions_.size()];
      auto facts = recorded.facts;
      auto& session = facts["session"].front();
      session["slot"] = number;
      session["site"] = label;
      session["station"] = label;
      facts["participant"].front()["code"] = fmt::format("{}_S{:04d}", label, number + 1);
      const auto id = storage::addSessionTables(study.database(), facts);
      for (const auto& event : recorded.events) {
        auto own = event;
        own.session = static_cast<std::int64_t>(id);
        log.appendFromOtherTrail(own, nullptr, &event == &recorded.events.back());
      }
      left -= answersIn(facts);
    }
    study.signTrail("simulated");
  });
}

}  // namespace study::bench

#include "tests/study/collect/collected_study_at.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <memory>

#include "study/cohort/simulated_participant.h"
#include "study/collect/exchange/administration.h"
#include "study/collect/exchange/enrolment.h"
#include "study/collect/server/registry.h"
#include "study/collect/server/schema.h"
#include "study/storage/protocol_repository.h"
#include "study/storage/study_schema.h"
#include "study/storage/transfer/session_facts.h"
#include "tests/study/walk.h"

namespace tests {
namespace {

using study::collect::Connection;
using study::collect::PrivateServer;

constexpr const char* kStudy = "short";

std::unique_ptr<PrivateServer>& server() {
  static std::unique_ptr<PrivateServer> made;
  return made;
}

std::string nameOf(const study::storage::SessionTables& facts) {
  return std::get<std::string>(facts.at("participant").front().at("code")) + "/" +
         std::to_string(std::get<std::int64_t>(facts.at("session").front().at("number")));
}

/// Chunks of a trial without their seal, by the digest of the store.
std::string digestOf(
    const std::vector<study::storage::TraceChunk>& chunks,
    study::SessionId session,
    const study::storage::SealingKey& key) {
  auto traces = study::storage::Database::inMemory(study::storage::traceSchema());
  for (const auto& chunk : chunks) {
    study::storage::addChunk(traces, session, study::storage::opened(chunk, session, key));
  }
  const auto& first = chunks.front();
  return study::storage::TraceStore(std::move(traces)).digest({session, first.step, first.attempt});
}

}  // namespace

PrivateServer& CollectTest::postgres() {
  if (server() == nullptr)
    server() = std::make_unique<PrivateServer>(PrivateServer::Disk::WithoutFsync);
  return *server();
}

void CollectTest::SetUp() {
  if (!PrivateServer::isInstalled()) GTEST_SKIP() << "PostgreSQL is not installed";
  static int number = 0;
  database_ = "test_" + std::to_string(++number);
  Connection(postgres().server()).execute("CREATE DATABASE " + database_);
  auto owner = admin();
  study::collect::installSchema(owner);
  study::collect::addStudyOrVersion(owner, kStudy, protocolFrom(shortProtocol()), 1);
}

Connection CollectTest::admin() const {
  return Connection(postgres().server(database_));
}

Connection CollectTest::as(const std::string& role) const {
  return Connection(postgres().server(database_), role);
}

void CollectTest::addStation(const std::string& site, const std::string& label) {
  const auto name = label.empty() ? site : label;
  const auto account = accountOf(name);
  const auto station =
      study::storage::StationStore::openOrCreate(study::storage::StationStore::defaultFolder());
  auto owner = admin();
  const auto enrolled = study::collect::enrolStation(
      owner, {.study = kStudy, .site = site, .label = label, .key = station.publicKey()});
  const auto file = scratch_.write(name + ".enrolment", enrolled.file);
  study::collect::join(file, folderOf(name), clock_);
}

void CollectTest::simulate(const std::string& label, int participants, std::uint64_t seed) {
  const auto account = accountOf(label);
  auto study = study::Study::open(folderOf(label), clock_);
  study::simulateCohorts(study, clock_, participants, seed, [](const auto&) {});
  study.transact([&] { study.signTrail("simulated"); });
}

void CollectTest::feelAll(study::Study& study, study::Session& session, int trials) {
  for (; trials > 0; --trials) {
    walkTo(session, study::StepKind::Trial);
    if (session.isOver()) return;
    auto record = feltTrial(std::max(2, session.step().minimumCuts));
    record.duration = 4.125;
    record.ticks = 4125;
    record.latenessP99 = 3.0;  // a whole number, and no integer
    record.slewed = 1.0 / 3.0;
    record.largestForce = 6.02;
    record.traceSamples = 500;
    record.safety.push_back({study::SafetyKind::Slewed, 2, 1.0 / 3.0});
    auto& cut = record.cuts.back();
    cut.interception = {.travel = 4.0, .force = -0.0, .found = true};
    cut.yield = {.travel = 9.5, .force = 5.75, .found = true};
    cut.peakForce = 6.02;
    session.beginTrial();
    const std::vector<study::storage::TraceSample> samples(500, {.tick = 7, .force = 5.0F});
    study.traces().add(session.visit(), 0, samples);
    session.finishTrial(record);
  }
}

std::string CollectTest::runSession(const std::string& label, const std::string& code) {
  const auto account = accountOf(label);
  auto study = study::Study::open(folderOf(label), clock_);
  auto session = consenting(study, {.cohort = "surgeons", .code = code});
  feelAll(study, session);
  clock_.advance(60.0);
  return session.participant();
}

study::collect::PushResult CollectTest::push(const std::string& label) const {
  return pushFrom(folderOf(label), label);
}

study::collect::PullResult CollectTest::pull(const std::string& name) const {
  const auto account = accountOf("analyst");
  auto server = admin();
  return study::collect::pull(
      server, {.folder = folderOfPull(name), .reason = "to evaluate"}, clock_);
}

study::collect::PushResult CollectTest::pushFrom(
    const std::string& folder, const std::string& label) const {
  const auto account = accountOf(label);
  study::collect::Outbox outbox(folder, clock_);
  auto connection = as(study::collect::serverSettingsOf(folder).role);
  return study::collect::push(outbox, connection);
}

study::collect::PushResult CollectTest::pushOver(
    const std::string& label, const std::string& server, std::chrono::milliseconds patience) const {
  const auto account = accountOf(label);
  study::collect::Outbox outbox(folderOf(label), clock_);
  Connection connection(server, study::collect::serverSettingsOf(folderOf(label)).role);
  connection.setResponseTimeout(patience);
  return study::collect::push(outbox, connection);
}

std::map<std::string, std::string> CollectTest::contentOf(
    const std::vector<std::string>& folders) const {
  std::map<std::string, std::string> content;
  study::SimulatedClock clock;
  for (const auto& folder : folders) {
    // Whoever runs or pulls a study has the key of its conditions.
    const auto name = std::filesystem::path(folder).filename().string();
    const auto account =
        accountOf(name.starts_with("study-") ? name.substr(std::strlen("study-")) : "analyst");
    auto study = study::Study::open(folder, clock, study::storage::Database::Access::ReadOnly);
    std::map<study::SessionId, std::string> names;
    for (const auto& row : study.sessions().all()) {
      const auto facts = study::storage::sessionTablesOf(study.database(), row.id);
      names[row.id] = nameOf(facts);
      content[nameOf(facts)] = study::storage::sha256(study::collect::asText(facts));
    }
    for (const auto& visit : study.traces().visits()) {
      const auto place = names.at(visit.session) + "/" + std::to_string(visit.step) + "/" +
                         std::to_string(visit.attempt);
      content[place] = digestOf(
          study::storage::chunksOf(study.traces().database(), visit),
          visit.session,
          *study.database().key());
    }
  }
  return content;
}

std::map<std::string, std::string> CollectTest::contentOfServer() const {
  std::map<std::string, std::string> content;
  auto owner = admin();
  const auto sessions = owner.query(
      "SELECT participant, (facts::json->'session'->>'number'), encode(sha256, 'hex'), facts "
      "FROM palpate.session");
  for (int i = 0; i < sessions.count(); ++i) {
    content[sessions.text(i, 0) + "/" + sessions.text(i, 1)] = sessions.text(i, 2);
    EXPECT_EQ(study::storage::sha256(sessions.text(i, 3)), sessions.text(i, 2));
  }
  const auto rows = owner.query(
      "SELECT s.participant, s.facts::json->'session'->>'number', c.step, c.attempt, c.number, "
      "c.samples, c.layout, c.data, c.hash, c.session, x.label "
      "FROM palpate.chunk AS c JOIN palpate.session AS s ON s.station = c.station AND s.number = "
      "c.session JOIN palpate.station AS x ON x.id = c.station ORDER BY c.number");
  std::map<std::string, std::vector<study::storage::TraceChunk>> chunks;
  std::map<std::string, std::pair<std::string, study::SessionId>> origins;
  for (int i = 0; i < rows.count(); ++i) {
    const auto place =
        rows.text(i, 0) + "/" + rows.text(i, 1) + "/" + rows.text(i, 2) + "/" + rows.text(i, 3);
    origins[place] = {rows.text(i, 10), study::SessionId{rows.number(i, 9)}};
    chunks[place].push_back(
        {.step = static_cast<int>(rows.number(i, 2)),
         .attempt = static_cast<int>(rows.number(i, 3)),
         .number = rows.number(i, 4),
         .samples = rows.number(i, 5),
         .layout = rows.number(i, 6),
         .data = rows.bytes(i, 7),
         .hash = rows.bytes(i, 8)});
  }
  for (const auto& [place, origin] : origins) {
    content[place] = digestOf(chunks.at(place), origin.second, keyOf(origin.first));
  }
  return content;
}

/// With which a station seals what tells conditions.
study::storage::SealingKey CollectTest::keyOf(const std::string& label) const {
  auto owner = admin();
  const auto row = study::collect::findStudy(owner, kStudy);
  study::storage::BlindingSecret::Bytes secret{};
  std::transform(row.secret.begin(), row.secret.end(), secret.begin(), [](std::byte b) {
    return std::to_integer<unsigned char>(b);
  });
  return study::storage::SealingKey(study::storage::BlindingSecret(secret).of(label).bytes());
}

std::vector<std::string> CollectTest::incidents() const {
  auto owner = admin();
  std::vector<std::string> found;
  for (const auto& incident : study::collect::incidentsOf(owner, 100))
    found.push_back(incident.what);
  return found;
}

}  // namespace tests

// A server whose disk is full, of another release, under attack; stations with wrong clocks, and
// two with one past.
#include <sys/mount.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <memory>

#include "study/collect/exchange/administration.h"
#include "study/collect/exchange/bundle.h"
#include "study/collect/exchange/enrolment.h"
#include "study/collect/exchange/pull.h"
#include "study/collect/server/registry.h"
#include "study/collect/server/schema.h"
#include "study/model/user_error.h"
#include "study/session/verification.h"
#include "study/storage/protocol_repository.h"
#include "tests/study/collect/collected_study_at.h"
#include "tests/study/walk.h"

namespace server_faults_test {

namespace fs = std::filesystem;
using study::Study;
using study::collect::Connection;
using study::collect::Parameter;
using study::collect::PrivateServer;
using study::collect::ServerError;

class ServerFaults : public tests::CollectTest {
 protected:
  /// What the person at the desk reads; empty: everything arrived.
  std::string saidByAPush(ServerError::Kind expected) {
    try {
      push("oslo");
    } catch (const ServerError& error) {
      EXPECT_EQ(error.kind(), expected) << error.what();
      return error.what();
    }
    ADD_FAILURE() << "it arrived";
    return {};
  }

  /// The rows of all tables, to see whether something was changed.
  std::string rowsOfServer() {
    auto owner = admin();
    std::string rows;
    for (const auto* table : {"study", "protocol", "event", "session", "fact", "chunk"}) {
      rows += owner
                  .query(
                      std::string("SELECT coalesce(string_agg(md5(t::text), '' ORDER BY t::text), "
                                  "'') FROM palpate.") +
                      table + " AS t")
                  .text(0, 0);
    }
    return rows;
  }

  std::string pulled() {
    pull();
    return folderOfPull();
  }

  bool isSound(const std::string& folder) {
    const auto account = accountOf("analyst");
    auto study = Study::open(folder, clock_, study::storage::Database::Access::ReadOnly);
    return study::verify(study).isSound();
  }

  std::string answerTo(const std::string& batch) {
    auto station = as("station_oslo");
    const auto said = station.query(
        "SELECT palpate.ingest($1, sha256(convert_to($1, 'UTF8')), $2)",
        {batch, Parameter::arrayOfBytes({})});
    return study::collect::answerIn(said.text(0, 0)).refused;
  }
};

/// A small disk for the server.
class SmallDisk {
 public:
  explicit SmallDisk(const fs::path& folder, int megabytes = 8) : folder_(folder) {
    const auto size = "size=" + std::to_string(megabytes) + "m";
    struct stat owner {};
    fs::create_directory(folder_);
    isThere_ = stat(folder_.parent_path().c_str(), &owner) == 0 &&
               mount("palpate", folder_.c_str(), "tmpfs", 0, size.c_str()) == 0 &&
               chown(folder_.c_str(), owner.st_uid, owner.st_gid) == 0;
  }
  ~SmallDisk() {
    if (isThere_) umount2(folder_.c_str(), MNT_DETACH);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

  bool isThere() const noexcept { return isThere_; }
  /// Leaves only @p bytes.
  void fill(std::uint64_t bytes) const {
    const auto left = fs::space(folder_).available;
    const std::string block(left > bytes ? left - bytes : 0, 'x');
    std::ofstream(folder_ / "other data") << block;
  }
  void free() const { fs::remove(folder_ / "other data"); }

 private:
  fs::path folder_;
  bool isThere_ = false;
};

TEST_F(ServerFaults, AFullDiskIsSaidInWordsAndNothingIsLost) {
  const SmallDisk disk(postgres().folder() / "small");
  if (!disk.isThere()) GTEST_SKIP() << "a disk can be mounted by root alone";
  admin().execute(
      "CREATE TABLESPACE small LOCATION '" + (postgres().folder() / "small").string() + "'");
  for (const auto* table : {"chunk", "event", "session"}) {
    admin().execute(std::string("ALTER TABLE palpate.") + table + " SET TABLESPACE small");
  }
  addStation("oslo");
  runSession("oslo");
  push("oslo");
  const auto before = rowsOfServer();
  simulate("oslo", 3);
  disk.fill(20'000);
  const auto said = saidByAPush(ServerError::Kind::Full);
  EXPECT_NE(said.find("is full. Nothing is lost"), std::string::npos) << said;
  EXPECT_EQ(rowsOfServer(), before);
  disk.free();
  push("oslo");
  EXPECT_EQ(contentOfServer(), contentOf({folderOf("oslo")}));
  EXPECT_EQ(contentOf({pulled()}), contentOf({folderOf("oslo")}));
  EXPECT_TRUE(isSound(folderOfPull()));
  for (const auto* table : {"chunk", "event", "session"}) {
    admin().execute(std::string("ALTER TABLE palpate.") + table + " SET TABLESPACE pg_default");
  }
  admin().execute("DROP TABLESPACE small");
}

/// Tests with a server of their own, which they may stop, fill, and install as another role.
class OwnServer : public ServerFaults {
 protected:
  void SetUp() override {
    ServerFaults::SetUp();
    if (!IsSkipped()) own_ = std::make_unique<PrivateServer>(PrivateServer::Disk::WithoutFsync);
  }

  /// Installs a study, and enrols oslo.
  void install(const std::string& role) {
    Connection owner(own_->server("postgres"), role);
    study::collect::installSchema(owner);
    study::collect::addStudyOrVersion(
        owner, "short", tests::protocolFrom(tests::shortProtocol()), 1);
    const auto account = accountOf("oslo");
    const auto station =
        study::storage::StationStore::openOrCreate(study::storage::StationStore::defaultFolder());
    const auto enrolled =
        study::collect::enrolStation(owner, {.site = "oslo", .key = station.publicKey()});
    study::collect::join(scratch_.write("enrolment", enrolled.file), folderOf("oslo"), clock_);
  }

  void pushThere() {
    const auto account = accountOf("oslo");
    study::collect::Outbox outbox(folderOf("oslo"), clock_);
    Connection station(own_->server("postgres"), "station_oslo");
    study::collect::push(outbox, station);
  }

  void expectThatAPullHasEverything(const std::string& role) {
    {
      const auto account = accountOf("analyst");
      Connection owner(own_->server("postgres"), role);
      study::collect::pull(owner, {.folder = folderOfPull(), .reason = "to evaluate"}, clock_);
    }
    EXPECT_EQ(contentOf({folderOfPull()}), contentOf({folderOf("oslo")}));
    EXPECT_TRUE(isSound(folderOfPull()));
  }

  std::unique_ptr<PrivateServer> own_;
};

TEST_F(OwnServer, IsInstalledAndPulledFromByARoleThatMayCreateRolesAndDatabases) {
  Connection(own_->server())
      .execute(
          "CREATE ROLE anna LOGIN CREATEDB CREATEROLE;"
          "GRANT CREATE ON DATABASE postgres TO anna");
  install("anna");
  runSession("oslo");
  pushThere();
  expectThatAPullHasEverything("anna");
}

TEST_F(OwnServer, ThatStopsBecauseItsDiskIsFullHasEverythingAfterwards) {
  const auto log = own_->folder() / "data" / "pg_wal";
  const auto small = own_->folder() / "small";
  const SmallDisk disk(small, 40);  // two files of its log
  if (!disk.isThere()) GTEST_SKIP() << "a disk can be mounted by root alone";
  install("postgres");
  runSession("oslo");
  pushThere();
  own_->stop();
  struct stat owner {};
  ASSERT_EQ(stat(log.c_str(), &owner), 0);
  fs::copy(log, small / "log", fs::copy_options::recursive);
  fs::remove_all(log);
  fs::create_symlink(small / "log", log);
  ASSERT_EQ(chown((small / "log").c_str(), owner.st_uid, owner.st_gid), 0);
  for (const auto& file : fs::recursive_directory_iterator(small / "log")) {
    ASSERT_EQ(chown(file.path().c_str(), owner.st_uid, owner.st_gid), 0);
  }
  own_->start();
  disk.fill(100'000);
  runSession("oslo");
  Connection(own_->server()).query("SELECT pg_switch_wal()");
  try {
    pushThere();
    ADD_FAILURE() << "it arrived";
  } catch (const ServerError& error) {
    EXPECT_NE(std::string(error.what()).find("Nothing is lost"), std::string::npos) << error.what();
  }
  EXPECT_NE(
      tests::contentOf(own_->folder() / "server.log").find("PANIC:  could not"), std::string::npos);
  own_->stop(PrivateServer::Stop::Immediate);
  disk.free();
  own_->start();
  pushThere();
  expectThatAPullHasEverything("postgres");
  own_.reset();  // before the disk
}

TEST_F(ServerFaults, ANewerSchemaIsRefusedAndNotWrittenTo) {
  addStation("oslo");
  runSession("oslo");
  push("oslo");
  runSession("oslo");
  const auto steps = [&](const std::string& change) {
    admin().execute(change);
    const auto before = rowsOfServer();
    const auto said = saidByAPush(ServerError::Kind::Release);
    EXPECT_EQ(rowsOfServer(), before);
    return said;
  };
  EXPECT_NE(
      steps("INSERT INTO palpate.schema_step (step) VALUES (99)").find("newer than this program"),
      std::string::npos);
}

/// A server at each earlier step. Step 2 can take in, and give nothing out.
class OlderServer : public ServerFaults, public testing::WithParamInterface<int> {};

TEST_P(OlderServer, IsBroughtUpToDateWithWhatIsInIt) {
  const int before = GetParam();
  auto owner = admin();
  owner.execute("DROP SCHEMA palpate CASCADE");
  owner.execute(
      "CREATE SCHEMA palpate AUTHORIZATION palpate_owner; SET ROLE palpate_owner;"
      "SET search_path = palpate, pg_temp;"
      "CREATE TABLE schema_step (step integer PRIMARY KEY, installed timestamptz DEFAULT now());"
      "GRANT USAGE ON SCHEMA palpate TO palpate_station;"
      "GRANT SELECT ON schema_step TO palpate_station;");
  const auto steps = study::collect::schemaSteps();
  for (int step = 1; step <= before; ++step) {
    owner.execute(std::string(steps[static_cast<std::size_t>(step) - 1].content));
    owner.query("INSERT INTO schema_step (step) VALUES ($1)", {std::int64_t{step}});
  }
  owner.execute("RESET ROLE; RESET search_path");
  study::collect::addStudyOrVersion(owner, "short", tests::protocolFrom(tests::shortProtocol()), 1);
  addStation("oslo");
  runSession("oslo");
  {
    const auto account = accountOf("oslo");
    study::collect::Outbox outbox(folderOf("oslo"), clock_);
    auto station = as("station_oslo");
    outbox.forEachBatch(0, [&](const study::collect::Batch& batch) {
      return study::collect::ingest(station, batch).refused.empty();
    });
  }
  EXPECT_EQ(contentOfServer(), contentOf({folderOf("oslo")}));
  runSession("oslo");
  EXPECT_NE(
      saidByAPush(ServerError::Kind::Release).find("older than this program"), std::string::npos);
  EXPECT_EQ(study::collect::installSchema(owner), before);
  push("oslo");
  EXPECT_EQ(contentOfServer(), contentOf({folderOf("oslo")}));
  EXPECT_EQ(contentOf({pulled()}), contentOf({folderOf("oslo")}));
  EXPECT_TRUE(isSound(scratch_ / "union"));
}

INSTANTIATE_TEST_SUITE_P(OfStep, OlderServer, testing::Values(2, 3));

TEST_F(ServerFaults, AStationThatIsEnrolledAfterTheProtocolWasChangedHasTheNewestOne) {
  addStation("oslo");
  runSession("oslo");
  push("oslo");
  auto text = tests::shortProtocol();
  const std::string version = R"("version": "1")";
  text.replace(text.find(version), version.size(), R"("version": "2")");
  const auto newest = tests::protocolFrom(text);
  auto owner = admin();
  using Added = study::collect::AddedToServer;
  const auto add = [&] { return study::collect::addStudyOrVersion(owner, "short", newest, {}); };
  EXPECT_EQ(add(), Added::Version);
  EXPECT_EQ(add(), Added::Nothing);
  addStation("bergen");
  runSession("bergen");
  push("bergen");
  // The other one takes it over later.
  {
    const auto account = accountOf("oslo");
    auto study = Study::open(folderOf("oslo"), clock_);
    study.amend(newest, "as at the other sites");
  }
  runSession("oslo");
  push("oslo");
  EXPECT_EQ(contentOf({pulled()}), contentOf({folderOf("oslo"), folderOf("bergen")}));
  EXPECT_TRUE(isSound(scratch_ / "union"));
  const auto versions = owner.query(
      "SELECT x.participant, x.protocol = $1 FROM palpate.session AS x ORDER BY 1",
      {study::storage::sha256(newest.text, newest.files)});
  ASSERT_EQ(versions.count(), 3);
  EXPECT_EQ(versions.text(0, 1), "t") << versions.text(0, 0);
  EXPECT_EQ(versions.text(1, 1), "f") << versions.text(1, 0);
  EXPECT_EQ(versions.text(2, 1), "t") << versions.text(2, 0);
}

TEST_F(ServerFaults, AnotherStudysProtocolIsNoVersionAndTheLastOneAddedIsNewest) {
  const auto changed = [](const std::string& from, const std::string& to) {
    auto text = tests::shortProtocol();
    text.replace(text.find(from), from.size(), to);
    return tests::protocolFrom(text);
  };
  auto owner = admin();
  EXPECT_THROW(
      study::collect::addStudyOrVersion(
          owner, "short", changed(R"("id": "short")", R"("id": "another")"), std::nullopt),
      study::UserError);
  const auto second = changed(R"("version": "1")", R"("version": "2")");
  study::collect::addStudyOrVersion(owner, "short", second, std::nullopt);
  study::collect::addStudyOrVersion(
      owner, "short", tests::protocolFrom(tests::shortProtocol()), std::nullopt);
  const auto study = study::collect::findStudy(owner, "short").uuid;
  EXPECT_NE(study::collect::protocolsOf(owner, study).back().text, second.text);
}

TEST_F(ServerFaults, AClockThatIsAYearOffChangesNoOrder) {
  constexpr std::int64_t kYear = std::int64_t{365} * 24 * 3600 * 1000;  // [ms]
  addStation("oslo");
  addStation("bergen");
  const auto now = clock_.now().wall;
  for (const auto wrong : {now + kYear, now - kYear, now}) {
    clock_.setWall(wrong);
    runSession("oslo");
    push("oslo");
  }
  runSession("bergen");
  push("bergen");
  EXPECT_EQ(contentOfServer(), contentOf({folderOf("oslo"), folderOf("bergen")}));
  EXPECT_EQ(contentOf({pulled()}), contentOf({folderOf("oslo"), folderOf("bergen")}));
  EXPECT_TRUE(isSound(scratch_ / "union"));
  EXPECT_TRUE(incidents().empty());
}

TEST_F(ServerFaults, AnEnrolmentThatIsTooOldSaysWhatTheClockShows) {
  const auto account = accountOf("oslo");
  const auto station =
      study::storage::StationStore::openOrCreate(study::storage::StationStore::defaultFolder());
  auto owner = admin();
  const auto enrolled =
      study::collect::enrolStation(owner, {.site = "oslo", .key = station.publicKey()});
  study::SimulatedClock wrong(4'000'000'000'000);  // 2096
  try {
    study::collect::join(scratch_.write("file", enrolled.file), folderOf("oslo"), wrong);
    FAIL() << "it was used";
  } catch (const study::UserError& error) {
    EXPECT_NE(std::string(error.what()).find("clock shows 2096-"), std::string::npos);
  }
  // A clock that is slow does not help: the server's counts.
  study::collect::join(scratch_ / "file", folderOf("oslo"), clock_);
  owner.execute("UPDATE palpate.station SET expires = now() - interval '1 day'");
  runSession("oslo");
  EXPECT_THROW(push("oslo"), study::UserError);
  EXPECT_EQ(incidents(), std::vector<std::string>{"expired"});
}

TEST_F(ServerFaults, OfTwoComputersFromOneBackupOneIsEnrolledAgain) {
  addStation("oslo");
  runSession("oslo");
  // The whole account and its studies, put onto a second computer.
  fs::copy(scratch_ / "account-oslo", scratch_ / "account-twin", fs::copy_options::recursive);
  fs::copy(folderOf("oslo"), folderOf("twin"), fs::copy_options::recursive);
  runSession("oslo");
  push("oslo");
  runSession("twin");
  try {
    push("twin");
    FAIL() << "both were taken";
  } catch (const study::collect::PushRefused& refused) {
    EXPECT_EQ(refused.name(), "fork");
    EXPECT_NE(
        std::string(refused.what()).find("ask for an enrolment of its own"), std::string::npos);
  }
  EXPECT_EQ(incidents(), std::vector<std::string>{"fork"});

  // It gets a name of its own: in the same account, for a new folder.
  {
    const auto account = accountOf("twin");
    const auto station =
        study::storage::StationStore::openOrCreate(study::storage::StationStore::defaultFolder());
    auto owner = admin();
    const auto enrolled = study::collect::enrolStation(
        owner, {.site = "oslo", .label = "oslo-2", .key = station.publicKey()});
    study::collect::join(scratch_.write("again", enrolled.file), folderOf("oslo-2"), clock_);
    auto study = Study::open(folderOf("oslo-2"), clock_);
    auto session = tests::consenting(study, {.cohort = "surgeons"});
    tests::walkToTheEnd(session);
    EXPECT_EQ(session.participant(), "oslo-2_P001");
    study::collect::Outbox outbox(folderOf("oslo-2"), clock_);
    auto server = as("station_oslo_2");
    study::collect::push(outbox, server);
  }
  runSession("oslo");
  push("oslo");
  fs::copy(scratch_ / "account-twin", scratch_ / "account-oslo-2", fs::copy_options::recursive);
  EXPECT_EQ(contentOfServer(), contentOf({folderOf("oslo"), folderOf("oslo-2")}));
  EXPECT_EQ(contentOf({pulled()}), contentOf({folderOf("oslo"), folderOf("oslo-2")}));
}

TEST_F(ServerFaults, WhatNoProgramOfOursWritesIsRefusedAndKept) {
  addStation("oslo");
  runSession("oslo");
  push("oslo");
  const auto before = rowsOfServer();
  auto owner = admin();
  const auto ids = owner.query(
      "SELECT s.study, s.uuid, s.have, encode(e.hash, 'hex') FROM palpate.station AS s "
      "JOIN palpate.event AS e ON e.station = s.id AND e.seq = s.have");
  const auto batch = [&](const std::string& rest) {
    return R"({"format": 1, "study": ")" + ids.text(0, 0) + R"(", "station": ")" + ids.text(0, 1) +
           R"(", "after": ")" + ids.text(0, 3) + R"(", )" + rest + "}";
  };
  const auto next = std::to_string(ids.number(0, 2) + 1);
  const std::vector<std::string> forged{
      "no JSON",
      batch(R"("events": 7)"),
      batch(R"("events": [{"seq": "much"}])"),
      batch(R"("events": [{"seq": )" + next + "}]"),  // an event without anything
      batch(
          R"("events": [{"seq": )" + next +
          R"(, "utc": "", "monotonic_ns": 0, "actor": "", "kind": "", "detail": "", "hash": "00"}])"),
      batch(R"("keys": [{"participant": "oslo_P009", "key": "00"}])"),
      batch(R"("keys": [{"participant": "oslo_P009", "key": "no digits"}])")};
  for (const auto& one : forged) EXPECT_EQ(answerTo(one), "damaged") << one;
  auto known = std::vector<std::string>(forged.size(), "damaged");
  EXPECT_EQ(incidents(), known);
  auto newer = batch(R"("events": [])");
  newer.replace(newer.find("1"), 1, "2");
  EXPECT_EQ(answerTo(newer), "newer");
  known.insert(known.begin(), "newer");
  EXPECT_EQ(incidents(), known);
  const auto kept = study::collect::incidentsOf(owner, 1);
  EXPECT_EQ(kept.at(0).role, "station_oslo");
  EXPECT_EQ(kept.at(0).station, "oslo");
  EXPECT_EQ(rowsOfServer(), before);
}

TEST_F(ServerFaults, ABundleThatIsNotTheStationsIsKeptAsAnIncident) {
  addStation("oslo");
  runSession("oslo");
  const auto account = accountOf("oslo");
  study::collect::Outbox outbox(folderOf("oslo"), clock_);
  const auto station =
      study::storage::StationStore::openOrCreate(study::storage::StationStore::defaultFolder());
  const auto home = study::collect::serverSettingsOf(folderOf("oslo"));
  study::collect::writeBundle(outbox, station, home.bundleKey, 0, scratch_ / "a.bundle");
  auto changed = tests::contentOf(scratch_ / "a.bundle");
  changed[changed.size() / 2] = static_cast<char>(changed[changed.size() / 2] ^ 1);
  auto owner = admin();
  EXPECT_THROW(
      study::collect::ingestBundle(owner, scratch_.write("changed", changed)), study::UserError);
  EXPECT_EQ(incidents(), std::vector<std::string>{"bundle"});
}

TEST_F(ServerFaults, WhatIsDeniedToARoleIsInTheLogWithItsName) {
  auto owner = admin();
  EXPECT_EQ(study::collect::logPrivacyProblem(owner), std::nullopt);
  addStation("oslo");
  owner.execute(
      "CREATE ROLE anna LOGIN; GRANT palpate_analyst TO anna;"
      "CREATE ROLE olav LOGIN; GRANT operator_oslo TO olav");
  const std::vector<std::pair<std::string, std::string>> deniedTo{
      {"station_oslo", "SELECT facts FROM palpate.session"},
      {"station_oslo", "DELETE FROM palpate.event"},
      {"station_oslo", "SELECT palpate.opened(1)"},
      {"anna", "SELECT condition FROM palpate.condition_code"},
      {"anna", "SELECT facts FROM palpate.session"},
      {"anna", "SELECT palpate.unblind('short', 'curious')"},
      {"olav", "SELECT * FROM palpate.answers"},
      {"olav", "SELECT facts FROM palpate.session"}};
  for (const auto& [role, denied] : deniedTo) {
    auto connection = as(role);
    EXPECT_THROW(connection.execute(denied), ServerError) << role << ": " << denied;
    const auto log = tests::contentOf(postgres().folder() / "server.log");
    const auto at = log.rfind("STATEMENT:  " + denied);
    ASSERT_NE(at, std::string::npos) << denied;
    const auto line = log.substr(log.rfind('\n', at) + 1, at - log.rfind('\n', at));
    EXPECT_NE(line.find(role + "@" + database()), std::string::npos) << line;
    EXPECT_NE(log.rfind("permission denied"), std::string::npos);
  }
  owner.execute("DROP ROLE anna; DROP ROLE olav");
  for (const std::string lacking : {"log_min_error_statement = panic", "log_min_messages = log"}) {
    owner.execute("SET " + lacking);
    EXPECT_NE(study::collect::logPrivacyProblem(owner), std::nullopt) << lacking;
    owner.execute("RESET ALL");
  }
}

}  // namespace server_faults_test

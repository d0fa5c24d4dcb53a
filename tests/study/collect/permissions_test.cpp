// Who may do what on the server: everything else is denied.
#include <cstring>
#include <filesystem>

#include "study/collect/exchange/pull.h"
#include "study/collect/server/registry.h"
#include "study/collect/server/schema.h"
#include "study/model/user_error.h"
#include "study/session/erasure.h"
#include "study/storage/map/study_keys.h"
#include "tests/study/collect/collected_study_at.h"

namespace permissions_test {

using study::collect::Connection;
using study::collect::ServerError;

class Permissions : public tests::CollectTest {
 protected:
  /// A role of the test, which is given a group.
  std::string person(const std::string& name, const std::string& group) {
    auto server = admin();
    if (server.query("SELECT 1 FROM pg_roles WHERE rolname = $1", {name}).isEmpty()) {
      server.execute("CREATE ROLE " + name + " LOGIN");
    }
    server.execute("GRANT " + group + " TO " + name);
    return name;
  }

  static ServerError::Kind kindOf(Connection& server, const std::string& statement) {
    try {
      server.execute(statement);
    } catch (const ServerError& error) {
      return error.kind();
    }
    ADD_FAILURE() << statement << " was allowed";
    return ServerError::Kind::Other;
  }
};

constexpr auto kDenied = ServerError::Kind::Denied;

TEST_F(Permissions, AStationMayCallIngestAndNothingElse) {
  addStation("oslo");
  runSession("oslo");
  push("oslo");
  auto station = as("station_oslo");
  // All that the schema has, with a column of each that could be written.
  const auto relations = admin().query(
      "SELECT c.relname, c.relkind = 'v', (SELECT a.attname FROM pg_attribute AS a "
      "WHERE a.attrelid = c.oid AND a.attnum > 0 AND a.attidentity = '' LIMIT 1) "
      "FROM pg_class AS c WHERE c.relnamespace = 'palpate'::regnamespace "
      "AND c.relkind IN ('r', 'v') AND c.relname <> 'schema_step' ORDER BY 1");
  EXPECT_GT(relations.count(), 18);
  for (int i = 0; i < relations.count(); ++i) {
    const auto name = "palpate." + relations.text(i, 0);
    EXPECT_EQ(kindOf(station, "SELECT * FROM " + name), kDenied);
    if (relations.text(i, 1) == "t") continue;  // no role can write to a view
    EXPECT_EQ(kindOf(station, "DELETE FROM " + name), kDenied);
    EXPECT_EQ(kindOf(station, "INSERT INTO " + name + " DEFAULT VALUES"), kDenied);
    EXPECT_EQ(
        kindOf(station, "UPDATE " + name + " SET " + relations.text(i, 2) + " = NULL"), kDenied);
    EXPECT_EQ(kindOf(station, "TRUNCATE " + name), kDenied);
  }
  for (const auto* call :
       {"unblind('x', 'y')",
        "pull_study(1)",
        "pull_keys(1, 1)",
        "refuse('a', 'b')",
        "take_keys(NULL, NULL)",
        "set_aside('a', 'oslo', 'b')",
        "forget(NULL, 1, 'oslo_P001', 1)",
        "receipts(NULL, NULL)",
        "opened(1)"}) {
    EXPECT_EQ(kindOf(station, std::string("SELECT palpate.") + call), kDenied) << call;
  }
  EXPECT_EQ(kindOf(station, "SET ROLE palpate_owner"), kDenied);
  EXPECT_EQ(kindOf(station, "CREATE TABLE palpate.mine ()"), kDenied);
}

TEST_F(Permissions, AStationCannotWriteForAnother) {
  addStation("oslo");
  addStation("bergen");
  runSession("oslo");
  const auto account = accountOf("oslo");
  study::collect::Outbox outbox(folderOf("oslo"), clock_);
  auto bergen = as("station_bergen");
  EXPECT_THROW(study::collect::push(outbox, bergen), study::UserError);
  EXPECT_EQ(incidents(), std::vector<std::string>{"foreign"});
  EXPECT_TRUE(contentOfServer().empty());
}

TEST_F(Permissions, ForgedEventsOfAStationAreRefusedOrFound) {
  addStation("oslo");
  runSession("oslo");
  push("oslo");
  const auto account = accountOf("oslo");
  study::collect::Outbox outbox(folderOf("oslo"), clock_);
  auto server = as("station_oslo");
  // Another event in the place of one that is there.
  auto forged = outbox.eventQuery(5);
  forged.events.front().hash.assign(32, std::byte{1});
  EXPECT_EQ(study::collect::ingest(server, forged).refused, "fork");
  // One more at the end: its hash is of nothing.
  auto added = outbox.eventQuery(outbox.lastEvent());
  added.events.front().seq += 1;
  added.events.front().hash.assign(32, std::byte{2});
  added.after = outbox.hashOf(outbox.lastEvent());
  EXPECT_EQ(study::collect::ingest(server, added).refused, "");
  const auto all = pull();
  EXPECT_EQ(all.sessions(), 1U);
  EXPECT_FALSE(all.isSound());
}

TEST_F(Permissions, OtherRowsOrSamplesInThePlaceOfThoseThatAreThereAreRefused) {
  addStation("oslo");
  runSession("oslo");
  push("oslo");
  const auto before = contentOfServer();
  const auto account = accountOf("oslo");
  study::collect::Outbox outbox(folderOf("oslo"), clock_);
  auto server = as("station_oslo");
  int rows = 0;
  int samples = 0;
  outbox.forEachBatch(0, [&](const study::collect::Batch& batch) {
    for (std::size_t i = 0; i < batch.sessions.size(); ++i, ++rows) {
      auto forged = batch;
      forged.sessions[i].facts += " ";
      const auto answer = study::collect::ingest(server, forged);
      EXPECT_EQ(answer.refused, "fork");
      EXPECT_NE(answer.detail.find("with other rows"), std::string::npos) << answer.detail;
    }
    if (!batch.chunks.empty()) {
      auto forged = batch;
      forged.chunks.back().chunk.hash.back() ^= std::byte{1};
      const auto answer = study::collect::ingest(server, forged);
      EXPECT_EQ(answer.refused, "fork");
      EXPECT_NE(answer.detail.find("a trace is here"), std::string::npos) << answer.detail;
      ++samples;
    }
    return true;
  });
  EXPECT_GT(rows, 0);
  EXPECT_GT(samples, 0);
  EXPECT_EQ(
      incidents(), std::vector<std::string>(static_cast<std::size_t>(rows + samples), "fork"));
  EXPECT_EQ(contentOfServer(), before);
}

TEST_F(Permissions, WhatIsNotOfTheStationOrOfTheStudyIsRefused) {
  addStation("oslo");
  runSession("oslo");
  const auto account = accountOf("oslo");
  study::collect::Outbox outbox(folderOf("oslo"), clock_);
  auto server = as("station_oslo");
  // The answer to what the station has, with one text in the rows of its session replaced.
  const auto answerTo = [&](const std::string& from, const std::string& to) {
    std::string refused;
    outbox.forEachBatch(0, [&](study::collect::Batch batch) {
      for (auto& session : batch.sessions) {
        const auto place = session.facts.find(from);
        EXPECT_NE(place, std::string::npos) << from;
        if (place != std::string::npos) session.facts.replace(place, from.size(), to);
      }
      refused = study::collect::ingest(server, batch).refused;
      return refused.empty();
    });
    return refused;
  };
  EXPECT_EQ(answerTo("oslo_P001", "bergen_P001"), "code");
  EXPECT_EQ(answerTo(R"("site":"oslo")", R"("site":"bergen")"), "place");
  const std::string protocol = R"("protocol":")";
  EXPECT_EQ(answerTo(protocol, protocol + "0"), "protocol");
  auto unknown = outbox.lastEventQuery();
  unknown.station = "never enrolled";
  EXPECT_EQ(study::collect::ingest(server, unknown).refused, "unknown");
  auto another = outbox.lastEventQuery();
  another.study = "another study";
  EXPECT_EQ(study::collect::ingest(server, another).refused, "unknown");
  EXPECT_EQ(
      incidents(), (std::vector<std::string>{"unknown", "unknown", "protocol", "place", "code"}));
  EXPECT_TRUE(contentOfServer().empty());
}

/// A thief has a station's folder and its role on the server, and not the key with which it signs:
/// they can invent a session, with a chain of hashes that is right.
class Thief : public Permissions {
 protected:
  void SetUp() override {
    Permissions::SetUp();
    if (IsSkipped()) return;
    addStation("oslo");
    addStation("bergen");
    runSession("oslo");
    runSession("bergen");
    push("oslo");
    push("bergen");
    std::filesystem::copy(
        folderOf("oslo"), folderOf("thief"), std::filesystem::copy_options::recursive);
    // The key of the conditions was taken out of the account as well.
    auto owner = admin();
    const auto secret = study::collect::findStudy(owner, "short").secret;
    study::storage::BlindingSecret::Bytes bytes{};
    std::memcpy(bytes.data(), secret.data(), bytes.size());
    {
      const auto account = accountOf("thief");
      study::storage::storeStudyKey(
          study::storage::BlindingSecret(bytes).of("oslo"), folderOf("thief"));
    }
    runSession("thief");
  }

  enum class Signature { Theirs, None };
  /// What they have is sent to the server. @return  the server's refusal
  std::string send(Signature signature) {
    const auto account = accountOf("thief");
    study::collect::Outbox outbox(folderOf("thief"), clock_);
    auto server = as("station_oslo");
    std::string refused;
    outbox.forEachBatch(0, [&](study::collect::Batch batch) {
      if (signature == Signature::None && !batch.events.empty()) batch.events.pop_back();
      refused = study::collect::ingest(server, batch).refused;
      return refused.empty();
    });
    return refused;
  }
};

TEST_F(Thief, SendsSessionsThatAreNotPulledIfTheySignWithAnotherKey) {
  EXPECT_EQ(send(Signature::Theirs), "");
  EXPECT_EQ(contentOfServer().size(), contentOf({folderOf("thief"), folderOf("bergen")}).size());
  const auto all = pull();
  EXPECT_FALSE(all.isSound());
  EXPECT_EQ(contentOf({scratch_ / "union"}), contentOf({folderOf("oslo"), folderOf("bergen")}));
}

TEST_F(Thief, SendsSessionsThatAreNotPulledIfTheyDoNotSign) {
  EXPECT_EQ(send(Signature::None), "");
  EXPECT_EQ(contentOfServer().size(), contentOf({folderOf("thief"), folderOf("bergen")}).size());
  const auto all = pull();
  EXPECT_FALSE(all.isSound());
  EXPECT_EQ(contentOf({scratch_ / "union"}), contentOf({folderOf("oslo"), folderOf("bergen")}));
}

TEST_F(Thief, IsSetAsideAndTheTrueStationGoesOn) {
  EXPECT_EQ(send(Signature::None), "");
  runSession("oslo");
  EXPECT_THROW(push("oslo"), study::UserError) << "the server has other events";
  auto owner = admin();
  const auto id = study::collect::findStudy(owner, "short").uuid;
  study::collect::revokeStation(owner, id, "oslo", "the certificate was stolen");
  EXPECT_TRUE(study::collect::setAsideStation(owner, id, "oslo", "forged sessions"));
  EXPECT_THROW(study::collect::setAsideStation(owner, id, "tromso", "none"), study::UserError);
  push("oslo");
  runSession("oslo");
  push("oslo");
  const auto all = pull();
  EXPECT_TRUE(all.isSound());
  EXPECT_EQ(contentOf({scratch_ / "union"}), contentOf({folderOf("oslo"), folderOf("bergen")}));
  // What was forged is kept, and analysts do not see it.
  EXPECT_EQ(owner.query("SELECT count(*) FROM palpate.session").number(0, 0), 6);
  EXPECT_EQ(owner.query("SELECT count(*) FROM palpate.sessions").number(0, 0), 4);
  EXPECT_EQ(
      owner.query("SELECT string_agg(DISTINCT station, ' ' ORDER BY station) FROM palpate.answers")
          .text(0, 0),
      "bergen oslo");
  auto olav = as(person("olav", "operator_oslo"));
  EXPECT_EQ(olav.query("SELECT participant FROM palpate.session").count(), 3);
}

TEST_F(Thief, WhoErasesOnTheServerDoesNotEraseWhatTheStationHas) {
  {
    const auto account = accountOf("thief");
    auto study = study::Study::open(folderOf("thief"), clock_);
    study::erase(study, {.participant = "oslo_P001", .reason = "malice"});
  }
  EXPECT_EQ(send(Signature::Theirs), "");
  EXPECT_EQ(pull().sessions(), 1U) << "of bergen: the rows of oslo are gone";
  auto owner = admin();
  study::collect::setAsideStation(
      owner, study::collect::findStudy(owner, "short").uuid, "oslo", "forged erasure");
  push("oslo");
  EXPECT_TRUE(pull("again").isSound());
  EXPECT_EQ(contentOf({scratch_ / "again"}), contentOf({folderOf("oslo"), folderOf("bergen")}));
}

TEST_F(Permissions, ASessionOfAnotherSiteIsRefused) {
  addStation("oslo");
  runSession("oslo");
  admin().execute("UPDATE palpate.station SET site = 'bergen'");
  EXPECT_THROW(push("oslo"), study::UserError);
  EXPECT_EQ(incidents(), std::vector<std::string>{"place"});
}

TEST_F(Permissions, WhoEnrolledAndWhoRevokedAStationIsKept) {
  addStation("oslo");
  auto owner = admin();
  owner.execute("CREATE ROLE ida_" + database() + " LOGIN IN ROLE palpate_owner");
  auto ida = as("ida_" + database());
  const auto study = study::collect::findStudy(ida, "short");
  study::collect::revokeStation(ida, study.uuid, "oslo", "stolen");
  const auto kept =
      owner.query("SELECT enrolled_by = session_user, revoked_by FROM palpate.station");
  EXPECT_EQ(kept.text(0, 0), "t");
  EXPECT_EQ(kept.text(0, 1), "ida_" + database());
}

TEST_F(Permissions, AChangedBatchIsRefused) {
  addStation("oslo");
  auto server = as("station_oslo");
  const auto said = server.query(
      "SELECT palpate.ingest($1, $2, $3)",
      {"{}", study::collect::Parameter::bytes({}), study::collect::Parameter::arrayOfBytes({})});
  EXPECT_EQ(study::collect::answerIn(said.text(0, 0)).refused, "damaged");
  EXPECT_EQ(incidents(), std::vector<std::string>{"damaged"});
}

TEST_F(Permissions, ARevokedStationIsToldWhy) {
  addStation("oslo");
  runSession("oslo");
  auto owner = admin();
  const auto study = study::collect::findStudy(owner, "short");
  study::collect::revokeStation(owner, study.uuid, "oslo", "the laptop was stolen");
  try {
    push("oslo");
    FAIL() << "it was let in";
  } catch (const study::UserError& error) {
    EXPECT_NE(std::string(error.what()).find("the laptop was stolen"), std::string::npos);
  }
  EXPECT_EQ(incidents(), std::vector<std::string>{"revoked"});
}

TEST_F(Permissions, AStationIsRevokedOnceAndTheFirstReasonStays) {
  addStation("oslo");
  auto owner = admin();
  const auto study = study::collect::findStudy(owner, "short");
  study::collect::revokeStation(owner, study.uuid, "oslo", "the laptop was stolen");
  EXPECT_THROW(
      study::collect::revokeStation(owner, study.uuid, "oslo", "another"), study::UserError);
  const auto kept = owner.query("SELECT revoked_reason FROM palpate.station");
  EXPECT_EQ(kept.text(0, 0), "the laptop was stolen");
}

TEST_F(Permissions, AnAnalystSeesPointsAndNoCondition) {
  addStation("oslo");
  runSession("oslo");
  push("oslo");
  const auto analyst = person("eva", "palpate_analyst");
  auto server = as(analyst);
  EXPECT_GT(server.query("SELECT count(*) FROM palpate.answers").number(0, 0), 0);
  const auto columns = server.query(
      "SELECT string_agg(column_name, ' ') FROM information_schema.columns "
      "WHERE table_schema = 'palpate' AND column_name ~ 'condition|text|words|facts'");
  EXPECT_TRUE(columns.isNull(0, 0)) << columns.text(0, 0);
  for (const auto* table : {"session", "answer", "study", "content_key", "event"}) {
    EXPECT_EQ(kindOf(server, std::string("SELECT * FROM palpate.") + table), kDenied) << table;
  }
  EXPECT_EQ(kindOf(server, "SELECT palpate.unblind('x', 'curious')"), kDenied);
}

TEST_F(Permissions, AnOperatorSeesTheOwnSiteAlone) {
  addStation("oslo");
  addStation("bergen");
  runSession("oslo");
  runSession("bergen");
  push("oslo");
  push("bergen");
  auto server = as(person("olav", "operator_oslo"));
  const auto rows = server.query("SELECT participant FROM palpate.session");
  ASSERT_EQ(rows.count(), 1);
  EXPECT_EQ(rows.text(0, 0), "oslo_P001");
  EXPECT_EQ(kindOf(server, "SELECT facts FROM palpate.session"), kDenied);
  const auto own = server.query("SELECT label FROM palpate.station");
  ASSERT_EQ(own.count(), 1);
  EXPECT_EQ(own.text(0, 0), "oslo");
  // 'palpate collect status' reads this.
  const auto stations = study::collect::stationsOf(server, "");
  ASSERT_EQ(stations.size(), 1U);
  EXPECT_EQ(stations.front().station, "oslo");
  EXPECT_EQ(stations.front().sessions, 1);
}

TEST_F(Permissions, AnAnalystWhoPullsIsToldWhichRoleThatNeeds) {
  addStation("oslo");
  auto server = as(person("eva", "palpate_analyst"));
  try {
    study::collect::pull(server, {.folder = scratch_ / "none", .reason = "look"}, clock_);
    ADD_FAILURE() << "an analyst pulled";
  } catch (const ServerError& error) {
    EXPECT_EQ(error.kind(), kDenied);
    const std::string said = error.what();
    EXPECT_NE(said.find("GRANT palpate_unblinder TO \"eva\";"), said.npos) << said;
  }
}

TEST_F(Permissions, WhoeverPullsGivesAReasonThatIsKept) {
  addStation("oslo");
  runSession("oslo");
  push("oslo");
  auto server = as(person("una", "palpate_unblinder"));
  EXPECT_THROW(
      study::collect::pull(server, {.folder = scratch_ / "none", .reason = ""}, clock_),
      study::UserError);
  EXPECT_EQ(kindOf(server, "SELECT * FROM palpate.pull_sessions(1, 1, 0, 10)"), kDenied);
  study::collect::pull(
      server, {.folder = scratch_ / "union", .reason = "the analysis is written"}, clock_);
  auto owner = admin();
  const auto kept = owner.query("SELECT role, reason FROM palpate.access");
  ASSERT_EQ(kept.count(), 1);
  EXPECT_EQ(kept.text(0, 0), "una");
  EXPECT_EQ(kept.text(0, 1), "the analysis is written");
}

TEST_F(Permissions, NobodyReadsByAReasonThatCanStillBeTakenBack) {
  addStation("oslo");
  runSession("oslo");
  push("oslo");
  auto owner = admin();
  const auto study = study::collect::findStudy(owner, "short").uuid;
  auto server = as(person("una", "palpate_unblinder"));
  const auto ticket = "palpate.unblind('" + study + "', 'curious')";
  for (const char* begin :
       {"BEGIN; SELECT ",
        "BEGIN; SAVEPOINT a; SELECT ",
        "BEGIN ISOLATION LEVEL SERIALIZABLE; SELECT "}) {
    server.execute(std::string(begin) + ticket + " AS id");
    const auto id =
        owner.query("SELECT pg_sequence_last_value('palpate.access_id_seq')").text(0, 0);
    EXPECT_EQ(kindOf(server, "SELECT * FROM palpate.pull_stations(" + id + ")"), kDenied) << begin;
    server.execute("ROLLBACK");
  }
  EXPECT_EQ(
      kindOf(server, "SELECT s.* FROM " + ticket + " AS t, palpate.pull_stations(t) AS s"),
      kDenied);
  EXPECT_TRUE(owner.query("SELECT FROM palpate.access").isEmpty());
  const auto kept = server.query("SELECT " + ticket).text(0, 0);
  EXPECT_EQ(server.query("SELECT * FROM palpate.pull_stations($1)", {kept}).count(), 1);
  server.execute("BEGIN; SELECT pg_current_xact_id()");
  EXPECT_EQ(server.query("SELECT * FROM palpate.pull_stations($1)", {kept}).count(), 1);
}

TEST_F(Permissions, ABlankReasonIsNone) {
  auto owner = admin();
  const auto study = study::collect::findStudy(owner, "short").uuid;
  auto server = as(person("una", "palpate_unblinder"));
  for (const auto* blank : {"", "  ", "\n", " \t\r\n"}) {
    EXPECT_THROW(server.query("SELECT palpate.unblind($1, $2)", {study, blank}), ServerError);
  }
  server.query("SELECT palpate.unblind($1, $2)", {study, " \xC3\xA6"});  // a letter of any language
}

TEST_F(Permissions, FunctionsOfTheOwnerLookNowhereElse) {
  auto server = admin();
  const auto open = server.query(
      "SELECT p.proname FROM pg_proc AS p JOIN pg_namespace AS n ON n.oid = p.pronamespace "
      "WHERE n.nspname = 'palpate' AND NOT coalesce('search_path=palpate, pg_temp' = "
      "ANY(p.proconfig), false)");
  EXPECT_TRUE(open.isEmpty()) << open.text(0, 0);
  const auto forAll = server.query(
      "SELECT p.proname FROM pg_proc AS p JOIN pg_namespace AS n ON n.oid = p.pronamespace "
      "WHERE n.nspname = 'palpate' AND has_function_privilege('public', p.oid, 'EXECUTE')");
  EXPECT_TRUE(forAll.isEmpty()) << forAll.text(0, 0);
}

TEST_F(Permissions, AServerWithANewerSchemaIsNotWrittenTo) {
  auto server = admin();
  server.execute("INSERT INTO palpate.schema_step (step) VALUES (99)");
  EXPECT_THROW(study::collect::requireSchema(server), ServerError);
  EXPECT_THROW(study::collect::installSchema(server), ServerError);
}

}  // namespace permissions_test

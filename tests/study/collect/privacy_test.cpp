// What never leaves a station, and what is left of participants who were erased there.
#include <algorithm>
#include <cstring>

#include "study/collect/exchange/administration.h"
#include "study/collect/exchange/bundle.h"
#include "study/collect/exchange/enrolment.h"
#include "study/collect/exchange/pull.h"
#include "study/collect/server/registry.h"
#include "study/session/erasure.h"
#include "study/storage/hasher.h"
#include "study/storage/statement.h"
#include "study/storage/trace_store.h"
#include "tests/study/collect/collected_study_at.h"
#include "tests/study/walk.h"

namespace privacy_test {

using study::Study;
using study::collect::Batch;
using study::collect::Outbox;

const std::string kName = "Zaphod Beeblebrox-Sentinel";
const std::string kReason = "the tool fell, reason-sentinel";

class Privacy : public tests::CollectTest {
 protected:
  void SetUp() override {
    CollectTest::SetUp();
    if (!IsSkipped()) addStation("oslo");
  }

  /// A participant signs, and one trial is repeated twice: with samples, and with a reason.
  std::string takePart() {
    const auto account = accountOf("oslo");
    auto study = Study::open(folderOf("oslo"), clock_);
    auto session = study::Session::enrol(study, {.cohort = "surgeons"});
    for (const auto& item : session.items()) {
      auto answer = tests::answerTo(session, item);
      if (item.isIdentifying) answer.response = kName;
      session.record(answer);
    }
    session.finishStep();
    tests::walkTo(session, study::StepKind::Trial);
    session.beginTrial();
    study.traces().add(session.visit(), 0, std::vector<study::storage::TraceSample>(500));
    session.abortTrial({.ending = study::TrialEnding::Stopped, .ticks = 500, .traceSamples = 500});
    session.repeatStep("stopped");
    tests::passStep(session);
    session.repeatStep(kReason);
    tests::walkToTheEnd(session);
    return session.participant();
  }

  void erase(const std::string& code) {
    const auto account = accountOf("oslo");
    auto study = Study::open(folderOf("oslo"), clock_);
    study::erase(study, {.participant = code, .reason = "asked for it"});
  }

  std::vector<Batch> batches() {
    const auto account = accountOf("oslo");
    Outbox outbox(folderOf("oslo"), clock_);
    std::vector<Batch> all;
    outbox.forEachBatch(0, [&](const Batch& batch) {
      all.push_back(batch);
      return true;
    });
    return all;
  }

  /// @return  the receipts
  std::vector<study::ErasureReceipt> send(const std::vector<Batch>& batches) {
    auto server = as("station_oslo");
    std::vector<study::ErasureReceipt> receipts;
    for (const auto& batch : batches) {
      const auto answer = study::collect::ingest(server, batch);
      EXPECT_EQ(answer.refused, "");
      receipts.insert(receipts.end(), answer.erased.begin(), answer.erased.end());
    }
    return receipts;
  }

  std::string bundle(const std::string& name) {
    const auto account = accountOf("oslo");
    Outbox outbox(folderOf("oslo"), clock_);
    const auto station =
        study::storage::StationStore::openOrCreate(study::storage::StationStore::defaultFolder());
    const auto home = study::collect::serverSettingsOf(folderOf("oslo"));
    study::collect::writeBundle(outbox, station, home.bundleKey, 0, scratch_ / name);
    return scratch_ / name;
  }

  study::collect::IngestedBundle take(const std::string& file) {
    auto server = admin();
    return study::collect::ingestBundle(server, file);
  }

  std::int64_t count(const std::string& table) {
    auto server = admin();
    return server.query("SELECT count(*) FROM palpate." + table).number(0, 0);
  }

  /// Every row of every table of the server, as text; bytes are hexadecimal.
  std::string everythingOnTheServer() {
    auto server = admin();
    const auto tables = server.query(
        "SELECT quote_ident(schemaname) || '.' || quote_ident(tablename) FROM pg_tables "
        "WHERE schemaname NOT IN ('pg_catalog', 'information_schema')");
    std::string all;
    for (int i = 0; i < tables.count(); ++i) {
      all += server
                 .query(
                     "SELECT coalesce(string_agg(t::text, ' '), '') FROM " + tables.text(i, 0) +
                     " AS t")
                 .text(0, 0);
    }
    return all;
  }

  /// All that the bundle has, once it is opened; bytes are hexadecimal.
  std::string everythingIn(const std::string& bundle) {
    auto owner = admin();
    const auto secret = study::collect::findStudy(owner, "short").secret;
    study::storage::BlindingSecret::Bytes bytes{};
    std::memcpy(bytes.data(), secret.data(), bytes.size());
    const auto key = owner.query("SELECT key FROM palpate.station").text(0, 0);
    std::string all;
    study::collect::readBundle(
        bundle,
        study::storage::BlindingSecret(bytes),
        key,
        [&](const std::string& text, const auto& chunks) {
          all += text;
          for (const auto& chunk : chunks) all += study::storage::inHexadecimal(chunk);
          return true;
        });
    return all;
  }

  /// A column of bytes in the station's identity.db, hexadecimal.
  std::vector<std::string> secretsOf(const std::string& select) {
    const auto account = accountOf("oslo");
    auto study = Study::open(folderOf("oslo"), clock_, study::storage::Database::Access::ReadOnly);
    study::storage::Statement rows(study.identities().database(), select);
    std::vector<std::string> found;
    while (rows.step()) found.push_back(study::storage::inHexadecimal(rows.blob(0)));
    return found;
  }
};

std::string inHexadecimal(const std::string& text) {
  return study::storage::inHexadecimal(std::as_bytes(std::span(text)));
}

std::size_t timesIn(const std::string& content, const std::string& text) {
  std::size_t times = 0;
  for (auto at = content.find(text); at != std::string::npos; at = content.find(text, at + 1)) {
    ++times;
  }
  return times;
}

TEST_F(Privacy, NamesAndSignaturesNeverTravel) {
  takePart();
  push("oslo");
  {
    const auto account = accountOf("oslo");
    auto study = Study::open(folderOf("oslo"), clock_);
    const auto names = study.identities().names();
    ASSERT_EQ(names.size(), 1U);
    EXPECT_EQ(names[0].text, kName) << "the control: it is at the station";
  }
  auto never = secretsOf("SELECT sealed FROM identifying_answer");
  for (const auto* other :
       {"SELECT identity FROM participant_key", "SELECT bytes FROM fingerprint_key"}) {
    for (auto& secret : secretsOf(other)) never.push_back(std::move(secret));
  }
  EXPECT_EQ(never.size(), 3U);
  never.insert(never.end(), {kName, inHexadecimal(kName), "Beeblebrox"});
  const auto contentKey = secretsOf("SELECT content FROM participant_key").at(0);
  for (const auto& content : {everythingOnTheServer(), everythingIn(bundle("a.bundle"))}) {
    for (const auto& secret : never) EXPECT_EQ(content.find(secret), std::string::npos) << secret;
    // Controls: what travels is found by the same search.
    EXPECT_NE(content.find(kReason), std::string::npos);
    EXPECT_NE(content.find(contentKey), std::string::npos);
  }
}

TEST_F(Privacy, AnErasureIsAnsweredWithAReceipt) {
  const auto code = takePart();
  takePart();
  EXPECT_TRUE(push("oslo").erased.empty());
  EXPECT_EQ(count("chunk"), 2);
  const auto before = timesIn(everythingOnTheServer(), kReason);
  erase(code);
  const auto receipts = push("oslo").erased;
  ASSERT_EQ(receipts.size(), 1U);
  EXPECT_EQ(receipts[0].participant, code);
  EXPECT_EQ(receipts[0].session, 1);
  EXPECT_EQ(receipts[0].left, 0);
  EXPECT_FALSE(receipts[0].utc.empty());
  EXPECT_EQ(count("chunk"), 1);
  EXPECT_EQ(count("content_key"), 1);
  EXPECT_GT(before, 0U);
  EXPECT_EQ(timesIn(everythingOnTheServer(), kReason), before / 2) << "of the other one";
  // The same answer to the same batch; and no receipt for what is not gone.
  EXPECT_EQ(send(batches()).size(), 1U);
  admin().execute(
      "INSERT INTO palpate.content_key (station, participant, key) SELECT station, '" + code +
      "', key FROM palpate.content_key");
  EXPECT_EQ(send(batches()).at(0).left, 1);
}

TEST_F(Privacy, WhatWasSentBeforeAnErasureHasNoEffectAfterIt) {
  const auto code = takePart();
  takePart();
  const auto before = batches();
  const auto file = bundle("before.bundle");
  EXPECT_TRUE(send(before).empty());
  erase(code);
  push("oslo");
  const auto content = contentOfServer();
  for (int times = 0; times < 2; ++times) {
    send(before);
    take(file);
    EXPECT_EQ(count("chunk"), 1);
    EXPECT_EQ(count("content_key"), 1);
    EXPECT_EQ(contentOfServer(), content);
  }
  EXPECT_EQ(content, contentOf({folderOf("oslo")}));
}

TEST_F(Privacy, AnErasureTravelsByBundle) {
  const auto code = takePart();
  takePart();
  take(bundle("before.bundle"));
  EXPECT_EQ(count("chunk"), 2);
  erase(code);
  const auto taken = take(bundle("after.bundle"));
  ASSERT_EQ(taken.erased.size(), 1U);
  EXPECT_EQ(taken.erased[0].left, 0);
  EXPECT_EQ(count("chunk"), 1);
  EXPECT_EQ(contentOfServer(), contentOf({folderOf("oslo")}));
}

TEST_F(Privacy, WhoWasErasedBeforeTheFirstPushLeavesNothingOnTheServer) {
  const auto code = takePart();
  takePart();
  erase(code);
  EXPECT_EQ(push("oslo").erased.size(), 1U);
  EXPECT_EQ(count("chunk"), 1);
  EXPECT_EQ(count("content_key"), 1);
  EXPECT_EQ(contentOfServer(), contentOf({folderOf("oslo")}));
}

TEST_F(Privacy, AServerThatWasRestoredToBeforeAnErasureErasesAgain) {
  const auto code = takePart();
  takePart();
  push("oslo");
  study::collect::Connection cluster(postgres().server());
  cluster.execute("CREATE DATABASE backup_of_it TEMPLATE " + database());
  erase(code);
  push("oslo");
  cluster.execute("DROP DATABASE " + database());
  cluster.execute("ALTER DATABASE backup_of_it RENAME TO " + database());
  EXPECT_EQ(count("chunk"), 2) << "it is as it was";
  EXPECT_EQ(push("oslo").erased.size(), 1U);
  EXPECT_EQ(count("chunk"), 1);
  EXPECT_EQ(count("content_key"), 1);
  EXPECT_EQ(contentOfServer(), contentOf({folderOf("oslo")}));
}

TEST_F(Privacy, WhoIsErasedIsErasedFromWhatWasSetAside) {
  const auto code = takePart();
  takePart();
  push("oslo");
  auto owner = admin();
  study::collect::setAsideStation(
      owner, study::collect::findStudy(owner, "short").uuid, "oslo", "tried");
  push("oslo");
  EXPECT_EQ(count("session"), 4);
  EXPECT_EQ(count("chunk"), 4);
  erase(code);
  EXPECT_EQ(push("oslo").erased.at(0).left, 0);
  EXPECT_EQ(count("session"), 3);
  EXPECT_EQ(count("chunk"), 2);
  EXPECT_EQ(count("content_key"), 2);
}

TEST_F(Privacy, AParticipantOfALostStationIsErasedOnTheServerAlone) {
  const auto code = takePart();
  const auto other = takePart();
  push("oslo");
  auto owner = admin();
  const auto uuid = study::collect::findStudy(owner, "short").uuid;
  const auto eraseThere = [&](const std::string& who) {
    return study::collect::eraseParticipant(owner, uuid, "oslo", who, "asked for it");
  };
  EXPECT_THROW(eraseThere(code), study::UserError) << "the station can push";
  study::collect::revokeStation(owner, uuid, "oslo", "stolen");
  EXPECT_THROW(eraseThere("oslo_P009"), study::UserError);
  const auto before = timesIn(everythingOnTheServer(), kReason);
  const auto receipts = eraseThere(code);
  ASSERT_EQ(receipts.size(), 1U);
  EXPECT_EQ(receipts[0].left, 0);
  EXPECT_EQ(timesIn(everythingOnTheServer(), kReason), before / 2) << "of the other one";
  EXPECT_EQ(count("session"), 1);
  EXPECT_EQ(count("content_key"), 1);
  EXPECT_EQ(incidents().front(), "erased");
  const auto pulled = pull();
  EXPECT_TRUE(pulled.isSound());
  EXPECT_EQ(pulled.stations.at(0).sessions, 1U);
  auto study = Study::open(folderOfPull(), clock_);
  EXPECT_EQ(study.sessions().all().at(0).participant, other);
}

TEST_F(Privacy, AReceiptOfASessionIsListedOnce) {
  const auto account = accountOf("oslo");
  const study::ErasureReceipt receipt{
      .session = 3, .participant = "oslo_P 1", .utc = "2026-11-25T10:00:00.000Z", .left = 0};
  study::recordErasureReceipt("study", "station", receipt);
  study::recordErasureReceipt("study", "station", receipt);
  auto again = receipt;  // of a server that was restored
  again.utc = "2026-11-26T10:00:00.000Z";
  study::recordErasureReceipt("study", "station", again);
  const auto kept = study::receiptsOf("study", "station");
  ASSERT_EQ(kept.size(), 1U);
  EXPECT_EQ(kept[0].participant, "oslo_P 1");
  EXPECT_EQ(kept[0].session, 3);
  EXPECT_EQ(kept[0].utc, again.utc);
  EXPECT_TRUE(study::receiptsOf("study", "another").empty());
}

}  // namespace privacy_test

// One study at several sites, on a real PostgreSQL server.
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>

#include <fmt/format.h>

#include "study/collect/exchange/pull.h"
#include "study/collect/server/registry.h"
#include "study/export/export.h"
#include "study/model/user_error.h"
#include "study/results/results.h"
#include "study/session/erasure.h"
#include "study/session/verification.h"
#include "study/storage/erasure/erasure_repository.h"
#include "study/storage/statement.h"
#include "tests/study/collect/collected_study_at.h"
#include "tests/study/collect/line.h"
#include "tests/study/walk.h"
#include "tests/support/long_form.h"

namespace collection_test {

using study::Study;
using study::collect::ServerError;

class Collection : public tests::CollectTest {
 protected:
  std::string pulled(const std::string& name = "union") {
    result_ = pull(name);
    return folderOfPull(name);
  }

  /// What 'study verify' finds; empty: nothing.
  std::vector<std::string> problemsOf(const std::string& folder) {
    const auto account = accountOf("analyst");
    auto study = Study::open(folder, clock_, study::storage::Database::Access::ReadOnly);
    std::vector<std::string> problems;
    for (const auto& check : study::verify(study).checks) {
      for (const auto& problem : check.problems) problems.push_back(check.what + ": " + problem);
    }
    return problems;
  }

  std::vector<std::string> problemsOfStation(const std::string& label) const {
    for (const auto& station : result_.stations) {
      if (station.label == label) return station.problems;
    }
    return {"it was not pulled"};
  }

  std::int64_t count(const std::string& table) {
    auto server = admin();
    return server.query("SELECT count(*) FROM palpate." + table).number(0, 0);
  }

  study::collect::PullResult result_;
};

const std::vector<std::string> kNone;

TEST_F(Collection, StationsServerAndPulledFolderHaveTheSameContent) {
  addStation("oslo");
  addStation("oslo", "oslo-2");
  addStation("bergen");
  for (const auto* label : {"oslo", "oslo-2", "bergen"}) {
    simulate(label, 2);
    runSession(label);
    push(label);
  }
  const auto stations = contentOf({folderOf("oslo"), folderOf("oslo-2"), folderOf("bergen")});
  EXPECT_GT(stations.size(), 9U);
  EXPECT_EQ(contentOfServer(), stations);
  EXPECT_EQ(contentOf({pulled()}), stations);
  EXPECT_EQ(problemsOf(scratch_ / "union"), kNone);
  EXPECT_EQ(result_.sessions(), 9U);
  EXPECT_EQ(result_.stations.size(), 3U);
  EXPECT_TRUE(result_.isSound());
}

TEST_F(Collection, ThePulledStudyKnowsTheSiteOfEachSession) {
  addStation("oslo");
  addStation("oslo", "oslo-2");
  addStation("bergen");
  for (const auto* label : {"oslo", "oslo-2", "bergen"}) {
    simulate(label, 2);
    push(label);
  }
  const auto folder = pulled();
  const auto account = accountOf("analyst");
  auto study = Study::open(folder, clock_, study::storage::Database::Access::ReadOnly);
  const auto results = study::computeResults(study, study::RunMode::Simulated);
  ASSERT_EQ(results.siteFlow.size(), 2U);
  EXPECT_EQ(results.siteFlow[0].first, "bergen");
  EXPECT_EQ(results.siteFlow[0].second.completed, 2);
  EXPECT_EQ(results.siteFlow[1].second.completed, 4);
  for (const auto& cohort : results.families.at(0).cohorts) EXPECT_TRUE(cohort.sites.has_value());
}

TEST_F(Collection, TheSameCodeAtTwoSitesIsTwoParticipants) {
  addStation("oslo");
  addStation("bergen");
  EXPECT_EQ(runSession("oslo", "P001"), "oslo_P001");
  EXPECT_EQ(runSession("bergen", "P001"), "bergen_P001");
  push("oslo");
  push("bergen");
  EXPECT_EQ(contentOf({pulled()}), contentOf({folderOf("oslo"), folderOf("bergen")}));
}

TEST_F(Collection, WhatIsPushedAgainChangesNothing) {
  addStation("oslo");
  runSession("oslo");
  const auto first = push("oslo");
  const auto before = contentOfServer();
  const auto events = count("event");
  const auto again = push("oslo");
  EXPECT_EQ(again.before, first.lastEvent);
  EXPECT_EQ(again.lastEvent, first.lastEvent);
  EXPECT_EQ(count("event"), events);
  EXPECT_EQ(contentOfServer(), before);
}

TEST_F(Collection, EveryBatchMayComeThreeTimesAndInAnyOrder) {
  addStation("oslo");
  simulate("oslo", 3);
  std::vector<study::collect::Batch> batches;
  const auto account = accountOf("oslo");
  study::collect::Outbox outbox(folderOf("oslo"), clock_);
  outbox.setLimits({.events = 40, .traceBytes = 100'000});
  outbox.forEachBatch(0, [&](const study::collect::Batch& batch) {
    batches.push_back(batch);
    return true;
  });
  const std::vector<study::collect::Batch> backwards(batches.rbegin(), batches.rend());
  auto server = as("station_oslo");
  for (int times = 0; times < 3; ++times) {
    for (const auto& batch : backwards) {
      const auto answer = study::collect::ingest(server, batch);
      EXPECT_TRUE(answer.refused.empty() || answer.refused == "gap" || answer.refused == "traces")
          << answer.refused;
    }
  }
  EXPECT_GT(batches.size(), 10U);
  for (const auto& batch : batches) {
    const auto answer = study::collect::ingest(server, batch);
    EXPECT_EQ(answer.refused, "");
  }
  EXPECT_EQ(contentOfServer(), contentOf({folderOf("oslo")}));
  EXPECT_EQ(count("event"), outbox.lastEvent());
}

TEST_F(Collection, AWeekOfflineThenOnePush) {
  addStation("oslo");
  for (int day = 0; day < 5; ++day) {
    runSession("oslo");
    clock_.advance(24 * 3600.0);
  }
  const auto pushed = push("oslo");
  EXPECT_EQ(pushed.sessions.all, 5);
  EXPECT_EQ(pushed.sessions.arrived, 5);
  EXPECT_EQ(contentOf({pulled()}), contentOf({folderOf("oslo")}));
}

TEST_F(Collection, ASessionUnderWayTravelsAsItStands) {
  addStation("oslo");
  {
    const auto account = accountOf("oslo");
    auto study = Study::open(folderOf("oslo"), clock_);
    auto session = tests::consenting(study, {.cohort = "students"});
    tests::walkTo(session, study::StepKind::Trial);
  }
  push("oslo");
  EXPECT_EQ(contentOfServer(), contentOf({folderOf("oslo")}));
  {
    const auto account = accountOf("oslo");
    auto study = Study::open(folderOf("oslo"), clock_);
    auto session = study::Session::resume(study, study::SessionId{1});
    tests::walkToTheEnd(session);
  }
  push("oslo");
  EXPECT_EQ(contentOf({pulled()}), contentOf({folderOf("oslo")}));
  EXPECT_EQ(problemsOf(scratch_ / "union"), kNone);
}

TEST_F(Collection, TwoCopiesOfAStationThatBothGoOnAreNoticed) {
  addStation("oslo");
  runSession("oslo");
  std::filesystem::copy(
      folderOf("oslo"), scratch_ / "copy", std::filesystem::copy_options::recursive);
  runSession("oslo");
  push("oslo");
  // An older copy that has nothing of its own yet.
  EXPECT_THROW(pushFrom(scratch_ / "copy", "oslo"), study::UserError);
  {
    const auto account = accountOf("oslo");
    auto copy = Study::open(scratch_ / "copy", clock_);
    auto session = tests::consenting(copy, {.cohort = "students"});
    tests::walkToTheEnd(session);
  }
  EXPECT_THROW(pushFrom(scratch_ / "copy", "oslo"), study::UserError);
  EXPECT_EQ(incidents(), std::vector<std::string>{"fork"});
  EXPECT_EQ(contentOfServer(), contentOf({folderOf("oslo")}));
}

TEST_F(Collection, AServerThatStopsAtOnceLosesNothingThatItAcknowledged) {
  addStation("oslo");
  for (int stops = 0; stops < 3; ++stops) {
    runSession("oslo");
    push("oslo");
    const auto before = contentOfServer();
    postgres().stop(study::collect::PrivateServer::Stop::Immediate);
    EXPECT_THROW(push("oslo"), ServerError);
    postgres().start();
    EXPECT_EQ(contentOfServer(), before);
  }
  EXPECT_EQ(contentOfServer(), contentOf({folderOf("oslo")}));
}

TEST_F(Collection, PushesThatAreKilledLoseAndDoubleNothing) {
  const int kills = tests::inLongForm(200, 25);
  addStation("oslo");
  simulate("oslo", 2);
  // A line that carries nothing more after so many bytes: how far a push gets does not depend on
  // the computer's speed.
  tests::Line line(fmt::format("{}/.s.PGSQL.{}", postgres().folder().string(), postgres().port()));
  int cutShort = 0;
  for (int i = 0; i < kills; ++i) {
    if (i % 5 == 0) runSession("oslo");
    const auto bytes = static_cast<std::size_t>(1'000 + i * 7'001 % 90'000);
    line.set(tests::Line::Fault::Stop, bytes);
    const pid_t pushing = fork();
    if (pushing == 0) {
      try {
        const auto account = accountOf("oslo");
        study::collect::Outbox outbox(folderOf("oslo"), clock_);
        outbox.setLimits({.events = 20, .traceBytes = 50'000});
        study::collect::Connection server(line.server(database()), "station_oslo");
        study::collect::push(outbox, server);
      } catch (const std::exception&) {
        _exit(1);  // the server was stopped
      }
      _exit(0);
    }
    int status = 0;
    bool isOver = false;
    while (!isOver && line.carried() < bytes) {
      usleep(500);
      isOver = waitpid(pushing, &status, WNOHANG) == pushing;
    }
    const bool stopsServer = i % 5 == 4;
    if (stopsServer) postgres().stop(study::collect::PrivateServer::Stop::Immediate);
    if (!isOver) {
      kill(pushing, SIGKILL);
      waitpid(pushing, &status, 0);
    }
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) ++cutShort;
    if (stopsServer) postgres().start();
  }
  EXPECT_GT(cutShort, kills / 2) << "the control: pushes were cut short";
  const auto last = push("oslo").lastEvent;
  EXPECT_EQ(count("event"), last);
  EXPECT_EQ(contentOfServer(), contentOf({folderOf("oslo")}));
  EXPECT_EQ(contentOf({pulled()}), contentOf({folderOf("oslo")}));
  EXPECT_EQ(incidents(), kNone);
}

// Controls: the comparison above has to notice what is lost and what is doubled.

TEST_F(Collection, ALostBatchIsNoticed) {
  addStation("oslo");
  runSession("oslo");
  runSession("oslo");
  push("oslo");
  admin().execute("DELETE FROM palpate.session WHERE number = 2");
  EXPECT_NE(contentOfServer(), contentOf({folderOf("oslo")}));
  pulled();
  EXPECT_EQ(result_.stations.at(0).incomplete.size(), 1U);
}

TEST_F(Collection, WithoutTheChecksOfIngestEventsAreDoubled) {
  addStation("oslo");
  runSession("oslo");
  admin().execute(
      "ALTER TABLE palpate.event DROP CONSTRAINT event_pkey;"
      "DO $$ BEGIN EXECUTE replace(pg_get_functiondef('palpate.ingest'::regproc), "
      "'seq = reached)', 'seq = reached LIMIT 1)'); END $$");
  const auto account = accountOf("oslo");
  study::collect::Outbox outbox(folderOf("oslo"), clock_);
  auto server = as("station_oslo");
  for (int times = 0; times < 2; ++times) {
    admin().execute("UPDATE palpate.station SET have = 0");
    outbox.forEachBatch(0, [&](const study::collect::Batch& batch) {
      study::collect::ingest(server, batch);
      return true;
    });
  }
  EXPECT_EQ(count("event"), 2 * outbox.lastEvent());
}

TEST_F(Collection, AnErasureTravelsToTheServerAndToEveryLaterPull) {
  addStation("oslo");
  const auto code = runSession("oslo");
  runSession("oslo");
  push("oslo");
  const auto early = pulled("early");
  std::string erasedUtc;
  {
    const auto account = accountOf("oslo");
    auto study = Study::open(folderOf("oslo"), clock_);
    study::erase(study, {.participant = code, .reason = "asked for it"});
    erasedUtc = study::storage::ErasureRepository(study.database()).all().at(0).utc;
  }
  push("oslo");
  EXPECT_EQ(count("content_key"), 1);
  EXPECT_EQ(count("tombstone"), 1);
  auto server = admin();
  EXPECT_EQ(server.query("SELECT count(*) FROM palpate.answer WHERE number = 1").number(0, 0), 0);
  EXPECT_EQ(contentOf({pulled()}), contentOf({folderOf("oslo")}));
  EXPECT_EQ(result_.stations.at(0).erased, 1U);
  EXPECT_EQ(problemsOf(scratch_ / "union"), kNone);
  {
    const auto account = accountOf("analyst");
    auto study = Study::open(scratch_ / "union", clock_);
    const auto erased = study::storage::ErasureRepository(study.database()).all().at(0);
    EXPECT_EQ(erased.utc, erasedUtc);
    EXPECT_EQ(erased.level, study::storage::ErasureLevel::All);
  }
  // A folder that was pulled before forgets as well, when it is opened on that computer.
  const auto account = accountOf("analyst");
  auto study = Study::open(early, clock_);
  EXPECT_EQ(study.sessions().all().front().state, study::SessionState::Erased);
}

TEST_F(Collection, APublicExportIsComparedWithThoseOfFoldersThatWerePulledEarlier) {
  const auto publish = [&](const std::string& name) -> std::string {
    push("oslo");
    const auto account = accountOf("analyst");
    auto study = Study::open(pulled(name), clock_);
    try {
      exportStudy(study, scratch_ / ("public-" + name), {.publicClassSize = 5});
      return "";
    } catch (const study::storage::StorageError& error) {
      return error.what();
    }
  };
  addStation("oslo");
  for (int i = 0; i < 5; ++i) runSession("oslo");
  EXPECT_EQ(publish("first"), "");
  EXPECT_EQ(publish("again"), "") << "the same people";
  runSession("oslo");
  EXPECT_NE(publish("second").find("1 of them new"), std::string::npos);
}

TEST_F(Collection, SessionsOfACollectedStudyCannotGoOn) {
  addStation("oslo");
  runSession("oslo");
  push("oslo");
  const auto account = accountOf("analyst");
  auto study = Study::open(pulled(), clock_);
  EXPECT_THROW(study::Session::enrol(study, {.cohort = "students"}), study::UserError);
  EXPECT_THROW(study::Session::resume(study, study::SessionId{1}), study::UserError);
}

// What the owner of the server can change is noticed. What is signed by others is pulled.

TEST_F(Collection, ATrailThatWasRewrittenOnTheServerIsNotPulled) {
  addStation("oslo");
  addStation("bergen");
  runSession("oslo");
  runSession("bergen");
  push("oslo");
  push("bergen");
  admin().execute(
      "ALTER TABLE palpate.event DISABLE TRIGGER an_event_is_never_changed;"
      "UPDATE palpate.event SET utc = '2031-01-01T00:00:00.000Z' WHERE seq = 3 AND station = "
      "(SELECT id FROM palpate.station WHERE label = 'oslo')");
  EXPECT_EQ(contentOf({pulled()}), contentOf({folderOf("bergen")}));
  EXPECT_EQ(problemsOf(scratch_ / "union"), kNone);
  EXPECT_FALSE(result_.isSound());
  EXPECT_TRUE(problemsOfStation("bergen").empty());
  EXPECT_FALSE(problemsOfStation("oslo").empty());
}

TEST_F(Collection, ATrailWithAHoleIsPulledUpToTheLastSignatureBeforeIt) {
  addStation("oslo");
  addStation("bergen");
  const auto first = runSession("oslo");
  runSession("oslo");
  runSession("bergen");
  push("oslo");
  push("bergen");
  admin().execute(
      "ALTER TABLE palpate.event DISABLE TRIGGER an_event_is_never_changed;"
      "DELETE FROM palpate.event WHERE seq = (SELECT have - 5 FROM palpate.station WHERE label = "
      "'oslo') AND station = (SELECT id FROM palpate.station WHERE label = 'oslo')");
  const auto content = contentOf({pulled()});
  EXPECT_EQ(result_.sessions(), 2U);
  EXPECT_EQ(content.count(first + "/1"), 1U);
  EXPECT_TRUE(problemsOfStation("bergen").empty());
  EXPECT_FALSE(problemsOfStation("oslo").empty());
}

TEST_F(Collection, WhatCameBeforeARewrittenEventIsPulled) {
  addStation("oslo");
  const auto first = runSession("oslo");
  runSession("oslo");
  push("oslo");
  admin().execute(
      "ALTER TABLE palpate.event DISABLE TRIGGER an_event_is_never_changed;"
      "UPDATE palpate.event SET utc = '2031-01-01T00:00:00.000Z' WHERE seq = "
      "(SELECT max(seq) - 5 FROM palpate.event)");
  const auto content = contentOf({pulled()});
  EXPECT_EQ(result_.sessions(), 1U);
  EXPECT_EQ(content.count(first + "/1"), 1U);
  EXPECT_FALSE(result_.isSound());
}

TEST_F(Collection, RowsThatWereChangedWithTheirHashOnTheServerAreNotPulled) {
  const std::vector<std::string> changes{
      R"(replace(facts, '"status":"finished"', '"status":"repeated"'))",
      R"(replace(facts, '"site":"oslo"', '"site":"bergen"'))",
      R"(replace(facts, '"state":"completed"', '"state":"withdrawn"'))",
      R"(replace(facts, '"language":"en"', '"language":"de"'))",
      R"(regexp_replace(facts, '"device":"[^"]+"', '"device":"another"'))",
      R"(regexp_replace(facts, '"peak_n":[0-9.]+', '"peak_n":1.5'))",
      R"(regexp_replace(facts, '"duration_s":[0-9.]+', '"duration_s":9.5'))",
      R"(regexp_replace(facts, '"point":[0-9]', '"point":null'))",
      R"(regexp_replace(facts, '"condition":"[^"]+"', '"condition":"other"'))",
      R"(regexp_replace(facts, '"slot":[0-9]+', '"slot":17'))",
      R"(replace(facts, '_P001', '_P009'))",
      R"(regexp_replace(facts, '"trial":\[.*\],"visit"', '"trial":[],"visit"'))",
  };
  addStation("oslo");
  runSession("oslo");
  simulate("oslo", 1);
  push("oslo");
  const auto sound = contentOf({pulled("control")});
  EXPECT_TRUE(result_.isSound()) << "the control: unchanged it is pulled";
  EXPECT_EQ(sound, contentOf({folderOf("oslo")}));
  auto server = admin();
  server.execute("CREATE TABLE kept AS SELECT number, facts, sha256 FROM palpate.session");
  int number = 0;
  for (const auto& change : changes) {
    const auto rows = server.query(
        "UPDATE palpate.session AS s SET facts = x.facts, sha256 = sha256(convert_to(x.facts, "
        "'UTF8')) FROM (SELECT number, " +
        change +
        " AS facts FROM kept) AS x WHERE x.number = s.number AND x.facts <> s.facts "
        "RETURNING s.number");
    EXPECT_FALSE(rows.isEmpty()) << change << " changed nothing";
    pulled("changed-" + std::to_string(++number));
    EXPECT_EQ(result_.sessions(), 2U - static_cast<std::size_t>(rows.count())) << change;
    EXPECT_FALSE(result_.isSound()) << change;
    server.execute(
        "UPDATE palpate.session AS s SET facts = k.facts, sha256 = k.sha256 FROM kept AS k "
        "WHERE k.number = s.number");
  }
  EXPECT_EQ(contentOf({pulled("again")}), sound);
}

TEST_F(Collection, SamplesThatWereExchangedOnTheServerAreNotPulled) {
  addStation("oslo");
  simulate("oslo", 2);
  push("oslo");
  admin().execute(
      "UPDATE palpate.chunk AS c SET data = o.data, hash = o.hash, samples = o.samples "
      "FROM palpate.chunk AS o WHERE c.session = 1 AND c.number = 0 AND o.session = 2 "
      "AND o.number = 0 AND o.step = c.step");
  pulled();
  EXPECT_EQ(result_.sessions(), 1U);
  EXPECT_FALSE(result_.isSound());
}

}  // namespace collection_test

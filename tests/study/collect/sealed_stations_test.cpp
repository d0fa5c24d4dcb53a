// What was measured is sealed at stations, and in the folder that is pulled.
#include <memory>
#include <optional>
#include <string>

#include "study/collect/exchange/pull.h"
#include "study/session/verification.h"
#include "study/storage/records.h"
#include "study/storage/study_schema.h"
#include "tests/study/collect/collected_study_at.h"
#include "tests/study/storage/sql.h"
#include "tests/study/walk.h"

namespace sealed_stations_test {

using study::EventKind;
using study::Study;
using study::storage::Database;
using study::storage::Records;

/// From now on the connection has no key: programs before stored what was measured in the open.
void forgetKey(Database& database, const study::storage::Schema& schema) {
  const auto path = database.path();
  std::destroy_at(&database);
  std::construct_at(&database, Database::open(path, schema, Database::Access::ReadWrite));
}

class SealedStations : public tests::CollectTest {
 protected:
  /// A session of an earlier program, which this one goes on with after as many trials.
  void runEarlierSession(const std::string& label, int trials) {
    const auto account = accountOf(label);
    std::optional<study::SessionId> id;
    {
      auto study = Study::open(folderOf(label), clock_);
      auto session = tests::consenting(study, {.cohort = "surgeons"});
      id = session.id();
      forgetKey(study.database(), study::storage::studySchema());
      forgetKey(study.traces().database(), study::storage::traceSchema());
      feelAll(study, session, trials);
    }
    auto study = Study::open(folderOf(label), clock_);
    if (study::isOver(study.sessions().load(*id).state)) return;
    auto session = study::Session::resume(study, *id);
    feelAll(study, session);
  }

  std::string pulled() {
    const auto account = accountOf("analyst");
    auto server = admin();
    const auto result = study::collect::pull(
        server, {.folder = scratch_ / "union", .reason = "to evaluate"}, clock_);
    EXPECT_TRUE(result.isSound());
    for (const auto& station : result.stations) {
      EXPECT_EQ(station.problems, std::vector<std::string>());
    }
    EXPECT_EQ(result.problems, std::vector<std::string>());
    return scratch_ / "union";
  }

  /// With the key all numbers are what was measured.
  void expectNumbers(const std::string& folder, const std::string& owner, std::size_t trials) {
    const auto account = accountOf(owner);
    auto study = Study::open(folder, clock_, Database::Access::ReadOnly);
    const auto rows = Records(study.database()).trials();
    EXPECT_EQ(rows.size(), trials);
    for (const auto& row : rows) {
      EXPECT_EQ(row.duration, 4.125);
      EXPECT_EQ(row.ticks, 4125);
      EXPECT_EQ(row.latenessP99, 3.0);
      EXPECT_EQ(row.slewed, 1.0 / 3.0);
      EXPECT_EQ(row.largestForce, 6.02);
      const auto samples = study.traces().read(row.step.visit);
      ASSERT_EQ(samples.size(), 500U);
      EXPECT_EQ(samples.back().force, 5.0F);
    }
    std::size_t yields = 0;
    for (const auto& cut : Records(study.database()).cuts()) {
      if (cut.yieldForce == 5.75 && cut.yieldTravel == 9.5 && cut.peakForce == 6.02) ++yields;
    }
    EXPECT_EQ(yields, trials);
    for (const auto& event : study.events().read()) EXPECT_FALSE(event.isSealed || event.isErased);
    EXPECT_TRUE(study::verify(study).isSound());
  }

  struct Told {
    bool byTrials = false;
    bool byCuts = false;
    bool bySamples = false;
    bool byEvents = false;
  };

  /// What a copy of the folder tells an account that has not the key.
  Told toldBy(const std::string& folder) {
    Told told;
    tests::Sql sql(folder + "/study.db");
    told.byTrials = sql.number(
                        "SELECT sum(duration_s + ticks + slewed_s + largest_force_n + cuts) "
                        "FROM trial") != 0;
    told.byCuts = sql.number("SELECT count(*) FROM cut") != 0;
    // Of samples in the open the size is known.
    told.bySamples = tests::Sql(folder + "/traces.db")
                         .number(
                             "SELECT count(*) FROM chunk WHERE layout <= 2 OR "
                             "length(data) % samples = 0") != 0;
    const auto account = accountOf("elsewhere");
    auto study = Study::open(folder, clock_, Database::Access::ReadOnly);
    int sealed = 0;
    for (const auto& event : study.events().read()) {
      EXPECT_FALSE(event.isErased);
      sealed += event.isSealed;
      const bool reveals = event.kind == EventKind::Passivity ||
                           event.kind == EventKind::FinishedTrial ||
                           event.kind == EventKind::SafetySlewed;
      told.byEvents = told.byEvents || (reveals && !event.isSealed);
    }
    EXPECT_GT(sealed, 0);
    EXPECT_TRUE(study::verify(study).isSound());
    EXPECT_THROW(Records(study.database()).trials(), study::storage::StorageError);
    return told;
  }
};

TEST_F(SealedStations, AndTheFolderThatIsPulledTellNothingWithoutTheKey) {
  addStation("oslo");
  addStation("bergen");
  runSession("oslo");
  runSession("bergen");
  runSession("bergen");
  push("oslo");
  push("bergen");
  const auto folder = pulled();
  EXPECT_EQ(contentOf({folder}), contentOf({folderOf("oslo"), folderOf("bergen")}));
  const auto trials = static_cast<std::size_t>(
      tests::Sql(folderOf("oslo") + "/study.db").number("SELECT count(*) FROM trial"));
  EXPECT_GT(trials, 1U);
  expectNumbers(folderOf("oslo"), "oslo", trials);
  expectNumbers(folder, "analyst", 3 * trials);
  for (const auto& each : {folderOf("oslo"), folderOf("bergen"), folder}) {
    const auto told = toldBy(each);
    EXPECT_FALSE(told.byTrials) << each;
    EXPECT_FALSE(told.byCuts) << each;
    EXPECT_FALSE(told.bySamples) << each;
    EXPECT_FALSE(told.byEvents) << each;
  }
}

/// The control of the test above, too: what lies in the open is found.
TEST_F(SealedStations, SendWhatAnEarlierProgramLeftInTheOpenAndPullingSealsIt) {
  addStation("oslo");
  runEarlierSession("oslo", 100);
  runEarlierSession("oslo", 1);
  runSession("oslo");
  push("oslo");
  const auto folder = pulled();
  EXPECT_EQ(contentOfServer(), contentOf({folderOf("oslo")}));
  EXPECT_EQ(contentOf({folder}), contentOf({folderOf("oslo")}));
  const auto trials = static_cast<std::size_t>(
      tests::Sql(folderOf("oslo") + "/study.db").number("SELECT count(*) FROM trial"));
  expectNumbers(folderOf("oslo"), "oslo", trials);
  expectNumbers(folder, "analyst", trials);
  const auto open = toldBy(folderOf("oslo"));
  EXPECT_TRUE(open.byTrials && open.byCuts && open.bySamples && open.byEvents);
  const auto told = toldBy(folder);
  EXPECT_FALSE(told.byTrials || told.byCuts || told.bySamples || told.byEvents);
}

TEST_F(SealedStations, SendNothingWithoutTheKey) {
  addStation("oslo");
  runSession("oslo");
  const auto account = accountOf("elsewhere");
  study::collect::Outbox outbox(folderOf("oslo"), clock_);
  auto server = as("station_oslo");
  try {
    study::collect::push(outbox, server);
    FAIL() << "it was sent";
  } catch (const study::storage::StorageError& error) {
    EXPECT_NE(std::string(error.what()).find("study key import"), std::string::npos);
  }
}

}  // namespace sealed_stations_test

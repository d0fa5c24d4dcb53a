// A computer becomes a station of a study: its file, its orders, its codes.
#include "study/collect/exchange/enrolment.h"

#include <algorithm>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "protocols/orders/schedule.h"
#include "study/cohort/simulated_participant.h"
#include "study/collect/exchange/batch.h"
#include "study/collect/server/connection.h"
#include "study/model/user_error.h"
#include "study/session/drawn_plan.h"
#include "study/session/study.h"
#include "study/storage/transfer/session_facts.h"
#include "tests/study/made_study.h"
#include "tests/study/walk.h"

namespace enrolment_test {

using study::Study;
using study::storage::StationStore;

class JoinTest : public testing::Test {
 protected:
  study::collect::StationEnrolment enrolment(const std::string& label) const {
    const auto protocol = tests::protocolFrom(tests::shortProtocol());
    const auto hash = study::storage::sha256(protocol.text, protocol.files);
    return {
        .study = tests::knownSecret().studyUuid(1, hash),
        .title = "A short study",
        .seed = 1,
        .secret = tests::knownSecret().of(label),
        .station = {.site = "oslo", .label = label, .uuid = std::string(31, 'a') + label.back()},
        .server = "host=/nowhere dbname=study",
        .role = "station_oslo",
        .expiresUtc = "2060-01-01T00:00:00.000Z",
        .protocols = {{.text = protocol.text, .files = protocol.files}}};
  }

  static StationStore station() {
    return StationStore::openOrCreate(StationStore::defaultFolder());
  }

  std::string fileFor(const std::string& label, const std::string& key) const {
    return scratch_.write(
        label + ".enrolment", asText(enrolment(label), key, tests::knownSecret()));
  }

  tests::ScratchFolder scratch_;
  tests::OwnStation account_{scratch_ / "account"};
  study::SimulatedClock clock_;
};

TEST_F(JoinTest, MakesAStudyThatKnowsItsStation) {
  study::collect::join(fileFor("oslo", station().publicKey()), scratch_ / "study", clock_);
  const auto study = Study::open(scratch_ / "study", clock_);
  EXPECT_EQ(study.station().site, "oslo");
  EXPECT_EQ(study.station().label, "oslo");
  EXPECT_FALSE(study.isCollected());
  EXPECT_EQ(study::collect::serverSettingsOf(scratch_ / "study").role, "station_oslo");
}

TEST_F(JoinTest, EachStationSimulatesItsOwnPeople) {
  study::collect::join(fileFor("oslo-1", station().publicKey()), scratch_ / "one", clock_);
  study::collect::join(fileFor("oslo-2", station().publicKey()), scratch_ / "two", clock_);
  const auto one = Study::open(scratch_ / "one", clock_);
  const auto two = Study::open(scratch_ / "two", clock_);
  EXPECT_NE(study::simulationSeed(one), study::simulationSeed(two));
  EXPECT_EQ(study::simulationSeed(one), study::simulationSeed(one));
}

TEST_F(JoinTest, AFileIsUsedOnce) {
  const auto file = fileFor("oslo", station().publicKey());
  study::collect::join(file, scratch_ / "study", clock_);
  EXPECT_THROW(study::collect::join(file, scratch_ / "second", clock_), study::UserError);
}

TEST_F(JoinTest, AFileForAnotherComputerIsRefused) {
  const auto file = fileFor("oslo", station().publicKey());
  const tests::OwnStation other(scratch_ / "another account");
  EXPECT_THROW(study::collect::join(file, scratch_ / "study", clock_), study::UserError);
}

TEST_F(JoinTest, AChangedFileIsRefused) {
  auto text = asText(enrolment("oslo"), station().publicKey(), tests::knownSecret());
  const auto at = text.find("\"sealed\": \"") + 40;
  text[at] = text[at] == 'A' ? 'B' : 'A';
  EXPECT_THROW(
      study::collect::join(scratch_.write("changed", text), scratch_ / "study", clock_),
      study::UserError);
  EXPECT_THROW(
      study::collect::join(scratch_.write("none", "{}"), scratch_ / "study", clock_),
      study::UserError);
}

TEST_F(JoinTest, EveryWordOfAFileIsSigned) {
  const auto text = asText(enrolment("oslo"), station().publicKey(), tests::knownSecret());
  for (const std::string word : {"A short study", "oslo", "2060-"}) {
    auto changed = text;
    changed[changed.find(word)] = '1';
    EXPECT_THROW(
        study::collect::join(scratch_.write("changed", changed), scratch_ / "study", clock_),
        study::UserError)
        << word;
  }
}

TEST_F(JoinTest, AFileOfSomebodyElseHasAnotherMark) {
  const auto mark = study::collect::keyFingerprintOf(tests::knownSecret());
  EXPECT_EQ(mark.size(), 24U);
  const auto theirs = study::storage::BlindingSecret::drawn();
  EXPECT_NE(study::collect::keyFingerprintOf(theirs), mark);
  const auto forged =
      scratch_.write("forged", asText(enrolment("oslo"), station().publicKey(), theirs));
  EXPECT_THROW(study::collect::join(forged, scratch_ / "study", clock_, mark), study::UserError);
  EXPECT_FALSE(std::filesystem::exists(scratch_ / "study"));
  const auto file = fileFor("oslo", station().publicKey());
  EXPECT_EQ(study::collect::join(file, scratch_ / "study", clock_, mark).mark, mark);
}

TEST_F(JoinTest, AMarkIsRemembered) {
  study::collect::join(fileFor("oslo", station().publicKey()), scratch_ / "study", clock_);
  const auto forged = scratch_.write(
      "forged",
      asText(enrolment("oslo-2"), station().publicKey(), study::storage::BlindingSecret::drawn()));
  EXPECT_THROW(study::collect::join(forged, scratch_ / "second", clock_), study::UserError);
  EXPECT_FALSE(std::filesystem::exists(scratch_ / "second"));
}

TEST_F(JoinTest, AFileThatIsTooOldIsRefused) {
  const auto file = fileFor("oslo", station().publicKey());
  clock_.setWall(3'000'000'000'000);
  EXPECT_THROW(study::collect::join(file, scratch_ / "study", clock_), study::UserError);
}

TEST_F(JoinTest, TheFileTellsNothingToOthers) {
  const auto text = asText(enrolment("oslo"), station().publicKey(), tests::knownSecret());
  EXPECT_EQ(text.find("interpolation"), std::string::npos);
  EXPECT_EQ(text.find("host="), std::string::npos);
}

/// The conditions of a cohort's first places, by numbers in the order in which they come first: the
/// same for orders in which conditions have changed parts.
std::string patternAt(
    const std::string& label, Study& study, study::RunMode mode = study::RunMode::Live) {
  std::map<std::string, std::size_t> numbers;
  std::string pattern;
  for (int slot = 0; slot < 12; ++slot) {
    const study::storage::SessionRow row{
        .protocol = study.protocols().current().id,
        .runMode = mode,
        .cohort = "surgeons",
        .language = "en",
        .station = label,
        .slot = slot};
    for (const auto& step : study::drawnPlan(study, row)) {
      if (step.kind != study::StepKind::Trial) continue;
      pattern += std::to_string(numbers.emplace(step.condition, numbers.size()).first->second);
    }
  }
  return pattern;
}

TEST_F(JoinTest, OrdersOfAStationCannotBeComputedWithoutItsSecret) {
  std::set<std::string> patterns;
  for (const auto* place : {"first", "second"}) {
    auto same = enrolment("oslo");  // all that other stations know is the same
    same.station.uuid.front() = *place;
    same.secret = tests::knownSecret().of(place);
    const auto file = scratch_.write(
        std::string(place) + ".enrolment",
        asText(same, station().publicKey(), tests::knownSecret()));
    study::collect::join(file, scratch_ / place, clock_);
    auto study = Study::open(scratch_ / place, clock_);
    patterns.insert(patternAt("oslo", study));
  }
  EXPECT_EQ(patterns.size(), 2U);
}

TEST_F(JoinTest, CodesBeginWithTheStation) {
  study::collect::join(fileFor("oslo-2", station().publicKey()), scratch_ / "study", clock_);
  auto study = Study::open(scratch_ / "study", clock_);
  const auto drawn = study::Session::enrol(study, {.cohort = "surgeons"});
  EXPECT_EQ(drawn.participant(), "oslo-2_P001");
  EXPECT_EQ(
      study::Session::enrol(study, {.cohort = "surgeons", .code = "K7"}).participant(),
      "oslo-2_K7");
  EXPECT_EQ(study.sessions().load(drawn.id()).site, "oslo");
}

/// The orders of a cohort's first places at a station; none: a study of one machine.
std::vector<std::string> ordersAt(const std::string& label, Study& study) {
  std::vector<std::string> orders;
  for (int slot = 0; slot < 12; ++slot) {
    study::storage::SessionRow row{
        .protocol = study.protocols().current().id,
        .runMode = study::RunMode::Simulated,
        .cohort = "surgeons",
        .language = "en",
        .station = label,
        .slot = slot};
    std::string order;
    for (const auto& step : study::drawnPlan(study, row)) {
      if (step.kind == study::StepKind::Trial) order += step.condition + " ";
    }
    orders.push_back(order);
  }
  return orders;
}

TEST(OrdersOfStations, AStudyOfOneMachineDrawsWhatItsSeedDraws) {
  tests::MadeStudy made;
  const auto orders = ordersAt("", *made);
  for (std::size_t slot = 0; slot < orders.size(); ++slot) {
    const auto schedule =
        protocols::scheduleFor(made->protocol().protocol, made->seed(), "surgeons", slot);
    std::string order;
    for (const auto& trial : schedule.blocks.front().trials) order += trial.condition + " ";
    EXPECT_EQ(orders[slot], order);
  }
}

TEST(OrdersOfStations, AStationThatWasEnrolledBeforeGoesOnAsItBegan) {
  tests::MadeStudy made;  // its trail does not say that orders are drawn with the secret
  EXPECT_EQ(patternAt("oslo", *made), patternAt("oslo", *made, study::RunMode::Simulated));
}

TEST(OrdersOfStations, EachStationIsBalancedByItself) {
  tests::MadeStudy made;
  const auto oslo = ordersAt("oslo", *made);
  EXPECT_NE(oslo, ordersAt("", *made));
  EXPECT_NE(oslo, ordersAt("bergen", *made));
  // Three conditions in a balanced Latin square: six orders, each as often as the others.
  std::map<std::string, int> times;
  for (const auto& order : oslo) ++times[order];
  EXPECT_EQ(times.size(), 6U);
  for (const auto& [order, count] : times) EXPECT_EQ(count, 2) << order;
}

TEST(OrdersOfStations, AllStationsAreBalancedToAsManyPlacesAsThereAre) {
  tests::MadeStudy made;
  std::vector<std::vector<std::string>> orders;
  for (const auto* label : {"oslo", "oslo-2", "bergen", "tromso"}) {
    orders.push_back(ordersAt(label, *made));
  }
  const std::map<std::string, int> none = [&] {
    std::map<std::string, int> all;
    for (const auto& order : orders.front()) all[order] = 0;
    return all;
  }();
  int largest = 0;
  // However many have come to each: the stations know nothing of each other.
  std::mt19937 random(20261125);
  for (int tries = 0; tries < 2000; ++tries) {
    auto times = none;
    for (const auto& station : orders) {
      const auto people = random() % (station.size() + 1);
      for (std::size_t slot = 0; slot < people; ++slot) ++times[station[slot]];
    }
    const auto [least, most] =
        std::minmax_element(times.begin(), times.end(), [](const auto& a, const auto& b) {
          return a.second < b.second;
        });
    largest = std::max(largest, most->second - least->second);
  }
  EXPECT_LE(largest, static_cast<int>(orders.size()));
  EXPECT_GE(largest, 2) << "the control: one station alone is balanced to one place";
}

TEST(OrdersOfStations, ASecretOfAStationTellsNothingOfTheOthers) {
  const auto secret = tests::knownSecret();
  EXPECT_NE(secret.of("oslo").bytes(), secret.of("bergen").bytes());
  EXPECT_NE(secret.of("oslo").bytes(), secret.bytes());
  EXPECT_EQ(secret.of("oslo").bytes(), secret.of("oslo").bytes());
}

TEST(SessionTables, ComeBackAsTheyWere) {
  tests::MadeStudy made;
  auto session = tests::consenting(*made, {.cohort = "surgeons"});
  tests::walkToTheEnd(session);
  const auto facts = study::storage::sessionTablesOf(made->database(), session.id());
  const auto text = study::collect::asText(facts);
  EXPECT_EQ(study::collect::asText(study::collect::sessionTablesIn(text)), text);
  EXPECT_EQ(study::collect::sessionTablesIn(text), facts);
}

TEST(SessionTables, AColumnThatThisProgramDoesNotKnowIsRefused) {
  tests::MadeStudy made;
  auto session = tests::consenting(*made, {.cohort = "surgeons"});
  auto facts = study::storage::sessionTablesOf(made->database(), session.id());
  facts["visit"].front()["mood"] = std::string("good");
  EXPECT_THROW(
      study::storage::addSessionTables(made->database(), facts), study::storage::StorageError);
}

TEST(ServerAddress, APasswordInItIsRefused) {
  EXPECT_THROW(study::collect::Connection("host=x password=secret"), study::UserError);
  EXPECT_THROW(study::collect::Connection("postgresql://me:secret@x/study"), study::UserError);
  EXPECT_THROW(study::collect::Connection("nonsense"), study::UserError);
}

TEST(ServerAddress, AServerThatIsNotThereIsSaidInWords) {
  try {
    const study::collect::Connection none("host=/nonexistent dbname=study");
    FAIL() << "it is connected";
  } catch (const study::collect::ServerError& error) {
    EXPECT_EQ(error.kind(), study::collect::ServerError::Kind::Unreachable);
    EXPECT_NE(std::string(error.what()).find("Nothing is lost"), std::string::npos);
  }
}

}  // namespace enrolment_test

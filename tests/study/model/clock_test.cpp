#include "study/model/clock.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "study/export/export.h"
#include "study/session/verification.h"
#include "study/storage/statement.h"
#include "tests/study/made_study.h"
#include "tests/study/storage/sql.h"
#include "tests/study/walk.h"

namespace study {
namespace clock_test {

namespace fs = std::filesystem;

TEST(Clock, WritesTimesOfTheWholeCalendar) {
  EXPECT_EQ(asUtc(0), "1970-01-01T00:00:00.000Z");
  EXPECT_EQ(asUtc(1'795'181'707'381), "2026-11-20T13:35:07.381Z");  // date -u -d @1795181707
  EXPECT_EQ(asUtc(2'147'483'648'000), "2038-01-19T03:14:08.000Z");  // one second after 2³¹ − 1
  EXPECT_EQ(asUtc(951'782'399'999), "2000-02-28T23:59:59.999Z");
  EXPECT_EQ(asUtc(951'782'400'000), "2000-02-29T00:00:00.000Z");
  EXPECT_EQ(asUtc(-1), "1969-12-31T23:59:59.999Z");
}

TEST(Clock, OfThisComputerAdvances) {
  SystemClock clock;
  const auto first = clock.now();
  const auto second = clock.now();
  EXPECT_GE(second.monotonic, first.monotonic);
  EXPECT_GT(first.wall, 1'700'000'000'000);  // 2023-11-14
}

std::vector<storage::Event> stepsOf(Study& study) {
  std::vector<storage::Event> stepped;
  for (const auto& event : study.events().read()) {
    if (event.kind == EventKind::ClockStepped) stepped.push_back(event);
  }
  return stepped;
}

class SteppedClockTest : public testing::Test {
 protected:
  void answerAfter(double seconds) {
    study_.clock.advance(seconds);
    tests::answerStep(session_);
  }

  tests::MadeStudy study_;
  Session session_ = Session::enrol(*study_, {.cohort = "surgeons"});
};

TEST_F(SteppedClockTest, IsNotedAndChangesNoOrderAndNoDuration) {
  answerAfter(10.0);
  study_.clock.advance(5.0);
  study_.clock.setWall(study_.clock.now().wall - 3'600'000);  // one hour back
  session_.finishStep();
  const auto stepped = stepsOf(*study_);
  ASSERT_EQ(stepped.size(), 1U);
  EXPECT_EQ(storage::describe(stepped[0]), "by -3600.000000 s; durations are not affected");

  const auto events = study_->events().read(session_.id());
  for (std::size_t i = 1; i < events.size(); ++i) {
    EXPECT_GE(events[i].when.monotonic, events[i - 1].when.monotonic);
  }
  // times of the wall clock are stored unchanged
  EXPECT_LT(events.back().when.wall, events.front().when.wall);
  EXPECT_EQ(events.back().name(), "gave_consent");
  EXPECT_TRUE(verify(*study_).isSound());

  const auto tables = exportTables(*study_, {.isBlinded = false, .isExact = true});
  const auto& last = tables.back().rows.back();
  EXPECT_EQ(std::get<double>(last[5]), 15.0);  // onset_s: 10 s and 5 s
}

TEST_F(SteppedClockTest, IsNotNotedForDrift) {
  answerAfter(10.0);
  study_.clock.setWall(study_.clock.now().wall + 1'900);  // less than two seconds
  tests::answerStep(session_);
  EXPECT_TRUE(stepsOf(*study_).empty());
}

TEST_F(SteppedClockTest, NumbersEventsInOrder) {
  answerAfter(1.0);
  study_.clock.setWall(0);
  session_.finishStep();
  storage::Statement seq(study_->database(), "SELECT seq FROM event ORDER BY seq");
  for (std::int64_t expected = 1; seq.step(); ++expected) EXPECT_EQ(seq.number(0), expected);
}

TEST_F(SteppedClockTest, BridgesTheTimeBetweenTwoRunsOfTheProgram) {
  answerAfter(10.0);
  const auto id = session_.id();
  { const Session gone = std::move(session_); }
  study_.reopen();
  // The computer was restarted after half an hour: its monotonic clock begins at 0 again.
  SimulatedClock later(study_.clock.now().wall + 1'800'000);
  auto study = Study::open(study_.folder(), later);
  auto resumed = Session::resume(study, id);
  later.advance(2.0);
  resumed.finishStep();
  const auto events = exportTables(study, {.isBlinded = false, .isExact = true}).back();
  EXPECT_EQ(std::get<double>(events.rows.back()[5]), 1812.0);  // 10 s + 1800 s + 2 s
}

/// A program that crashed during a session, and one that goes on with it when the wall clock has
/// been set by @p seconds and 60 s have passed.
class CrashedSessionTest : public SteppedClockTest {
 protected:
  void crashAndGoOn(const std::string& bootOfTheCrash, std::int64_t seconds) {
    answerAfter(10.0);
    const auto id = session_.id();
    { const Session gone = std::move(session_); }
    tests::Sql(study_.file("study.db"))
        .run(
            "INSERT INTO lease (session_id, station, pid, process, taken_utc) VALUES (1, "
            "'this-one', 1, '" +
            bootOfTheCrash + "/1@" + fs::read_symlink("/proc/self/ns/pid").string() +
            "#1', 'earlier')");
    study_.clock.advance(60.0);
    study_.clock.setWall(study_.clock.now().wall + seconds * 1000);
    auto resumed = Session::resume(*study_, id, "it was replaced");
    study_.clock.advance(2.0);
    resumed.finishStep();
  }
  /// What the event of going on says about the pause.
  std::string resumed() {
    for (const auto& event : study_->events().read(session_.id())) {
      if (event.kind == EventKind::Resumed) return storage::describe(event);
    }
    return "no event";
  }
  double lastOnset() {
    return std::get<double>(
        exportTables(*study_, {.isBlinded = false, .isExact = true}).back().rows.back()[5]);
  }
  static std::string thisBoot() {
    std::string boot;
    std::ifstream("/proc/sys/kernel/random/boot_id") >> boot;
    return boot;
  }
};

TEST_F(CrashedSessionTest, NotesThatTheClockWasSetSinceAndKeepsOnsets) {
  crashAndGoOn(thisBoot(), 630'720'000);  // twenty years
  const auto stepped = stepsOf(*study_);
  ASSERT_EQ(stepped.size(), 1U);
  EXPECT_EQ(storage::describe(stepped[0]), "by 630720000.000000 s; durations are not affected");
  EXPECT_DOUBLE_EQ(lastOnset(), 72.0);  // 10 s, 60 s and 2 s
  EXPECT_EQ(resumed(), "");
  EXPECT_TRUE(verify(*study_).isSound());
}

TEST_F(CrashedSessionTest, NotesThatTheClockWentBackWhereTheComputerWasRestarted) {
  crashAndGoOn("another-boot", -3600);
  ASSERT_EQ(stepsOf(*study_).size(), 1U);
  EXPECT_DOUBLE_EQ(lastOnset(), 12.0);  // how long it lay cannot be told
}

TEST_F(CrashedSessionTest, TakesThePauseFromTheWallClockWhereTheComputerWasRestartedAndSaysSo) {
  crashAndGoOn("another-boot", 1800);
  EXPECT_TRUE(stepsOf(*study_).empty());
  EXPECT_DOUBLE_EQ(lastOnset(), 1872.0);
  EXPECT_EQ(
      resumed(),
      "1860 s after the last event by the wall clock alone: whether that was set in between is not "
      "known");
  EXPECT_TRUE(verify(*study_).isSound());
}

}  // namespace clock_test
}  // namespace study

// What a station signed of a study, and what verify() finds by that.
#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "study/export/export.h"
#include "study/session/backup.h"
#include "study/session/verification.h"
#include "study/storage/evidence/station_heads.h"
#include "tests/study/made_study.h"
#include "tests/study/storage/sql.h"
#include "tests/study/walk.h"

namespace study {
namespace evidence_test {

namespace fs = std::filesystem;
using storage::StationStore;

class Evidence : public testing::Test {
 protected:
  Evidence() { takePart(); }

  static void takePartIn(Study& study, RunMode mode = RunMode::Live) {
    auto session = Session::enrol(study, {.cohort = "surgeons", .runMode = mode});
    tests::walkToTheEnd(session);
  }
  void takePart(RunMode mode = RunMode::Live) { takePartIn(*study_, mode); }

  /// The purposes of all heads that were noted, in order.
  std::string noted() {
    const auto station = StationStore::find(StationStore::defaultFolder());
    std::string purposes;
    for (const auto& each : storage::readRecordedHeads(*station, study_->uuid()).heads) {
      purposes += (purposes.empty() ? "" : " ") + each.head.purpose;
    }
    return purposes;
  }

  /// Runs SQL behind the program's back.
  void edit(const std::string& sql, const std::string& file = "study.db") {
    study_.close();
    tests::Sql(study_.file(file)).run(sql);
    study_.reopen();
  }

  void cutOff(int events) {
    edit(
        "DROP TRIGGER an_event_is_never_removed; DELETE FROM event WHERE seq > "
        "(SELECT max(seq) FROM event) - " +
        std::to_string(events) +
        "; CREATE TRIGGER an_event_is_never_removed BEFORE DELETE ON event\n"
        "      BEGIN SELECT RAISE(ABORT, 'events are never removed'); END;");
  }

  /// As if everything, from the first event on, had been computed again.
  void writeAgain() {
    edit("DROP TRIGGER an_event_is_never_changed; UPDATE event SET hash = randomblob(32)");
  }

  /// What is wrong with the study.
  std::string problems(const VerifyOptions& options = {}) {
    std::string text;
    for (const auto& check : verify(*study_, {}, options).checks) {
      for (const auto& problem : check.problems) text += check.what + ": " + problem + "\n";
    }
    return text;
  }

  std::string remarks() {
    std::string text;
    for (const auto& check : verify(*study_).checks) {
      for (const auto& remark : check.remarks) text += remark + "\n";
    }
    return text;
  }

  tests::MadeStudy study_;
};

TEST_F(Evidence, IsSignedAtTheEndOfEachSessionOfPeople) {
  EXPECT_EQ(noted(), "made_study finished_session");
  takePart(RunMode::Pilot);
  takePart(RunMode::Simulated);
  EXPECT_EQ(noted(), "made_study finished_session finished_session");
  auto session = Session::enrol(*study_, {.cohort = "surgeons"});
  EXPECT_EQ(noted(), "made_study finished_session finished_session");
  session.withdraw("had to go");
  EXPECT_EQ(noted(), "made_study finished_session finished_session withdrew");
  EXPECT_EQ(problems(), "");
}

TEST_F(Evidence, IsSignedWithEachEventOfTheStudy) {
  study_->note(EventKind::UnblindedReport, "a reason");
  study_->amend(tests::protocolFrom(tests::shortProtocol({.minimumCuts = 2})), "a reason");
  exportStudy(*study_, study_.scratch() / "out", {.runMode = RunMode::Live});
  exportStudy(*study_, study_.scratch() / "simulated", {.runMode = RunMode::Simulated});
  backUp(study_.folder(), study_.scratch() / "copy");
  EXPECT_EQ(
      noted(),
      "made_study finished_session unblinded_report amended_protocol exported made_backup");
  EXPECT_EQ(problems(), "");
  EXPECT_EQ(remarks(), "");
}

TEST_F(Evidence, ShowsHereThatTheEndWasCutOff) {
  study_->note(EventKind::UnblindedExport, "a reason");
  for (int events = 1; events <= 3; ++events) {
    cutOff(1);
    EXPECT_NE(problems().find("its end was cut off"), std::string::npos) << events;
  }
}

TEST_F(Evidence, SaysWhatItCannotKnowElsewhere) {
  study_->note(EventKind::UnblindedExport, "a reason");
  cutOff(2);
  const tests::OwnStation elsewhere(study_.scratch() / "elsewhere");
  EXPECT_EQ(problems(), "");
  EXPECT_NE(remarks().find("has noted nothing of"), std::string::npos);
  StationStore::openOrCreate(StationStore::defaultFolder());
  EXPECT_NE(remarks().find("noted nothing of this study"), std::string::npos);
}

TEST_F(Evidence, NamesAnotherStationThatSigned) {
  const auto here = StationStore::find(StationStore::defaultFolder())->publicKey();
  const tests::OwnStation elsewhere(study_.scratch() / "elsewhere");
  takePart();
  EXPECT_EQ(problems(), "");
  EXPECT_NE(
      remarks().find("1 signed by another station, whose key is " + here.substr(0, 4)),
      std::string::npos);
}

TEST_F(Evidence, FindsASignatureOfSomethingElse) {
  edit(
      "DROP TRIGGER an_event_is_never_changed; UPDATE event SET detail = replace(detail, "
      "'\"events\":', '\"events\":1') WHERE kind = 'signed_head';");
  EXPECT_NE(problems().find("the signature in event"), std::string::npos);
}

TEST_F(Evidence, KnowsTheBeginningOfAStudy) {
  writeAgain();
  EXPECT_NE(problems().find("with another first event"), std::string::npos);
}

TEST_F(Evidence, IsNotSignedOnceItWasWrittenAgainFromTheFirstEventOn) {
  const auto before = noted();
  writeAgain();
  takePart();
  exportStudy(*study_, study_.scratch() / "out", {.runMode = RunMode::Live});
  EXPECT_EQ(study_->events().read().back().name(), "head_not_signed");
  EXPECT_EQ(noted(), before);
  EXPECT_NE(problems().find("with another first event"), std::string::npos);
  EXPECT_NE(problems({.isOlderCopy = true}).find("with another first event"), std::string::npos);
}

TEST_F(Evidence, IsNotSignedOnceItsEndWasCutOff) {
  study_->note(EventKind::UnblindedExport, "a reason");
  cutOff(2);
  const auto before = noted();
  takePart();
  EXPECT_EQ(noted(), before);
  EXPECT_NE(problems().find("the trail is not the one"), std::string::npos);
}

TEST_F(Evidence, OfAnotherBeginningIsAcceptedWithAReasonOnly) {
  writeAgain();
  EXPECT_GT(headsMissingIn(*study_), 0U);
  EXPECT_EQ(recordRestoredCopy(*study_, "put together at the office"), 2U);
  EXPECT_EQ(noted(), "made_study finished_session restored_copy");
  takePart();
  EXPECT_EQ(noted(), "made_study finished_session restored_copy finished_session");
  EXPECT_EQ(problems().find("this station signed"), std::string::npos);
  EXPECT_NE(remarks().find("2 noted heads were given up"), std::string::npos);
}

TEST_F(Evidence, SaysForEverThatAStudyBeganElsewhere) {
  const tests::OwnStation elsewhere(study_.scratch() / "elsewhere");
  StationStore::openOrCreate(StationStore::defaultFolder());
  takePart();
  takePart();
  EXPECT_EQ(problems(), "");
  EXPECT_NE(remarks().find("did not note how the study began"), std::string::npos);
}

TEST_F(Evidence, IsNotDisturbedByAStudyThatIsMadeAgain) {
  // The same seed and protocol give the same uuid, another moment another first event.
  SimulatedClock later(1'700'000'000'000);
  const auto protocol = tests::protocolFrom(tests::shortProtocol());
  auto again = Study::create(study_.scratch() / "again", protocol, later, 1, tests::knownSecret());
  ASSERT_EQ(again.uuid(), study_->uuid());
  EXPECT_TRUE(verify(again).isSound());
  EXPECT_EQ(problems(), "");
}

TEST_F(Evidence, TakesABackupForWhatItIs) {
  const auto copy = study_.scratch() / "copy";
  ASSERT_TRUE(backUp(study_.folder(), copy).verification.isSound());
  takePart();
  auto opened = Study::open(copy, study_.clock, storage::Database::Access::ReadOnly);
  EXPECT_FALSE(verify(opened).isSound());
  EXPECT_TRUE(verify(opened, {}, {.isOlderCopy = true}).isSound());
  EXPECT_EQ(problems({.isOlderCopy = true}), "");
}

TEST_F(Evidence, IsNoOlderCopyIfTheTrailIsAnother) {
  const auto copy = study_.scratch() / "copy";
  backUp(study_.folder(), copy);
  takePart();
  auto opened = Study::open(copy, study_.clock);
  {
    const tests::OwnStation elsewhere(study_.scratch() / "elsewhere");
    takePartIn(opened);
    takePartIn(opened);
  }
  EXPECT_FALSE(verify(opened, {}, {.isOlderCopy = true}).isSound());
}

TEST_F(Evidence, GoesOnFromAnOlderCopyThatWasPutBack) {
  const auto copy = study_.scratch() / "copy";
  backUp(study_.folder(), copy);
  takePart();
  takePart();
  study_.close();
  fs::remove_all(study_.folder());
  fs::rename(copy, study_.folder());
  study_.reopen();
  EXPECT_NE(problems().find("palpate study restored"), std::string::npos);
  EXPECT_EQ(recordRestoredCopy(*study_, "the disk failed"), 2U);
  EXPECT_EQ(problems(), "");
  EXPECT_NE(remarks().find("2 noted heads were given up"), std::string::npos);
  EXPECT_EQ(recordRestoredCopy(*study_, "again"), 0U);
  takePart();
  EXPECT_EQ(problems(), "");
  cutOff(1);
  EXPECT_NE(problems(), "");
}

TEST_F(Evidence, IsNotNeededForASessionToEnd) {
  const tests::OwnStation unusable("/proc/no/such/folder");
  takePart();
  const auto events = study_->events().read();
  EXPECT_EQ(events.back().name(), "head_not_signed");
  EXPECT_TRUE(study_->sessions().all().back().state == SessionState::Completed);
}

TEST_F(Evidence, FindsWhatWasDoneToTheSchema) {
  EXPECT_EQ(problems(), "");
  edit("DROP TRIGGER an_event_is_never_removed");
  EXPECT_NE(
      problems().find("study.db: the trigger an_event_is_never_removed is gone"),
      std::string::npos);
  edit("DROP INDEX events_of_a_session");
  EXPECT_NE(problems().find("the index events_of_a_session is gone"), std::string::npos);
  edit("CREATE TABLE more (a)", "traces.db");
  EXPECT_NE(problems().find("traces.db: the table more was added"), std::string::npos);
  edit(
      "DROP TRIGGER an_event_is_never_changed; CREATE TRIGGER an_event_is_never_changed "
      "BEFORE UPDATE ON event BEGIN SELECT 1; END");
  EXPECT_NE(
      problems().find("the trigger an_event_is_never_changed was changed"), std::string::npos);
  edit("DROP TRIGGER a_secret_is_never_removed", "identity.db");
  EXPECT_NE(problems().find("identity.db: the trigger a_secret_is_never"), std::string::npos);
}

}  // namespace evidence_test
}  // namespace study

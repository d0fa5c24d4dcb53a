#include "study/storage/evidence/trail_heads.h"

#include <gtest/gtest.h>

#include "study/storage/evidence/head_check.h"
#include "tests/study/made_study.h"
#include "tests/study/storage/sql.h"

namespace study::storage {
namespace trail_heads_test {

class TrailHeadsTest : public testing::Test {
 protected:
  TrailHeadsTest() { study_->note(EventKind::Note, "before"); }

  void edit(const std::string& sql) {
    study_.close();
    tests::Sql(study_.file("study.db")).run(sql);
    study_.reopen();
  }

  /// All events one place further, behind a first one that says so.
  void resealEvents() {
    edit(
        "DROP TRIGGER an_event_is_never_changed; DROP TRIGGER an_event_is_added_at_the_end;"
        "UPDATE event SET seq = -seq; UPDATE event SET seq = 1 - seq, hash = randomblob(32);"
        "INSERT INTO event (seq, utc, monotonic_ns, actor, kind, detail, hash) VALUES (1, '', 0, "
        "'operator', 'resealed_trail', '{\"events\":3}', randomblob(32))");
  }

  void signFor(EventKind purpose) {
    study_->transact([&] { study_->signTrail(study::nameOf(purpose)); });
  }

  static std::string keyHere() {
    return StationStore::find(StationStore::defaultFolder())->publicKey();
  }

  tests::MadeStudy study_;
};

TEST_F(TrailHeadsTest, HasEachSignedHead) {
  const TrailHeads trail(study_->database());
  ASSERT_EQ(trail.all().size(), 1U);
  EXPECT_EQ(trail.all()[0].seq, 3);
  EXPECT_TRUE(trail.all()[0].isSound);
  EXPECT_TRUE(trail.holds(trail.all()[0].head));
  EXPECT_FALSE(trail.isAbandoned(trail.all()[0].head));
  EXPECT_TRUE(trail.checkSignatures(keyHere()).remarks.empty());
}

TEST_F(TrailHeadsTest, OfATrailThatWasSealedAgainAreOfAnother) {
  const auto before = TrailHeads(study_->database()).all().at(0).head;
  resealEvents();
  {
    const TrailHeads trail(study_->database());
    EXPECT_TRUE(trail.all().empty());
    EXPECT_FALSE(trail.belongsToPreviousTrail(before)) << "no one signed that it was sealed again";
    EXPECT_FALSE(checkHeads(trail, {{before, "/"}}).problems.empty());
  }
  signFor(EventKind::ResealedTrail);
  const TrailHeads trail(study_->database());
  const auto found = trail.checkSignatures(keyHere());
  EXPECT_TRUE(found.problems.empty());
  EXPECT_EQ(found.remarks.size(), 1U);
  EXPECT_TRUE(trail.belongsToPreviousTrail(before));
  EXPECT_TRUE(checkHeads(trail, {{before, "/"}}).problems.empty());
  const auto station = StationStore::find(StationStore::defaultFolder());
  const auto listed = readRecordedHeads(*station, study_->uuid());
  EXPECT_TRUE(checkStation(trail, *station, listed, false).problems.empty());
}

TEST_F(TrailHeadsTest, ThatWereNotedAfterTheTrailWasReadAreNotMissed) {
  const auto station = *StationStore::find(StationStore::defaultFolder());
  const auto before = readRecordedHeads(station, study_->uuid());
  const TrailHeads trail(study_->database());
  signFor(EventKind::UnblindedResults);
  EXPECT_TRUE(checkStation(trail, station, before, false).problems.empty());
  EXPECT_TRUE(missingHeads(trail, before).empty());
  // control: a list that was read afterwards has a head that the trail lacks
  const auto after = readRecordedHeads(station, study_->uuid());
  EXPECT_FALSE(checkStation(trail, station, after, false).problems.empty());
  EXPECT_EQ(missingHeads(trail, after).size(), 1U);
}

TEST_F(TrailHeadsTest, OfAnotherStationAreNotOfTheTrailBefore) {
  const auto before = TrailHeads(study_->database()).all().at(0).head;
  resealEvents();
  const tests::OwnStation elsewhere(study_.scratch() / "elsewhere");
  signFor(EventKind::ResealedTrail);
  EXPECT_FALSE(TrailHeads(study_->database()).belongsToPreviousTrail(before));
}

TEST_F(TrailHeadsTest, AreNotOfTheTrailBeforeBecauseTheStationSignedSomethingElse) {
  const auto before = TrailHeads(study_->database()).all().at(0).head;
  resealEvents();
  tests::forgetWhatWasSigned();  // so that this station signs it at all
  signFor(EventKind::Exported);
  const TrailHeads trail(study_->database());
  ASSERT_EQ(trail.all().size(), 1U);
  EXPECT_FALSE(trail.belongsToPreviousTrail(before));
  EXPECT_FALSE(checkHeads(trail, {{before, "/"}}).problems.empty());
}

TEST_F(TrailHeadsTest, AreNotGivenUpByAnEventThatAnotherPurposeSigned) {
  const auto head = TrailHeads(study_->database()).all().at(0).head;
  const auto giveUp = [&](EventKind purpose) {
    study_->transact([&] {
      study_->events().append(
          {.kind = EventKind::RestoredCopy, .values = {{"given_up", nameOf(head)}}});
      study_->signTrail(study::nameOf(purpose));
    });
    return TrailHeads(study_->database()).isAbandoned(head);
  };
  EXPECT_FALSE(giveUp(EventKind::Exported));
  EXPECT_TRUE(giveUp(EventKind::RestoredCopy));
}

}  // namespace trail_heads_test
}  // namespace study::storage

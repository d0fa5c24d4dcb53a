#include "study/session/verification.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include <gtest/gtest.h>

#include "study/cohort/simulated_participant.h"
#include "study/export/export.h"
#include "study/model/user_error.h"
#include "study/session/backup.h"
#include "tests/study/made_study.h"
#include "tests/study/storage/sql.h"
#include "tests/study/walk.h"

namespace study {
namespace verification_test {

std::string problemsIn(const Verification& verification) {
  std::string text;
  for (const auto& check : verification.checks) {
    for (const auto& problem : check.problems) text += check.what + ": " + problem + "\n";
  }
  return text;
}

/// The control of the test below: files that are not read in the state of one moment are found to
/// disagree, as soon as one person takes part between them.
TEST(Verification, FindsThatFilesAreOfTwoMoments) {
  tests::MadeStudy study;
  const std::string early = study.scratch() / "early";
  const std::string late = study.scratch() / "late";
  const auto verified = [&] {
    auto copy = Study::open(early, storage::Database::Access::ReadOnly);
    return problemsIn(verify(copy, {}, {.isOlderCopy = true}));
  };
  backUp(study.folder(), early);
  simulateCohorts(*study, study.clock, 1, 1, [](const auto&) {});
  backUp(study.folder(), late);
  EXPECT_EQ(verified(), "");
  const auto replace = std::filesystem::copy_options::overwrite_existing;
  std::filesystem::copy_file(late + "/traces.db", early + "/traces.db", replace);
  EXPECT_NE(verified(), "");
}

/// Simulated participants take part from the first check to the last, and the trail is signed.
TEST(Verification, IsSoundWhileOthersTakePart) {
  constexpr int kMost = 8;
  tests::MadeStudy study;
  SimulatedClock clock;
  auto station = Study::open(study.folder(), clock);
  int people = 0;
  const auto takePart = [&](double, const std::string&) {
    if (people >= kMost) return;
    simulateCohorts(station, clock, ++people, 1, [](const auto&) {});
    station.note(EventKind::UnblindedResults, "a reason");
  };
  takePart(0.0, {});
  const auto verified = verify(*study, takePart);
  EXPECT_EQ(problemsIn(verified), "");
  for (const auto& check : verified.checks) {
    for (const auto& remark : check.remarks) {
      EXPECT_EQ(remark.find("not in its own list"), std::string::npos) << remark;
    }
  }
  EXPECT_EQ(people, kMost);
  EXPECT_NE(study->events().headAsText(), verified.head);
  EXPECT_EQ(problemsIn(verify(*study)), "");
  // Nothing of it is left open: the study can be written.
  EXPECT_NO_THROW(Session::enrol(*study, {.cohort = "surgeons"}));
}

TEST(Verification, RemarksThatOthersMayReadTheStudyAndWhatToDo) {
  namespace fs = std::filesystem;
  tests::MadeStudy study;
  EXPECT_TRUE(verify(*study).checks.front().remarks.empty());
  for (const auto right : {fs::perms::others_exec, fs::perms::group_read}) {
    fs::permissions(study.folder(), fs::perms::owner_all | right);
    const auto verification = verify(*study);
    EXPECT_TRUE(verification.isSound());
    ASSERT_EQ(verification.checks.front().remarks.size(), 1U);
    EXPECT_TRUE(verification.checks.front().remarks.front().ends_with(
        "chmod -R go-rwx '" + study.folder() + "'"));
  }
}

TEST(Verification, DoesNotAdviseToCloseAFolderToTheGroupThatItIsSharedWith) {
  namespace fs = std::filesystem;
  tests::MadeStudy study;
  const auto shared = fs::perms::owner_all | fs::perms::group_all | fs::perms::set_gid;
  fs::permissions(study.folder(), shared);
  EXPECT_EQ(describeOtherAccess(study.folder()), "");
  fs::permissions(study.folder(), shared | fs::perms::others_read);
  EXPECT_TRUE(
      describeOtherAccess(study.folder()).ends_with("chmod -R o-rwx '" + study.folder() + "'"));
  // A folder has the bit from the one that it was made in, too: then its group may not write.
  fs::permissions(
      study.folder(), fs::perms::owner_all | fs::perms::group_read | fs::perms::set_gid);
  EXPECT_NE(describeOtherAccess(study.folder()), "");
}

/// A study with two people, and the head of its audit trail that was noted after the first.
class NotedTrail : public testing::Test {
 protected:
  NotedTrail() {
    takePart();
    noted_ = study_->events().headAsText();
    takePart();
  }

  void takePart() {
    auto session = Session::enrol(*study_, {.cohort = "surgeons"});
    tests::walkToTheEnd(session);
  }

  /// Removes the last events, as anyone can who may write the file.
  void cutOff(int events) {
    study_.close();
    tests::Sql sql(study_.file("study.db"));
    sql.run(
        "DROP TRIGGER an_event_is_never_removed; DELETE FROM event WHERE seq > "
        "(SELECT max(seq) FROM event) - " +
        std::to_string(events) +
        "; CREATE TRIGGER an_event_is_never_removed BEFORE DELETE ON event\n"
        "      BEGIN SELECT RAISE(ABORT, 'events are never removed'); END;");
    study_.reopen();
  }

  /// As on another computer, where nothing but @p noted is known of the study.
  bool isSound(const std::string& noted = {}) {
    const tests::OwnStation elsewhere(study_.scratch() / "elsewhere");
    return verify(*study_, {}, {.notedHead = noted}).isSound();
  }

  tests::MadeStudy study_;
  std::string noted_;
};

TEST_F(NotedTrail, IsGoneOnFrom) {
  const auto last = study_->events().headAsText();
  EXPECT_NE(noted_, last);
  EXPECT_TRUE(isSound(noted_));
  EXPECT_TRUE(isSound(last));
  EXPECT_EQ(verify(*study_).head, last);
  // As a person may write it down.
  const auto groups = noted_.substr(noted_.find(',') + 2);
  EXPECT_EQ(groups.size(), 39U);
  EXPECT_TRUE(isSound(groups));
  std::string shouted = groups;
  std::transform(shouted.begin(), shouted.end(), shouted.begin(), ::toupper);
  EXPECT_TRUE(isSound(shouted));
}

TEST_F(NotedTrail, ShowsThatItsEndWasCutOff) {
  study_->note(EventKind::UnblindedExport, "a reason");
  const auto last = study_->events().headAsText();
  cutOff(2);  // with its signature
  EXPECT_TRUE(isSound()) << "nothing inside the folder says so";
  EXPECT_FALSE(isSound(last));
  EXPECT_TRUE(isSound(noted_)) << "what was noted before is still there";
}

TEST_F(NotedTrail, ShowsThatOtherEventsCameInPlaceOfThoseThatWereCutOff) {
  study_->note(EventKind::UnblindedExport, "a reason");
  const auto last = study_->events().headAsText();
  cutOff(2);
  study_->note(EventKind::PublicExport, "harmless");
  EXPECT_TRUE(isSound());
  EXPECT_FALSE(isSound(last));
}

TEST_F(NotedTrail, IsNoHeadIfItHasOtherThanEightGroups) {
  for (const std::string wrong : {"1a2b", "812 events", "812 events, ", "xxxx", "812"}) {
    EXPECT_THROW(isSound(wrong), UserError) << wrong;
  }
  EXPECT_THROW(isSound(noted_ + " 1a2b"), UserError);
  std::string letter = noted_;
  letter.back() = 'g';
  EXPECT_THROW(isSound(letter), UserError);
}

TEST_F(NotedTrail, StandsInEveryFolderOfLiveSessions) {
  std::string head;
  const auto readme = [&](const std::string& name, RunMode mode) {
    const auto folder = study_.scratch() / name;
    exportStudy(*study_, folder, {.runMode = mode});
    head = study_->events().headAsText();  // with the export itself
    return tests::contentOf(folder + "/README.md") + tests::contentOf(folder + "/codebook.json");
  };
  const auto live = readme("live", RunMode::Live);
  EXPECT_NE(live.find("\"audit_trail\": \"" + head), std::string::npos);
  const auto pilot = readme("pilot", RunMode::Pilot);
  EXPECT_NE(pilot.find("audit trail had " + head), std::string::npos);
  const auto simulated = readme("simulated", RunMode::Simulated);
  EXPECT_EQ(simulated.find(head), std::string::npos);
  EXPECT_NE(live.find(study_->uuid()), std::string::npos);
  EXPECT_EQ(simulated.find(study_->uuid()), std::string::npos) << "it is a hash of the seed";
}

}  // namespace verification_test
}  // namespace study

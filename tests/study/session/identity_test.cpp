// Answers that name a person are stored in identity.db only.
#include <filesystem>

#include <gtest/gtest.h>

#include "study/export/export.h"
#include "study/export/named_people.h"
#include "study/session/backup.h"
#include "study/session/erasure.h"
#include "study/session/identity_evidence.h"
#include "study/session/study_key.h"
#include "study/session/verification.h"
#include "study/storage/map/study_keys.h"
#include "tests/study/everything_instrument.h"
#include "tests/study/made_study.h"
#include "tests/study/session/erased_study.h"
#include "tests/study/storage/sql.h"
#include "tests/study/walk.h"

namespace study {
namespace identity_test {

const std::string kName = "Zaphod Beeblebrox-Sentinel";

using tests::filesWith;

class IdentityTest : public testing::Test {
 protected:
  void SetUp() override {
    tests::walkTo(session_, StepKind::Form);
    session_.record({.item = "agree", .response = std::int64_t{1}, .itemOrder = 1});
    session_.record({.item = "name", .response = kName, .itemOrder = 2});
  }

  tests::MadeStudy study_{tests::protocolFrom(
      tests::protocolWithEverything(), {{"everything.json", tests::everythingInstrument()}})};
  Session session_ = Session::enrol(*study_, {.cohort = "surgeons"});
};

TEST_F(IdentityTest, IsStoredInItsOwnDatabaseAndSealed) {
  EXPECT_TRUE(session_.missing().empty());
  const auto names = study_->identities().names("P001");
  ASSERT_EQ(names.size(), 1U);
  EXPECT_EQ(names[0].item, "name");
  EXPECT_EQ(names[0].text, kName);
  EXPECT_TRUE(study_->identities().names("P002").empty());
  { const Session gone = std::move(session_); }
  study_.close();  // moves the content of the write-ahead log into the database
  EXPECT_TRUE(filesWith(study_.folder(), kName).empty());
}

TEST_F(IdentityTest, IsStoredInTheOpenWhereThereIsNoKey) {
  // The control of the test above, and what older releases wrote.
  study_->identities().put({"P009", 1, 0, 1}, "name", kName, "now");
  { const Session gone = std::move(session_); }
  study_.close();
  EXPECT_EQ(filesWith(study_.folder(), kName), std::vector<std::string>{"identity.db"});
}

TEST_F(IdentityTest, IsNeitherInTheAnswersNorInAnExport) {
  session_.finishStep();
  tests::walkToTheEnd(session_);
  EXPECT_TRUE(session_.answers().empty());
  for (const auto format : {ExportFormat::Csv, ExportFormat::Json}) {
    const std::string out = study_.file(format == ExportFormat::Csv ? "csv" : "json");
    exportStudy(*study_, out, {.format = format, .isBlinded = false}, "a test");
    EXPECT_TRUE(filesWith(out, kName).empty());
    // the audit trail still has the event without the answer
    EXPECT_FALSE(filesWith(out, "name").empty());
  }
}

TEST_F(IdentityTest, CountsAsAnsweredAfterARestart) {
  const auto id = session_.id();
  { const Session gone = std::move(session_); }
  study_.reopen();
  EXPECT_TRUE(Session::resume(*study_, id).missing().empty());
}

TEST_F(IdentityTest, IsDeletedWhenItIsRetracted) {
  session_.retract("name");
  EXPECT_EQ(session_.missing(), std::vector<std::string>{"name"});
  { const Session gone = std::move(session_); }
  study_.close();
  study_.reopen();
  EXPECT_TRUE(study_->identities().names().empty());
}

TEST_F(IdentityTest, IsReadableByItsOwnerOnly) {
  const auto permissions = std::filesystem::status(study_.file("identity.db")).permissions();
  EXPECT_EQ(
      permissions & std::filesystem::perms::all,
      std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
}

/// Names behind a passphrase, and the study opened by a program that began later.
class SealedNames : public IdentityTest {
 protected:
  void SetUp() override {
    IdentityTest::SetUp();
    key_ = study_->identities().key(storage::IdentityStore::Key::Identity, "P001")->bytes();
    seal("an older passphrase");
    seal(kPassphrase);
    session_.finishStep();
    { const Session gone = std::move(session_); }
    beginAgain();
  }

  void seal(const std::string& passphrase) {
    setPassphraseOfNames(
        *study_, passphrase, "when the study was made", storage::PassphraseCost::least());
  }

  void beginAgain() {
    storage::clearCachedKeys();
    study_.reopen();
  }

  std::string keyAsText() const { return {key_.begin(), key_.end()}; }

  static constexpr const char* kPassphrase = "twelve grey horses";
  storage::SealingKey::Bytes key_{};
};

TEST_F(SealedNames, AreReadWithTheirPassphraseAlone) {
  EXPECT_TRUE(study_->identities().isLocked());
  EXPECT_THROW(study_->identities().names(), storage::StorageError);
  EXPECT_FALSE(study_->unlockNames("an older passphrase"));
  EXPECT_TRUE(study_->identities().isLocked());
  EXPECT_TRUE(study_->unlockNames(kPassphrase));
  ASSERT_EQ(study_->identities().names().size(), 1U);
  EXPECT_EQ(study_->identities().names()[0].text, kName);
  study_.reopen();
  EXPECT_FALSE(study_->identities().isLocked()) << "the program holds it until it ends";
}

TEST_F(SealedNames, LeaveNoKeyInTheFolder) {
  study_.close();
  EXPECT_TRUE(filesWith(study_.folder(), keyAsText()).empty());
  // The control: without a passphrase the key lies beside what it opens.
  study_.reopen();
  ASSERT_TRUE(study_->unlockNames(kPassphrase));
  study_.close();
  tests::Sql(study_.file("identity.db")).run("DELETE FROM wrapped_key");
  storage::clearCachedKeys();
  study_.reopen();
  study_->identities().drawKeys("P009");
  const auto open =
      study_->identities().key(storage::IdentityStore::Key::Identity, "P009")->bytes();
  study_.close();
  EXPECT_EQ(
      filesWith(study_.folder(), {open.begin(), open.end()}),
      std::vector<std::string>{"identity.db"});
}

TEST_F(IdentityTest, SealsOpenNamesWithTheirFingerprints) {
  // As a study that has the secret of fingerprints, and names in the open.
  const auto id = session_.id();
  const auto visit = session_.visit();
  session_.finishStep();
  { const Session gone = std::move(session_); }
  study_->identities().database().execute("DELETE FROM participant_key");
  study_->identities().put({"P001", 1, visit.step, visit.attempt}, "name", kName, "now");
  const auto said = fingerprintsOf(*study_, "P001");
  study_->note({.kind = EventKind::NotedIdentities, .values = {{"rows", said}}});
  setPassphraseOfNames(
      *study_, "twelve grey horses", "asked for", storage::PassphraseCost::least());
  EXPECT_NE(fingerprintsOf(*study_, "P001"), said);
  EXPECT_TRUE(checkIdentities(*study_).problems.empty());
  EXPECT_NO_THROW(Session::resume(*study_, id));
}

TEST_F(IdentityTest, NotesWhatAnInterruptedSealingLeftAndNothingElse) {
  const auto visit = session_.visit();
  session_.finishStep();
  { const Session gone = std::move(session_); }
  auto& identities = study_->identities();
  identities.database().execute("DELETE FROM participant_key");
  for (const char* item : {"name", "place"}) {
    identities.put({"P001", 1, visit.step, visit.attempt}, item, kName, "now");
  }
  study_->note(
      {.kind = EventKind::NotedIdentities, .values = {{"rows", fingerprintsOf(*study_, "P001")}}});
  // A program that ends between the commit of the sealed names and the event with their
  // fingerprints. One name was changed by another program since.
  identities.drawMissingKey(storage::IdentityStore::Key::Identity, "P001");
  identities.sealUnsealedNames();
  identities.put({"P001", 1, visit.step, visit.attempt}, "place", "Betelgeuse", "now");
  EXPECT_EQ(checkIdentities(*study_).problems.size(), 2U) << "control";
  setPassphraseOfNames(
      *study_, "twelve grey horses", "asked for", storage::PassphraseCost::least());
  const auto problems = checkIdentities(*study_).problems;
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_NE(problems[0].find("place is not what the audit trail says"), std::string::npos)
      << problems[0];
}

TEST_F(SealedNames, LetNoSessionBeginWithoutThePassphrase) {
  EXPECT_THROW(Session::enrol(*study_, {.cohort = "surgeons"}), storage::StorageError);
  EXPECT_EQ(study_->sessions().all().size(), 1U);
  ASSERT_TRUE(study_->unlockNames(kPassphrase));
  auto session = Session::enrol(*study_, {.cohort = "surgeons"});
  tests::walkTo(session, StepKind::Form);
  session.record({.item = "agree", .response = std::int64_t{1}, .itemOrder = 1});
  session.record({.item = "name", .response = std::string("Trillian"), .itemOrder = 2});
  EXPECT_EQ(study_->identities().names("P002").size(), 1U);
  EXPECT_TRUE(verify(*study_).isSound());
}

TEST_F(SealedNames, AreVerifiedBackedUpAndErasedWithoutIt) {
  EXPECT_TRUE(verify(*study_).isSound());
  EXPECT_TRUE(backUp(study_.folder(), study_.scratch() / "copy").verification.isSound());
  EXPECT_TRUE(searchForNames(*study_, {}).areLocked);
  const auto report =
      erase(*study_, {.participant = "P001", .reason = "asked for it by telephone"});
  EXPECT_EQ(report.names, 1U);
  EXPECT_TRUE(report.areNamesLocked);
  EXPECT_TRUE(verify(*study_).isSound());
  ASSERT_TRUE(study_->unlockNames(kPassphrase));
  EXPECT_TRUE(study_->identities().names().empty());
}

}  // namespace identity_test
}  // namespace study

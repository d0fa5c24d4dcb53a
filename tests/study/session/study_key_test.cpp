#include "study/session/study_key.h"

#include <sys/stat.h>

#include <filesystem>

#include <gtest/gtest.h>

#include "study/export/export.h"
#include "study/model/user_error.h"
#include "study/results/results.h"
#include "study/session/backup.h"
#include "study/session/unfinished_sessions.h"
#include "study/session/verification.h"
#include "study/storage/records.h"
#include "tests/study/made_study.h"
#include "tests/study/storage/refusals.h"
#include "tests/study/storage/sql.h"
#include "tests/study/walk.h"
#include "tests/support/test_data.h"

namespace study {
namespace study_key_test {

namespace fs = std::filesystem;

const std::string kReason = "for the second room";

/// A study with a participant, and its folder as another station sees it.
class SealedStudy : public testing::Test {
 protected:
  SealedStudy() {
    auto session = Session::enrol(*study_, {.cohort = "surgeons"});
    tests::walkToTheEnd(session);
  }

  Study opened() { return Study::open(study_.folder(), study_.clock); }

  tests::MadeStudy study_;
};

TEST_F(SealedStudy, HasConditionsThatOnlyTheKeyOpens) {
  EXPECT_TRUE(study_->isSealed());
  EXPECT_TRUE(study_->hasKey());
  tests::Sql sql(study_.file("study.db"));
  EXPECT_EQ(sql.number("SELECT count(*) FROM allocation WHERE condition <> ''"), 0);
  EXPECT_GT(sql.number("SELECT count(*) FROM allocation WHERE sealed IS NOT NULL"), 5);
  EXPECT_EQ(sql.number("SELECT count(DISTINCT length(sealed)) FROM allocation"), 1);
  for (const auto& [step, condition] : study_->sessions().allocation(SessionId{1})) {
    EXPECT_NE(study_->protocol().protocol.condition(condition), nullptr) << condition;
  }
}

TEST_F(SealedStudy, LeavesSimulatedSessionsOpen) {
  auto session = Session::enrol(*study_, {.cohort = "surgeons", .runMode = RunMode::Simulated});
  tests::walkToTheEnd(session);
  EXPECT_FALSE(study_->sessions().isSealed(session.id()));
  EXPECT_TRUE(study_->sessions().isSealed(SessionId{1}));
  EXPECT_TRUE(verify(*study_).isSound());
}

TEST_F(SealedStudy, TellsNothingOnAnotherStationAndSaysWhatToDo) {
  const auto id = [&] {
    auto unfinished = Session::enrol(*study_, {.cohort = "surgeons"});
    tests::walkTo(unfinished, StepKind::Trial);
    return unfinished.id();
  }();
  study_.close();
  const tests::OwnStation elsewhere(study_.scratch() / "elsewhere");
  auto study = opened();
  EXPECT_FALSE(study.hasKey());
  const auto refusal = [&](const std::function<void()>& action) {
    const auto refused = tests::refusalOf(action);
    tests::expectClear(refused, "palpate study key export");
    tests::expectClear(refused, "palpate study key import");
  };
  refusal([&] { Session::enrol(study, {.cohort = "surgeons"}); });
  refusal([&] { Session::resume(study, id); });
  refusal([&] { computeResults(study, RunMode::Live); });
  for (const bool isBlinded : {true, false}) {
    const auto out = study_.scratch() / "out";
    refusal([&] {
      exportStudy(study, out, {.runMode = RunMode::Live, .isBlinded = isBlinded}, kReason);
    });
    EXPECT_FALSE(fs::exists(out));
  }
  // What does not need it goes on.
  EXPECT_EQ(unfinishedSessions(study).size(), 1U);
  const auto verification = verify(study);
  EXPECT_TRUE(verification.isSound());
  std::string remarks;
  for (const auto& check : verification.checks) {
    for (const auto& remark : check.remarks) remarks += remark;
  }
  EXPECT_NE(remarks.find("has not the key"), std::string::npos);
  EXPECT_TRUE(backUp(study_.folder(), study_.scratch() / "copy").verification.isSound());
}

TEST_F(SealedStudy, GoesOnWhereTheKeyWasHandedOver) {
  const auto file = study_.scratch() / "key.txt";
  EXPECT_THROW(exportKey(*study_, file, ""), UserError);
  exportKey(*study_, file, kReason);
  struct stat facts {};
  ASSERT_EQ(stat(file.c_str(), &facts), 0);
  EXPECT_EQ(facts.st_mode & 0777U, 0600U);
  EXPECT_EQ(study_->events().read().rbegin()[1].kind, EventKind::ExportedKey);
  study_.close();
  const tests::OwnStation elsewhere(study_.scratch() / "elsewhere");
  {
    auto study = opened();
    importKey(study, file);
    EXPECT_EQ(study.events().read().rbegin()[1].kind, EventKind::ImportedKey);
  }
  auto study = opened();
  auto session = Session::enrol(study, {.cohort = "surgeons"});
  tests::walkToTheEnd(session);
  EXPECT_TRUE(verify(study).isSound());
  EXPECT_NO_THROW(exportStudy(
      study,
      study_.scratch() / "out",
      {.runMode = RunMode::Live, .isBlinded = false},
      "the end of the study"));
}

TEST_F(SealedStudy, RefusesTheKeyOfAnotherStudy) {
  tests::MadeStudy other(
      tests::protocolFrom(tests::shortProtocol()), 1, storage::BlindingSecret::drawn());
  const auto file = study_.scratch() / "key.txt";
  exportKey(*other, file, kReason);
  EXPECT_THROW(importKey(*study_, file), UserError);
  EXPECT_THROW(importKey(*study_, study_.scratch() / "none.txt"), UserError);
}

TEST_F(SealedStudy, IsOpenedByItsPassphrase) {
  EXPECT_THROW(setPassphrase(*study_, "too short", kReason), UserError);
  const std::string words = "twelve grey horses";
  setPassphrase(*study_, "an older passphrase", kReason, storage::PassphraseCost::least());
  setPassphrase(*study_, words, kReason, storage::PassphraseCost::least());
  EXPECT_TRUE(verify(*study_).isSound());
  study_.close();
  const tests::OwnStation elsewhere(study_.scratch() / "elsewhere");
  {
    auto study = opened();
    EXPECT_TRUE(study.hasPassphrase());
    EXPECT_FALSE(study.unlock("an older passphrase"));
    EXPECT_FALSE(study.hasKey());
    EXPECT_TRUE(study.unlock(words));
    auto session = Session::enrol(study, {.cohort = "surgeons"});
    tests::walkToTheEnd(session);
  }
  // This program holds it from now on; nothing is on the disk.
  EXPECT_TRUE(opened().hasKey());
  EXPECT_FALSE(fs::exists(study_.scratch() / "elsewhere/study-keys"));
  storage::dropKey(opened().events().commitment());
  EXPECT_FALSE(opened().hasKey());
}

TEST_F(SealedStudy, DoesNotLoseItsOnlyKey) {
  EXPECT_THROW(dropKey(*study_, kReason), UserError);
  const auto file = study_.scratch() / "key.txt";
  exportKey(*study_, file, kReason);
  dropKey(*study_, kReason);
  study_.reopen();
  EXPECT_FALSE(study_->hasKey());
  importKey(*study_, file);
  EXPECT_TRUE(study_->hasKey());
}

TEST_F(SealedStudy, NoticesAConditionThatWasChangedOrMoved) {
  const auto changed = [&](const std::string& sql) {
    study_.close();
    tests::Sql(study_.file("study.db")).run(sql);
    study_.reopen();
    EXPECT_FALSE(verify(*study_).isSound()) << sql;
    EXPECT_THROW(study_->sessions().allocation(SessionId{1}), storage::StorageError) << sql;
  };
  changed(
      "UPDATE allocation SET sealed = (SELECT b.sealed FROM allocation AS b WHERE b.step > "
      "allocation.step ORDER BY b.step LIMIT 1) WHERE step = (SELECT min(step) FROM allocation)");
}

TEST_F(SealedStudy, NoticesASimulatedSessionThatIsCalledLive) {
  auto session = Session::enrol(*study_, {.cohort = "surgeons", .runMode = RunMode::Simulated});
  tests::walkToTheEnd(session);
  study_.close();
  tests::Sql(study_.file("study.db"))
      .run("UPDATE session SET run_mode = 'live', slot = 7 WHERE run_mode = 'simulated'");
  const tests::OwnStation elsewhere(study_.scratch() / "elsewhere");
  auto study = opened();
  std::string problems;
  for (const auto& check : verify(study).checks) {
    for (const auto& problem : check.problems) problems += problem + "\n";
  }
  EXPECT_NE(problems.find("is not sealed"), std::string::npos) << problems;
}

TEST(WrappedKey, OpensWithItsPassphraseAlone) {
  const storage::SealingKey::Bytes key{1, 2, 3};
  auto wrapped =
      storage::WrappedKey::make(key, "twelve grey horses", storage::PassphraseCost::least());
  EXPECT_EQ(wrapped.opened("twelve grey horses"), key);
  EXPECT_FALSE(wrapped.opened("twelve grey horse"));
  EXPECT_FALSE(wrapped.opened(""));
  auto changed = wrapped;
  changed.sealed.back() ^= std::byte{1};
  EXPECT_FALSE(changed.opened("twelve grey horses"));
  // A file from elsewhere must not take all memory.
  wrapped.cost.memory = std::uint64_t{1} << 40U;
  EXPECT_THROW(static_cast<void>(wrapped.opened("twelve grey horses")), storage::StorageError);
}

}  // namespace study_key_test
}  // namespace study

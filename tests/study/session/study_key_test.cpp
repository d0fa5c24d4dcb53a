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
  for (const auto& [step, condition] : storage::allocationOf(study_->database(), SessionId{1})) {
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
  EXPECT_NE(remarks.find("does not have the key"), std::string::npos);
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
    EXPECT_THROW(storage::allocationOf(study_->database(), SessionId{1}), storage::StorageError)
        << sql;
  };
  changed(
      "UPDATE allocation SET sealed = (SELECT b.sealed FROM allocation AS b WHERE b.step > "
      "allocation.step ORDER BY b.step LIMIT 1) WHERE step = (SELECT min(step) FROM allocation)");
}

TEST_F(SealedStudy, NoticesASimulatedSessionThatIsCalledLive) {
  {
    auto session = Session::enrol(*study_, {.cohort = "surgeons", .runMode = RunMode::Simulated});
    tests::walkToTheEnd(session);
  }
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

/// A trial in which everything was measured.
TrialRecord measuredTrial() {
  auto record = tests::feltTrial(2);
  record.duration = 4.125;
  record.ticks = 4125;
  record.achievedRate = 999.75;
  record.latenessMedian = 12.0;
  record.latenessP99 = 55.5;
  record.latenessLargest = 801.0;
  record.lateTicks = 3;
  record.lostSamples = 1;
  record.saturated = 0.5;
  record.slewed = 1.0 / 3.0;
  record.contact = 2.0;
  record.largestForce = 6.02;
  record.traceSamples = 500;
  auto& cut = record.cuts.back();
  cut.interception = {.travel = 4.0, .force = 0.125, .found = true};
  cut.yield = {.travel = 9.5, .force = 5.75, .found = true};
  cut.peakForce = 6.02;
  return record;
}

void feel(Study& study) {
  auto session = Session::enrol(study, {.cohort = "surgeons"});
  tests::walkTo(session, StepKind::Trial);
  session.beginTrial();
  const std::vector<storage::TraceSample> samples(500, {.tick = 7, .travel = 3.0F, .force = 5.0F});
  study.traces().add(session.visit(), 0, samples);
  study.traces().add(session.visit(), 0, samples);  // again, after a commit of unknown outcome
  session.finishTrial(measuredTrial());
  tests::walkToTheEnd(session);
}

/// The files of an unblinded export that tell of trials.
std::vector<std::string> measuredIn(Study& study, const std::string& folder) {
  exportStudy(study, folder, {.runMode = RunMode::Live, .isBlinded = false}, "to compare");
  return {tests::contentOf(folder + "/trials.csv"), tests::contentOf(folder + "/cuts.csv")};
}

TEST(SealedTrials, AreTheSameWithTheKeyAsOpenOnes) {
  auto text = tests::shortProtocol();
  tests::MadeStudy sealed(tests::protocolFrom(text));
  tests::MadeStudy open(
      tests::protocolFrom(text.insert(text.find(R"("languages")"), R"("blinding": "open", )")));
  feel(*sealed);
  feel(*open);
  EXPECT_EQ(
      measuredIn(*sealed, sealed.scratch() / "out")[1],
      measuredIn(*open, open.scratch() / "out")[1]);
  const auto rows = [](Study& study) { return storage::Records(study.database()).trials(); };
  ASSERT_EQ(rows(*sealed).size(), rows(*open).size());
  for (std::size_t i = 0; i < rows(*open).size(); ++i) {
    const auto mine = rows(*sealed)[i];
    const auto other = rows(*open)[i];
    EXPECT_EQ(mine.verdict, other.verdict);
    EXPECT_EQ(base::describe(mine.reasons), base::describe(other.reasons));
    EXPECT_EQ(mine.slewed, other.slewed);
    EXPECT_EQ(mine.achievedRate, other.achievedRate);
    EXPECT_EQ(mine.lateTicks, other.lateTicks);
    EXPECT_EQ(mine.ticks, other.ticks);
    EXPECT_EQ(mine.cuts, other.cuts);
    EXPECT_EQ(mine.largestForce, other.largestForce);
  }
  const auto samples = sealed->traces().read(rows(*sealed).front().step.visit);
  ASSERT_EQ(samples.size(), 500U);
  EXPECT_EQ(samples.back().force, 5.0F);
  EXPECT_TRUE(verify(*sealed).isSound());
}

TEST(SealedTrials, TellNothingWithoutTheKey) {
  tests::MadeStudy made;
  feel(*made);
  const auto visit = storage::Records(made->database()).trials().front().step.visit;
  made.close();
  tests::Sql sql(made.file("study.db"));
  EXPECT_EQ(sql.number("SELECT count(*) FROM cut"), 0);
  EXPECT_EQ(
      sql.number("SELECT sum(duration_s + ticks + saturated_s + slewed_s + contact_s + "
                 "largest_force_n + cuts) FROM trial"),
      0);
  EXPECT_EQ(sql.number("SELECT count(DISTINCT length(sealed)) FROM trial"), 1);
  const tests::OwnStation elsewhere(made.scratch() / "elsewhere");
  auto study = Study::open(made.folder(), made.clock);
  EXPECT_THROW(study.traces().read(visit), storage::StorageError);
  EXPECT_EQ(study.traces().intactSampleCount(visit), 500);
  EXPECT_THROW(storage::Records(study.database()).trials(), storage::StorageError);
  int sealed = 0;
  for (const auto& event : study.events().read()) {
    EXPECT_FALSE(event.isErased);
    sealed += event.isSealed;
    if (event.kind == EventKind::Passivity || event.kind == EventKind::Answered) {
      EXPECT_EQ(describe(event) == "(sealed)", event.kind == EventKind::Passivity);
    }
  }
  EXPECT_GT(sealed, 3);
  EXPECT_TRUE(verify(study).isSound());
}

TEST(SealedTrials, AreNoticedIfTheyChange) {
  tests::MadeStudy made;
  feel(*made);
  made.close();
  tests::Sql(made.file("study.db"))
      .run(
          "UPDATE trial SET sealed = zeroblob(length(sealed)) WHERE step = "
          "(SELECT min(step) FROM trial)");
  made.reopen();
  EXPECT_FALSE(verify(*made).isSound());
  EXPECT_THROW(storage::Records(made->database()).trials(), storage::StorageError);
  tests::Sql(made.file("traces.db")).run("UPDATE chunk SET data = zeroblob(length(data))");
  const auto visit = made->traces().visits().front();
  EXPECT_THROW(made->traces().read(visit), storage::StorageError);
  EXPECT_THROW(made->traces().intactSampleCount(visit), storage::StorageError);
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

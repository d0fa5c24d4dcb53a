#include <filesystem>

#include <gtest/gtest.h>

#include "study/model/user_error.h"
#include "study/results/results.h"
#include "study/session/backup.h"
#include "study/session/erasure.h"
#include "study/session/study_key.h"
#include "study/storage/map/study_keys.h"
#include "study/storage/study_schema.h"
#include "tests/study/made_study.h"
#include "tests/study/session/erased_study.h"
#include "tests/study/storage/sql.h"
#include "tests/study/walk.h"

namespace study {
namespace old_study_erasure_test {

namespace fs = std::filesystem;
using tests::filesWith;
using tests::problemsOf;

const std::string kName = "Sentinel-7411 Beeblebrox";

/// A study of format 1, as palpate 0.1.0 made it.
class OldStudy : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directory(folder_);
    tests::Sql study(folder_ + "/study.db");
    study.run(
        tests::contentOf((tests::repository() / "tests/study/data/study-format-1.sql").string()));
    study.run("PRAGMA application_id = 0x50616c53; PRAGMA user_version = 1");
    storage::Database::create(folder_ + "/traces.db", storage::traceSchema());
    storage::Database::create(folder_ + "/identity.db", storage::identitySchema());
  }

  tests::ScratchFolder scratch_;
  tests::OwnStation station_{scratch_ / "station"};
  std::string folder_ = scratch_ / "old";
  SimulatedClock clock_{1'795'300'000'000};  // 2026-11-21, later
};

TEST_F(OldStudy, ErasesOnlyAfterItsTrailWasSealedAgain) {
  auto study = Study::open(folder_, clock_);
  study.identities().put({"Q1", 1, 0, 1}, "signature", kName, "then");
  ErasureRequest request{.participant = "Q1", .reason = "asked for it"};
  EXPECT_THROW(erase(study, request), UserError);
  const auto head = study.events().headAsText();
  const auto events = study.events().last();
  request.resealsTrail = true;
  EXPECT_TRUE(erase(study, request).wasTrailResealed);
  EXPECT_EQ(problemsOf(study), "");
  const auto first = study.events().read().front();
  ASSERT_EQ(first.kind, EventKind::ResealedTrail);
  EXPECT_EQ(*first.value("events"), base::Argument(events));
  const auto old = std::get<std::string>(*first.value("head"));
  EXPECT_NE(head.find(old.substr(0, 4) + " " + old.substr(4, 4)), std::string::npos);
  EXPECT_EQ(filesWith(folder_, "presence = 4"), std::vector<std::string>{});
  EXPECT_EQ(filesWith(folder_, kName), std::vector<std::string>{});
}

TEST_F(OldStudy, IsAnOlderCopyOnceItsTrailWasSealedAgain) {
  const std::string early = scratch_ / "early";
  const std::string last = scratch_ / "last";
  backUp(folder_, early);
  backUp(folder_, last);
  {
    auto study = Study::open(folder_, clock_);
    erase(study, {.participant = "Q1", .reason = "asked for it", .resealsTrail = true});
    EXPECT_EQ(problemsOf(study), "");
  }
  {
    auto copy = Study::open(early, clock_);  // is erased from, and sealed again as it was then
    ASSERT_EQ(copy.events().read().front().kind, EventKind::ResealedTrail);
    EXPECT_NE(problemsOf(copy).find("an older copy is in its place"), std::string::npos);
    EXPECT_EQ(problemsOf(copy, {.isOlderCopy = true}), "");
  }
  fs::remove(fs::path(scratch_ / "station") / "erasures");
  auto copy = Study::open(last, clock_);
  ASSERT_NE(copy.events().read().front().kind, EventKind::ResealedTrail);
  EXPECT_NE(problemsOf(copy).find("an older copy is in its place"), std::string::npos);
  EXPECT_EQ(problemsOf(copy, {.isOlderCopy = true}), "");
}

TEST_F(OldStudy, KeepsNamesBehindAPassphraseAndErasesLater) {
  constexpr const char* kPassphrase = "twelve grey horses";
  const auto setPassphrase = [](Study& study) {
    setPassphraseOfNames(
        study, kPassphrase, "the committee asks for it", storage::PassphraseCost::least());
  };
  std::int64_t events = 0;
  {
    auto study = Study::open(folder_, clock_);
    study.identities().put({"Q1", 1, 0, 1}, "signature", kName, "then");
    events = study.events().last();
  }
  ASSERT_EQ(filesWith(folder_, kName), std::vector<std::string>{"identity.db"}) << "control";
  {
    auto study = Study::open(folder_, clock_);
    setPassphrase(study);
    EXPECT_EQ(problemsOf(study), "");
    EXPECT_EQ(study.identities().names().at(0).text, kName);
    EXPECT_EQ(study.events().read().front().kind, EventKind::MadeStudy) << "its trail stays";
    EXPECT_GT(study.events().last(), events);
  }
  EXPECT_EQ(filesWith(folder_, kName), std::vector<std::string>{});
  storage::clearCachedKeys();
  auto study = Study::open(folder_, clock_);
  EXPECT_TRUE(study.identities().isLocked());
  const ErasureRequest request{.participant = "Q1", .reason = "asked for it", .resealsTrail = true};
  EXPECT_TRUE(erase(study, request).wasTrailResealed) << "also without the passphrase";
  EXPECT_EQ(problemsOf(study), "");
  EXPECT_EQ(filesWith(folder_, "presence = 4"), std::vector<std::string>{});
  EXPECT_EQ(study.identities().count("Q1"), 0U);
}

TEST_F(OldStudy, SealsNamesOfATrailThatWasSealedBefore) {
  auto study = Study::open(folder_, clock_);
  study.identities().put({"Q1", 1, 0, 1}, "signature", kName, "then");
  study.identities().drawKeys("Q1");  // as the erasure of somebody else does
  setPassphraseOfNames(study, "twelve grey horses", "as wanted", storage::PassphraseCost::least());
  EXPECT_EQ(filesWith(folder_, kName), std::vector<std::string>{});
  EXPECT_EQ(study.identities().names().at(0).text, kName);
}

TEST_F(OldStudy, SealsNoNameThatWasChanged) {
  auto study = Study::open(folder_, clock_);
  study.identities().put({"Q1", 1, 0, 1}, "signature", kName, "then");
  study.identities().database().execute("UPDATE identifying_answer SET text = 'Mallory'");
  const auto events = study.events().last();
  EXPECT_THROW(
      setPassphraseOfNames(
          study, "twelve grey horses", "as wanted", storage::PassphraseCost::least()),
      storage::StorageError);
  EXPECT_FALSE(study.identities().hasPassphrase());
  EXPECT_EQ(study.events().last(), events);
}

TEST_F(OldStudy, IsSaidByVerifyToBeInTheOpen) {
  auto study = Study::open(folder_, clock_);
  std::string remarks;
  for (const auto& check : verify(study).checks) {
    for (const auto& remark : check.remarks) remarks += remark;
  }
  EXPECT_NE(remarks.find("of 1 participant in the open"), std::string::npos) << remarks;
}

TEST_F(OldStudy, IsNotSealedAgainIfItIsNotSound) {
  auto study = Study::open(folder_, clock_);
  study.database().execute("UPDATE answer SET point = 5 WHERE item = 'presence'");
  const ErasureRequest request{.participant = "Q1", .reason = "asked for it", .resealsTrail = true};
  EXPECT_THROW(erase(study, request), storage::StorageError);
  EXPECT_EQ(study.events().read().front().kind, EventKind::MadeStudy);
}

TEST_F(OldStudy, GoesOnAfterItsTrailWasSealedAgain) {
  auto study = Study::open(folder_, clock_);
  {
    auto other = Session::enrol(study, {.cohort = "surgeons"});
    tests::walkToTheEnd(other);
  }
  erase(study, {.participant = "Q1", .reason = "asked for it", .resealsTrail = true});
  auto session = Session::enrol(study, {.cohort = "surgeons"});
  tests::walkToTheEnd(session);
  EXPECT_EQ(problemsOf(study), "");
  EXPECT_EQ(computeResults(study, RunMode::Live).completed(), 2);
}

}  // namespace old_study_erasure_test
}  // namespace study

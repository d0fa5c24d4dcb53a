// Results of real participants that name conditions need a reason, which is recorded.
#include "study/session/unblinding.h"

#include <algorithm>
#include <filesystem>
#include <variant>

#include <gtest/gtest.h>

#include "study/export/export.h"
#include "study/session/backup.h"
#include "study/session/erasure_copies.h"
#include "tests/study/made_study.h"
#include "tests/study/walk.h"
#include "tests/support/child_process.h"
#include "tests/support/programs.h"

namespace study {
namespace unblinding_test {

/// A live participant who has finished.
class UnblindingTest : public testing::Test {
 protected:
  UnblindingTest() {
    auto session = Session::enrol(*study_, {.cohort = "surgeons"});
    tests::walkToTheEnd(session);
  }

  tests::Finished palpate(std::vector<std::string> arguments) {
    study_.close();
    arguments.insert(arguments.begin(), tests::program());
    auto finished = tests::run(arguments);
    study_.reopen();
    return finished;
  }

  /// The recorded reasons of events of kind @p kind.
  std::vector<std::string> reasonsOf(const std::string& kind) {
    std::vector<std::string> reasons;
    for (const auto& event : study_->events().read()) {
      if (event.name() == kind) reasons.push_back(event.detail);
    }
    return reasons;
  }

  tests::MadeStudy study_;
};

TEST_F(UnblindingTest, NeedsAReasonForSessionsOfPeopleOnly) {
  for (const auto mode : {RunMode::Live, RunMode::Pilot}) {
    EXPECT_THROW(
        recordUnblinding(*study_, mode, EventKind::UnblindedReport, ""), storage::StorageError);
  }
  EXPECT_NO_THROW(recordUnblinding(*study_, RunMode::Simulated, EventKind::UnblindedReport, ""));
  recordUnblinding(
      *study_, RunMode::Simulated, EventKind::UnblindedReport, "said though nobody asked");
  EXPECT_TRUE(reasonsOf("unblinded_report").empty());
  recordUnblinding(*study_, RunMode::Live, EventKind::UnblindedReport, "plan signed");
  recordUnblinding(*study_, RunMode::Pilot, EventKind::UnblindedReport, "pilot done");
  EXPECT_EQ(reasonsOf("unblinded_report"), (std::vector<std::string>{"plan signed", "pilot done"}));
  EXPECT_THROW(
      recordUnblinding(*study_, RunMode::Live, EventKind::UnblindedReport, " \t"),
      storage::StorageError);
}

TEST_F(UnblindingTest, IsListedWithItsReasonByStudyTrail) {
  recordUnblinding(*study_, RunMode::Live, EventKind::UnblindedReport, "plan signed");
  const auto trail = palpate({"study", "trail", study_.folder()});
  EXPECT_EQ(trail.status, 0) << trail.error;
  EXPECT_NE(trail.out.find("unblinded_report   plan signed\n"), std::string::npos) << trail.out;
  EXPECT_EQ(trail.out.find("answered"), std::string::npos) << "of a session";
  EXPECT_NE(trail.out.find(", commitment: " + study_->events().commitment()), std::string::npos);
  EXPECT_EQ(trail.out.find("secret"), std::string::npos) << "what it shows is none";
}

TEST_F(UnblindingTest, KeepsTheReasonWhyAnOlderCopyWasPutBack) {
  const auto copy = study_.scratch() / "copy";
  backUp(study_.folder(), copy);
  recordUnblinding(*study_, RunMode::Live, EventKind::UnblindedReport, "signed after the copy");
  study_.close();
  std::filesystem::remove_all(study_.folder());
  std::filesystem::rename(copy, study_.folder());
  study_.reopen();
  const auto noted = palpate({"study", "restored", study_.folder(), "--reason", "the disk failed"});
  EXPECT_EQ(noted.status, 0) << noted.out << noted.error;
  const auto events = study_->events().read();
  const auto restored = std::ranges::find(events, EventKind::RestoredCopy, &storage::Event::kind);
  ASSERT_NE(restored, events.end());
  const auto* reason = restored->value("reason");
  ASSERT_NE(reason, nullptr);
  EXPECT_EQ(std::get<std::string>(*reason), "the disk failed");
}

TEST(OpenStudy, NeedsNoReasonAndIsCalledBlindedNowhere) {
  auto json = tests::shortProtocol();
  json.insert(json.find("\"languages\""), "\"blinding\": \"open\", ");
  tests::MadeStudy study(tests::protocolFrom(json));
  const auto events = study->events().last();
  EXPECT_NO_THROW(recordUnblinding(*study, RunMode::Live, EventKind::UnblindedReport, ""));
  EXPECT_EQ(study->events().last(), events);
  recordUnblinding(*study, RunMode::Live, EventKind::UnblindedReport, "said all the same");
  EXPECT_GT(study->events().last(), events);
  EXPECT_NE(blindingInWords(*study, {.runMode = RunMode::Live}), "blinded");
  ASSERT_EQ(disclosuresOf(*study).size(), 1U);
  EXPECT_EQ(disclosuresOf(*study)[0].key(), "blinding_open");
  EXPECT_NE(
      tests::run({tests::program(), "study", "status", study.folder()}).out.find("blinding: open"),
      std::string::npos);
}

TEST_F(UnblindingTest, ReportsAndStatisticsNeedAReasonAsExportsDo) {
  const std::string page = study_.scratch() / "page.html";
  const auto folder = study_.folder();
  const auto refused = palpate({"report", folder, "--out", page});
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(refused.error.find("--reason"), std::string::npos) << refused.error;
  EXPECT_FALSE(std::filesystem::exists(page));
  const auto unsaid = palpate({"stats", "run", folder});
  EXPECT_EQ(unsaid.status, 1);
  EXPECT_EQ(unsaid.out, "");
  EXPECT_EQ(palpate({"stats", "run", folder, "--watch"}).status, 1);
  EXPECT_TRUE(reasonsOf("unblinded_results").empty());

  EXPECT_EQ(palpate({"report", folder, "--out", page, "--reason", "plan signed"}).status, 0);
  EXPECT_TRUE(std::filesystem::exists(page));
  EXPECT_EQ(palpate({"stats", "run", folder, "--reason", "a second look"}).status, 0);
  const auto copies = knownCopies(*study_);
  ASSERT_EQ(copies.size(), 1U) << "an erasure has to list it";
  EXPECT_EQ(copies[0].folder, page);
  EXPECT_TRUE(copies[0].isPresent);
  EXPECT_EQ(reasonsOf("unblinded_report"), std::vector<std::string>{"plan signed"});
  EXPECT_EQ(reasonsOf("unblinded_results"), std::vector<std::string>{"a second look"});
}

}  // namespace unblinding_test
}  // namespace study

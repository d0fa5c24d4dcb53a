#include "study/session/erasure_copies.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "study/export/export.h"
#include "study/session/backup.h"
#include "study/session/unblinding.h"
#include "tests/study/session/erasure_fixture.h"

namespace study {
namespace erasure_test {

/// The study as it was before, in another folder.
class CopiedStudy : public ErasureTest {
 protected:
  void SetUp() override {
    ErasureTest::SetUp();
    backUp(study_.folder(), copy_);
  }
  bool isErasedFrom(const std::string& folder) {
    SimulatedClock clock;
    auto copy = Study::open(folder, clock, storage::Database::Access::ReadOnly);
    const bool isErased = copy.sessions().load(SessionId{1}).state == SessionState::Erased;
    EXPECT_EQ(problemsOf(copy, {.isOlderCopy = true}), "");
    EXPECT_EQ(problemsOf(*study_), "") << "the study does not suffer from its copies";
    return isErased && copy.identities().names().empty();
  }

  std::string copy_ = study_.scratch() / "backup";
};

TEST_F(CopiedStudy, IsErasedFromWhenItIsNamed) {
  EXPECT_EQ(filesWith(copy_, kSentinel), std::vector<std::string>{"study.db"}) << "the control";
  const auto report = eraseThem();
  const auto copy = eraseFromCopy(copy_, report.listed, report.texts, study_.clock);
  EXPECT_EQ(copy.outcome, ErasedCopy::Outcome::Erased);
  EXPECT_TRUE(copy.filesWithTexts.empty());
  EXPECT_TRUE(filesWith(copy_, kSentinel).empty());
  EXPECT_TRUE(isErasedFrom(copy_));
  const auto again = eraseFromCopy(copy_, report.listed, report.texts, study_.clock);
  EXPECT_EQ(again.outcome, ErasedCopy::Outcome::NotInCopy);
}

TEST_F(CopiedStudy, IsErasedFromWhenItIsOpenedToBeReadOnTheSameStation) {
  eraseThem();
  EXPECT_TRUE(isErasedFrom(copy_));
  EXPECT_TRUE(filesWith(copy_, kSentinel).empty());
}

TEST_F(CopiedStudy, IsLeftAsItIsOnAnotherStationUntilACertificateIsThere) {
  const auto report = eraseThem();
  const tests::OwnStation other(study_.scratch() / "other");
  EXPECT_FALSE(isErasedFrom(copy_));
  storage::addListedErasure(report.listed);
  EXPECT_TRUE(isErasedFrom(copy_));
}

TEST_F(CopiedStudy, KeepsAnotherParticipantOfTheSameCode) {
  auto report = eraseThem();
  report.listed.enrolledUtc = "2001-01-01T00:00:00.000Z";
  const tests::OwnStation other(study_.scratch() / "other");
  storage::addListedErasure(report.listed);
  EXPECT_FALSE(isErasedFrom(copy_));
  const auto copy = eraseFromCopy(copy_, report.listed, report.texts, study_.clock);
  EXPECT_EQ(copy.outcome, ErasedCopy::Outcome::NotInCopy);
}

TEST_F(CopiedStudy, IsRefusedIfItIsAnother) {
  const auto report = eraseThem();
  const auto outcome = [&](const std::string& folder) {
    return eraseFromCopy(folder, report.listed, report.texts, study_.clock).outcome;
  };
  tests::MadeStudy other(tests::protocolFrom(tests::shortProtocol()), 77);
  EXPECT_EQ(outcome(other.folder()), ErasedCopy::Outcome::Failed);
  fs::create_directory(study_.scratch() / "mine");
  std::ofstream(study_.scratch() / "mine/codebook.json") << "{\"study_uuid\": \"another\"}";
  EXPECT_EQ(outcome(study_.scratch() / "mine"), ErasedCopy::Outcome::Failed);
  EXPECT_TRUE(fs::exists(study_.scratch() / "mine/codebook.json"));
}

TEST_F(CopiedStudy, IsRemovedIfItIsAnExport) {
  std::size_t removed = 0;
  std::vector<std::string> exports;
  for (const auto format :
       {ExportFormat::Csv,
        ExportFormat::Json,
        ExportFormat::PsychDs,
        ExportFormat::Bids,
        ExportFormat::R,
        ExportFormat::Python}) {
    exports.push_back(study_.scratch() / ("export-" + std::to_string(exports.size())));
    exportStudy(*study_, exports.back(), {.format = format, .runMode = RunMode::Live});
  }
  const auto report = eraseThem();
  for (const auto& folder : exports) {
    const auto copy = eraseFromCopy(folder, report.listed, report.texts, study_.clock);
    EXPECT_EQ(copy.outcome, ErasedCopy::Outcome::Removed) << folder << copy.whyNot;
    removed += fs::exists(folder) ? 0 : 1;
  }
  EXPECT_EQ(removed, exports.size());
}

TEST_F(CopiedStudy, IsRemovedIfItIsAReportThatTheAuditTrailKnows) {
  const auto known = study_.scratch() / "report.html";
  const auto other = study_.scratch() / "other.html";
  const auto replaced = study_.scratch() / "replaced.html";
  const auto older = study_.scratch() / "older.html";
  for (const auto& file : {known, other, older}) std::ofstream(file) << kSentinel;
  std::ofstream(replaced) << "a letter that was saved there later";
  for (const auto& file : {known, replaced}) {
    recordReportPath(*study_, RunMode::Live, "report", file, kSentinel);
  }
  recordReportPath(
      *study_, RunMode::Live, "report", older);  // as releases without fingerprints did
  const auto report = eraseThem();
  const auto copies = knownCopies(*study_);
  const auto outcome = [&](const std::string& file) {
    return eraseFromCopy(file, report.listed, report.texts, study_.clock, copies).outcome;
  };
  EXPECT_EQ(outcome(known), ErasedCopy::Outcome::Removed);
  EXPECT_FALSE(fs::exists(known));
  for (const auto& file : {other, replaced, older}) {
    EXPECT_EQ(outcome(file), ErasedCopy::Outcome::Failed) << file;
    EXPECT_TRUE(fs::exists(file)) << file;
  }
}

TEST_F(CopiedStudy, ListsEachCopyThatWasMadeAndNotNamed) {
  exportStudy(*study_, study_.scratch() / "table", {.runMode = RunMode::Live});
  recordReportPath(*study_, RunMode::Live, "report", study_.scratch() / "report.html", kSentinel);
  for (const auto* participant : {"P001", "P002"}) recordConsentCopy(*study_, participant);
  const auto report = eraseThem();
  const auto listed = [&](const std::vector<ErasedCopy>& done) {
    std::vector<std::string> copies;
    for (const auto& copy : copiesNotErased(*study_, done, "P001")) {
      copies.push_back(copy.what + " " + fs::path(copy.folder).filename().string());
    }
    return copies;
  };
  using Copies = std::vector<std::string>;
  const std::string backup = "made_backup " + fs::path(copy_).filename().string();
  EXPECT_EQ(
      listed({}), (Copies{backup, "exported table", "exported report.html", "copied_consent "}));
  const auto done = eraseFromCopy(copy_, report.listed, report.texts, study_.clock);
  EXPECT_EQ(listed({done}), (Copies{"exported table", "exported report.html", "copied_consent "}));
}

TEST_F(CopiedStudy, ListsWhatAKilledBackupLeft) {
  const auto left = copy_ + ".unfinished-Xy12ab";
  fs::rename(copy_, left);
  eraseThem();
  const auto copies = copiesNotErased(*study_, {}, "P001");
  ASSERT_EQ(copies.size(), 2U);
  EXPECT_FALSE(copies[0].isPresent);
  EXPECT_EQ(copies[1].folder, left);
  EXPECT_TRUE(copies[1].isPresent);
}

TEST_F(CopiedStudy, DoesNotListItself) {
  eraseThem();
  auto restored = Study::open(copy_, study_.clock);
  for (const auto& copy : copiesNotErased(restored, {}, "P001")) EXPECT_NE(copy.folder, copy_);
}

TEST_F(CopiedStudy, ListsNoCopyThatWasNamedAndRemoved) {
  const auto folder = fs::current_path();
  const auto report = eraseThem();
  fs::current_path(study_.scratch().path());
  exportStudy(*study_, "table", {.runMode = RunMode::Live});
  const auto removed = eraseFromCopy("table", report.listed, report.texts, study_.clock);
  const auto absent = eraseFromCopy("nosuch", report.listed, report.texts, study_.clock);
  const auto copies = copiesNotErased(*study_, {removed}, "P001");
  fs::current_path(folder);
  EXPECT_EQ(removed.outcome, ErasedCopy::Outcome::Removed);
  EXPECT_EQ(absent.whyNot, "There is no file or folder of this name.");
  ASSERT_EQ(copies.size(), 1U);
  EXPECT_EQ(copies[0].folder, copy_);
}

TEST_F(CopiedStudy, ListsNoExportOfAnotherRunMode) {
  exportStudy(*study_, study_.scratch() / "live", {.runMode = RunMode::Live});
  exportStudy(*study_, study_.scratch() / "all", {});
  const auto pilot = [&] {
    return Session::enrol(*study_, {.cohort = "surgeons", .runMode = RunMode::Pilot}).participant();
  }();
  erase(*study_, {.participant = pilot, .reason = "asked for it"});
  std::vector<std::string> names;
  for (const auto& copy : copiesNotErased(*study_, {}, pilot)) {
    names.push_back(fs::path(copy.folder).filename().string());
  }
  EXPECT_EQ(names, (std::vector<std::string>{"backup", "all"}));
}

}  // namespace erasure_test
}  // namespace study

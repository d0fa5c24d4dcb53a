// Answers that name a person are stored in identity.db only.
#include <filesystem>

#include <gtest/gtest.h>

#include "study/export/export.h"
#include "tests/study/everything_instrument.h"
#include "tests/study/made_study.h"
#include "tests/study/walk.h"

namespace study {
namespace identity_test {

const std::string kName = "Zaphod Beeblebrox-Sentinel";

/// The names of the files under @p folder that contain @p text.
std::vector<std::string> filesWith(const std::string& folder, const std::string& text) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    if (tests::contentOf(entry.path()).find(text) == std::string::npos) continue;
    names.push_back(entry.path().filename().string());
  }
  return names;
}

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

}  // namespace identity_test
}  // namespace study

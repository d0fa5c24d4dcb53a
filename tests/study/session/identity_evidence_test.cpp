#include "study/session/identity_evidence.h"

#include <gtest/gtest.h>

#include "study/session/verification.h"
#include "tests/study/everything_instrument.h"
#include "tests/study/made_study.h"
#include "tests/study/storage/sql.h"
#include "tests/study/walk.h"

namespace study {
namespace identity_evidence_test {

/// A participant has given a name, and is at another step.
class IdentityEvidence : public testing::Test {
 protected:
  void SetUp() override {
    session_.emplace(Session::enrol(*study_, {.cohort = "surgeons"}));
    tests::walkTo(*session_, StepKind::Form);
    tests::answerStep(*session_, true);
    session_->record({.item = "name", .response = std::string("Ada"), .itemOrder = 2});
  }

  void goOn() { session_->finishStep(); }

  void edit(const std::string& sql) {
    const auto id = session_->id();
    session_.reset();
    study_.close();
    tests::Sql(study_.file("identity.db")).run(sql);
    study_.reopen();
    session_.emplace(Session::resume(*study_, id));
  }

  std::string problems() {
    std::string text;
    for (const auto& problem : checkIdentities(*study_).problems) text += problem + "\n";
    return text;
  }

  tests::MadeStudy study_{tests::protocolFrom(
      tests::protocolWithEverything(), {{"everything.json", tests::everythingInstrument()}})};
  std::optional<Session> session_;
};

TEST_F(IdentityEvidence, AgreesWithWhatWasWritten) {
  EXPECT_EQ(problems(), "");
  goOn();
  EXPECT_EQ(problems(), "");
  EXPECT_TRUE(checkIdentities(*study_).remarks.empty());
  EXPECT_TRUE(verify(*study_).isSound());
}

TEST_F(IdentityEvidence, FindsAnotherNameWithoutAHash) {
  goOn();
  edit("UPDATE identifying_answer SET text = 'Eve', hash = NULL");
  EXPECT_NE(problems().find("/name is not what the audit trail says"), std::string::npos);
  EXPECT_FALSE(verify(*study_).isSound());
}

TEST_F(IdentityEvidence, FindsThatNamesWereRemoved) {
  goOn();
  edit("DELETE FROM identifying_answer");
  EXPECT_NE(problems().find("/name is missing"), std::string::npos);
}

TEST_F(IdentityEvidence, FindsANameThatNobodyGave) {
  goOn();
  edit(
      "INSERT INTO identifying_answer (participant, session_number, step, attempt, item, text, "
      "saved_utc) SELECT 'P9', 1, 0, 1, item, text, saved_utc FROM identifying_answer LIMIT 1");
  EXPECT_NE(problems().find("P9/1/0/1/name was never answered"), std::string::npos);
}

TEST_F(IdentityEvidence, TellsNothingOfANameWithoutTheSecret) {
  const auto events = study_->events().read();
  std::string fingerprint;
  for (const auto& event : events) {
    const auto* value = event.value("fingerprint");
    if (value != nullptr) fingerprint = std::get<std::string>(*value);
  }
  EXPECT_EQ(fingerprint.size(), 64U);
  storage::BlindingSecret::Bytes other{};
  EXPECT_NE(storage::BlindingSecret(other).fingerprint("a"), tests::knownSecret().fingerprint("a"));
  EXPECT_NE(tests::knownSecret().fingerprint("a"), tests::knownSecret().fingerprint("b"));
}

/// The program ended between the commits to the two files.
TEST_F(IdentityEvidence, NotesWhatACrashLeftWhenTheSessionGoesOn) {
  edit("UPDATE identifying_answer SET text = 'Ada L.', hash = NULL");
  EXPECT_EQ(problems(), "");
  EXPECT_EQ(
      study_->events().read().rbegin()[1].name(), "noted_identities");  // its signature is the last
  edit("DELETE FROM identifying_answer");
  EXPECT_EQ(session_->missing(), std::vector<std::string>{"name"});
  EXPECT_EQ(problems(), "");
  session_->record({.item = "name", .response = std::string("Ada"), .itemOrder = 2});
  goOn();
  EXPECT_EQ(problems(), "");
}

}  // namespace identity_evidence_test
}  // namespace study

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

/// A participant gives a name in a form before the consent, and signs the consent form.
class NamesBeforeConsent : public testing::Test {
 protected:
  static std::string protocol() {
    auto json = tests::protocolWithEverything();
    const std::string phases = R"("phases": [)";
    return json.insert(
        json.find(phases) + phases.size(),
        R"({"id": "first", "type": "form", "instrument": "everything"},)");
  }

  void SetUp() override {
    tests::passStep(session_);
    session_.record({.item = "signature", .response = std::string("Ada"), .itemOrder = 9});
  }

  void consent(const std::string& answer) {
    session_.record({.item = "consent", .response = answer, .itemOrder = 1});
  }

  std::vector<std::string> kept() {
    std::vector<std::string> items;
    for (const auto& name : study_->identities().names()) items.push_back(name.item);
    return items;
  }

  tests::MadeStudy study_{
      tests::protocolFrom(protocol(), {{"everything.json", tests::everythingInstrument()}})};
  Session session_ = Session::enrol(*study_, {.cohort = "surgeons"});
};

TEST_F(NamesBeforeConsent, AreGoneOnceItIsRefused) {
  consent("no");
  EXPECT_EQ(kept(), std::vector<std::string>{"name"}) << "a signature waits for a yes";
  session_.finishStep();
  EXPECT_EQ(session_.state(), SessionState::Declined);
  EXPECT_TRUE(kept().empty());
  EXPECT_TRUE(verify(*study_).isSound());
  const auto noted = study_->events().read(EventKind::NotedIdentities);
  ASSERT_EQ(noted.size(), 1U);
  EXPECT_EQ(storage::describe(noted[0]), "P001/1/0/1/name=-") << "which is gone, and no name";
}

TEST_F(NamesBeforeConsent, AreGoneIfAYesBecomesANo) {
  consent("yes");
  consent("no");
  session_.finishStep();
  EXPECT_TRUE(kept().empty());
  EXPECT_TRUE(verify(*study_).isSound());
}

TEST_F(NamesBeforeConsent, AreKeptOnceItIsGiven) {
  EXPECT_EQ(session_.missing(), std::vector<std::string>{"consent"});
  consent("yes");
  EXPECT_EQ(kept(), (std::vector<std::string>{"name", "signature"}));
  session_.finishStep();
  EXPECT_TRUE(verify(*study_).isSound());
}

TEST_F(NamesBeforeConsent, AreNotKeptIfRetracted) {
  session_.retract("signature");
  consent("yes");
  session_.finishStep();
  EXPECT_EQ(kept(), std::vector<std::string>{"name"});
}

}  // namespace identity_evidence_test
}  // namespace study

// The words of a study stay those of its forms when it was made, also when the program ships other
// forms later (docs/decisions/0073).

#include <gtest/gtest.h>

#include "study/export/export.h"
#include "study/report/consent_copy.h"
#include "study/report/html_report.h"
#include "study/session/verification.h"
#include "tests/study/made_study.h"
#include "tests/study/walk.h"

namespace study::report {
namespace kept_forms_test {

bool has(const std::string& page, const std::string& words) {
  return page.find(words) != std::string::npos;
}

void replace(std::string& text, const std::string& part, const std::string& other) {
  const auto at = text.find(part);
  ASSERT_NE(at, std::string::npos) << part;
  text.replace(at, part.size(), other);
}

/// A study whose program shipped other words: another yes to the consent, another statement, and a
/// form for the debriefing that this program has not.
class KeptForms : public testing::Test {
 protected:
  static protocols::LoadedProtocol protocol() {
    auto text = tests::shortProtocol();
    auto files = tests::protocolFrom(text).files;
    replace(text, R"("instrument": "debrief")", R"("instrument": "farewell")");
    for (auto& file : files) {
      if (file.name == "palpate-library/consent-punch.json") {
        replace(file.text, R"("en": "Yes, )", R"("en": "Yes of then, )");
      } else if (file.name == "palpate-library/realism-cuts.json") {
        replace(
            file.text,
            R"("text": {
        "en": ")",
            R"("text": {
        "en": "Statement of then: )");
      } else if (file.name == "palpate-library/debrief.json") {
        file.name = "palpate-library/farewell.json";
        replace(file.text, R"("id": "debrief")", R"("id": "farewell")");
      }
    }
    return tests::protocolFrom(text, files);
  }

  KeptForms() {
    study_.reopen();
    simulateOne();
  }

  void simulateOne() {
    auto session = Session::enrol(*study_, {.cohort = "surgeons"});
    tests::walkToTheEnd(session);
    participant_ = session.participant();
  }

  tests::MadeStudy study_{protocol()};
  std::string participant_;
};

TEST_F(KeptForms, AreInThePagesOfASession) {
  auto session = Session::enrol(*study_, {.cohort = "surgeons"});
  tests::walkTo(session, StepKind::Consent);
  EXPECT_TRUE(has(session.items().front().options.front().text.in("en"), "Yes of then"));
  EXPECT_NE(session.protocol().instrument("farewell"), nullptr);
}

TEST_F(KeptForms, AreInTheConsentCopy) {
  EXPECT_TRUE(has(consentCopy(*study_, participant_), "Yes of then"));
}

TEST_F(KeptForms, AreInTheCodebookOfAnExport) {
  exportStudy(*study_, study_.scratch() / "out", {.runMode = RunMode::Live});
  const auto items = tests::contentOf(study_.scratch() / "out/items.csv");
  EXPECT_TRUE(has(items, "Statement of then: ")) << items;
}

TEST_F(KeptForms, AreInTheReport) {
  simulateOne();  // a second one: no mean of one person is shown
  EXPECT_TRUE(has(asHtml({gather(*study_, RunMode::Live)}), "Statement of then: "));
}

TEST_F(KeptForms, AreVerified) {
  EXPECT_TRUE(verify(*study_).isSound());
  study_->database().execute(
      "DROP TRIGGER a_frozen_file_stays_as_it_is;"
      "UPDATE protocol_file SET text = replace(text, 'Yes of then', 'Yes') "
      "WHERE name = 'palpate-library/consent-punch.json'");
  std::string told;
  for (const auto& check : verify(*study_).checks) {
    for (const auto& problem : check.problems) told += problem + "\n";
  }
  EXPECT_TRUE(has(told, "'palpate-library/consent-punch.json' of version 1 of the protocol"))
      << told;
}

TEST_F(KeptForms, ChangeWithAnAmendmentOnly) {
  study_->amend(tests::protocolFrom(tests::shortProtocol()), "the words of today");
  EXPECT_EQ(study_->protocol().instrument("farewell"), nullptr);
  EXPECT_NE(study_->protocol(ProtocolId{1}).instrument("farewell"), nullptr);
  EXPECT_TRUE(isSame(study_->protocols().current(), tests::protocolFrom(tests::shortProtocol())));
  EXPECT_TRUE(verify(*study_).isSound());
}

TEST(CopiedForms, OfAStudyThatHasNoneAreAddedAndLeaveItsHash) {
  auto protocol = tests::protocolFrom(tests::shortProtocol());
  const auto whole = protocol;
  protocol.files.clear();  // as releases stored it that kept no copies
  tests::MadeStudy study(protocol);
  const auto stored = study->protocols().current();
  EXPECT_EQ(stored.sha256, storage::sha256(protocol.text));
  EXPECT_EQ(stored.files.size(), whole.files.size());
  EXPECT_TRUE(isSame(stored, whole)) << "there is nothing to amend";
  EXPECT_TRUE(verify(*study).isSound());
}

}  // namespace kept_forms_test
}  // namespace study::report

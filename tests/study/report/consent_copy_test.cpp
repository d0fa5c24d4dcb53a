#include "study/report/consent_copy.h"

#include <gtest/gtest.h>

#include "study/storage/evidence/signed_head.h"
#include "tests/study/made_study.h"
#include "tests/study/walk.h"

namespace study::report {
namespace consent_copy_test {

bool has(const std::string& page, const std::string& words) {
  return page.find(words) != std::string::npos;
}

class ConsentCopy : public testing::Test {
 protected:
  Session participant(const char* language) {
    return tests::consenting(study_, {.cohort = "professional", .language = language});
  }

  tests::ScratchFolder folder_;
  SimulatedClock clock_;
  Study study_ = Study::create(
      folder_ / "study",
      tests::libraryProtocol("punch-face-validity"),
      clock_,
      7,
      tests::knownSecret());
};

TEST_F(ConsentCopy, HasInformationTermsAndChoiceInTheParticipantsLanguage) {
  const auto session = participant("de");
  const auto page = consentCopy(study_, session.participant());
  const auto& protocol = session.protocol();
  const auto* consent = protocol.instrument("consent-punch-2");
  EXPECT_TRUE(has(page, "<html lang=\"de\">"));
  EXPECT_TRUE(has(page, "Mir ist bekannt, dass die Teilnahme freiwillig ist"));
  EXPECT_TRUE(has(page, "→ Ja, ich nehme teil"));
  EXPECT_TRUE(has(page, "nicht beantwortet")) << "the video, which nobody was asked to allow";
  EXPECT_TRUE(has(page, "consent-punch-2, Version " + consent->version));
  EXPECT_TRUE(has(page, study_.protocols().current().sha256));
  EXPECT_TRUE(has(page, session.participant()));
  const auto end = storage::endOf(study_.database());
  EXPECT_TRUE(has(page, std::to_string(end.events) + " Ereignisse"));
  EXPECT_TRUE(has(page, storage::inGroupsOfFour(end.hash)));
  const auto information = protocol.protocol.phases.front().instrument;
  EXPECT_TRUE(has(page, protocol.instrument(information)->title.in("de")));
}

TEST_F(ConsentCopy, NamesNoPerson) {
  auto session = Session::enrol(study_, {.cohort = "professional"});
  tests::walkTo(session, StepKind::Consent);
  auto signature = session.items().back();
  ASSERT_TRUE(signature.isIdentifying);
  session.record({.item = signature.id, .response = std::string("Erika Muster"), .language = "en"});
  tests::answerStep(session);
  session.finishStep();
  const auto page = consentCopy(study_, session.participant());
  EXPECT_FALSE(has(page, "Erika"));
  EXPECT_TRUE(has(page, "Signature, if one is asked for"));
}

TEST_F(ConsentCopy, IsOfTheSessionInWhichTheParticipantConsented) {
  auto first = participant("de");
  const auto page = consentCopy(study_, first.participant());
  first.reject("the device was broken");
  auto second = Session::enrol(study_, {.cohort = "professional", .code = first.participant()});
  ASSERT_EQ(second.participant(), first.participant());
  EXPECT_TRUE(has(consentCopy(study_, first.participant()), "→ Ja, ich nehme teil"));
}

TEST_F(ConsentCopy, IsRefusedBeforeTheDecision) {
  const auto session = Session::enrol(study_, {.cohort = "professional"});
  try {
    consentCopy(study_, session.participant());
    FAIL();
  } catch (const UserError& refusal) {
    EXPECT_TRUE(has(refusal.what(), session.participant()));
  }
  EXPECT_THROW(consentCopy(study_, "nobody"), UserError);
}

}  // namespace consent_copy_test
}  // namespace study::report

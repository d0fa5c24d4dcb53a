#include "study/report/report_section.h"

#include <gtest/gtest.h>

#include "study/report/study_parts.h"
#include "tests/study/made_study.h"
#include "tests/study/walk.h"

namespace study::report {
namespace {

TEST(ReportSection, CountsWhatWasFeltAgainBesideTheTrials) {
  tests::MadeStudy study(tests::protocolFrom(tests::shortProtocol({.offersAgain = true})));
  auto session = Session::enrol(*study, {.cohort = "surgeons"});
  tests::walkUntil(session, [](const Step& step) { return step.isOffered; });
  session.declineOffer();
  session.beginTrial();
  session.finishTrial(tests::feltTrial(4));
  session.declineOffer();
  tests::walkToTheEnd(session);

  const auto section = gather(*study, RunMode::Live);

  EXPECT_EQ(section.quality.trials, 3);
  EXPECT_EQ(section.quality.cuts, 3);
  EXPECT_EQ(section.quality.feltAgain, 1);
  const auto page = renderingAsHtml(section);
  EXPECT_NE(page.find("3 trials, 3 cuts or strokes: "), std::string::npos) << page;
  EXPECT_NE(page.find("Not among them: 1 time "), std::string::npos) << page;
}

}  // namespace
}  // namespace study::report

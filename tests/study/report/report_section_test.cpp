#include "study/report/report_section.h"

#include <algorithm>
#include <regex>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "study/cohort/simulated_participant.h"
#include "study/report/html_report.h"
#include "study/report/study_parts.h"
#include "study/results/results_text.h"
#include "tests/study/made_study.h"
#include "tests/study/walk.h"

namespace study::report {
namespace report_section_test {

TEST(ReportSection, CountsOptionalTrialsSeparately) {
  tests::MadeStudy study(tests::protocolFrom(tests::shortProtocol({.offersAgain = true})));
  auto session = Session::enrol(*study, {.cohort = "surgeons"});
  tests::walkUntil(session, [](const Step& step) { return step.isOptionalTrial; });
  session.skipOptionalTrial();
  session.beginTrial();
  session.finishTrial(tests::feltTrial(4));
  session.skipOptionalTrial();
  tests::walkToTheEnd(session);

  const auto section = gather(*study, RunMode::Live);

  EXPECT_EQ(section.quality.trials, 3);
  EXPECT_EQ(section.quality.cuts, 3);
  EXPECT_EQ(section.quality.optionalTrials, 1);
  const auto page = renderingAsHtml(section);
  EXPECT_NE(page.find("3 trials, 3 cuts: "), std::string::npos) << page;
  EXPECT_NE(page.find("Not among them: 1 time "), std::string::npos) << page;
}

TEST(ReportSection, CountsSessionsWhoseOperatorSawTheForces) {
  tests::MadeStudy study;
  for (const bool areShown : {false, true}) {
    auto session = Session::enrol(*study, {.cohort = "surgeons"});
    if (areShown) session.noteForcesShown(true);
    session.noteForcesShown(false);
    tests::walkToTheEnd(session);
  }
  EXPECT_EQ(gatherResults(*study, RunMode::Live).sessionsWithForces, 1);
  EXPECT_EQ(gatherResults(*study, RunMode::Pilot).sessionsWithForces, 0);
}

TEST(ReportSection, CountsTrialsByTheirVerdicts) {
  auto protocol = tests::shortProtocol();  // open: what is sealed cannot be changed here
  protocol.insert(protocol.find(R"("languages")"), R"("blinding": "open", )");
  tests::MadeStudy study(tests::protocolFrom(protocol));
  auto session = Session::enrol(*study, {.cohort = "surgeons"});
  tests::walkToTheEnd(session);
  auto& database = study->database();
  database.execute(
      "UPDATE trial SET verdict = 'FAIL' WHERE rowid = (SELECT min(rowid) FROM trial)");
  database.execute(
      "UPDATE trial SET verdict = 'WARN' WHERE rowid > (SELECT min(rowid) FROM trial)");
  const auto section = gather(*study, RunMode::Live);
  EXPECT_EQ(section.quality.pass, 0);
  EXPECT_EQ(section.quality.warn, 2);
  EXPECT_EQ(section.quality.fail, 1);
}

TEST(ReportSection, CountsTrialsWhoseForceWasCutOffByCondition) {
  auto protocol = tests::shortProtocol();  // open: what is sealed cannot be changed here
  protocol.insert(protocol.find(R"("languages")"), R"("blinding": "open", )");
  tests::MadeStudy study(tests::protocolFrom(protocol));
  auto session = Session::enrol(*study, {.cohort = "surgeons"});
  tests::walkToTheEnd(session);
  study->database().execute(
      "UPDATE trial SET saturated_s = 0.5, contact_s = 2.0 "
      "WHERE rowid = (SELECT min(rowid) FROM trial)");
  const auto section = gather(*study, RunMode::Live);
  ASSERT_EQ(section.quality.saturatedTrials.size(), 1U);
  const auto& found = section.quality.saturatedTrials.front();
  EXPECT_EQ(found.shares, std::vector<double>{0.25});
  EXPECT_GE(found.trials, 1);
  const auto& title = section.conditionTitle(found.condition);
  const auto flags = section.results.families.front().cohorts.front().flags;
  const auto flag = std::ranges::find(flags, "saturated", &analysis::Flag::id);
  ASSERT_NE(flag, flags.end());
  EXPECT_NE(flag->inEnglish().find("“" + title + "” in 1 of "), std::string::npos)
      << flag->inEnglish();
}

TEST(ReportSection, ComparesTheMethodWithTheHigherMeanWithTheOther) {
  tests::MadeStudy study;
  simulateCohorts(*study, study.clock, 4, 3, [](const auto&) {});
  const auto declared = computeResults(*study, RunMode::Simulated).families.front();
  const auto family = gatherResults(*study, RunMode::Simulated).results.families.front();
  std::size_t turned = 0;
  for (std::size_t i = 0; i < family.family.comparisons.size(); ++i) {
    const auto& pair = family.family.comparisons[i];
    EXPECT_GE(*meanOfAll(family, pair.first), *meanOfAll(family, pair.second));
    for (std::size_t part = 0; part < family.cohorts.size(); ++part) {
      const auto& row = family.cohorts[part].within.rows[i];
      const auto& asDeclared = declared.cohorts[part].within.rows[i];
      EXPECT_EQ(row.group1, pair.first);
      EXPECT_EQ(family.cohorts[part].comparisons.rows[i].group1, pair.first);
      if (row.group1 == asDeclared.group1) continue;
      ++turned;
      const auto& difference = row.test("paired_t").estimate.value;
      if (difference) {
        EXPECT_DOUBLE_EQ(*difference, -*asDeclared.test("paired_t").estimate.value);
      }
    }
  }
  EXPECT_GT(turned, 0U) << "the simulated answers turn no pair";
}

TEST(ReportSection, SummarisesTheLandmarksOfTheCutsThatCount) {
  tests::MadeStudy study;
  simulateCohorts(*study, study.clock, 4, 3, [](const auto&) {});
  const auto section = gather(*study, RunMode::Simulated);
  std::uint64_t cuts = 0;
  for (const auto& one : section.landmarks) {
    if (one.landmark == "largest force") cuts += one.force.n;
    EXPECT_GT(one.force.n, 0U);
  }
  EXPECT_EQ(cuts, static_cast<std::uint64_t>(section.quality.cuts));
  EXPECT_TRUE(gather(*study, RunMode::Live).landmarks.empty());
}

TEST(ReportSection, CallsStrokesAsItsDeviceDoes) {
  const auto strokesOf = [](const char* protocol) {
    tests::MadeStudy study(tests::libraryProtocol(protocol));
    const auto section = gatherResults(*study, RunMode::Simulated);
    return section.words.count(3, "{} cut or stroke", "{} cuts or strokes");
  };
  EXPECT_EQ(strokesOf("reaming-hardness"), "3 strokes");
  EXPECT_EQ(strokesOf("punch-face-validity"), "3 cuts");
}

TEST(ReportSection, LeavesADamagedTraceOutWithAReason) {
  tests::MadeStudy study;
  simulateCohorts(*study, study.clock, 2, 3, [](const auto&) {});
  study->traces().database().execute(
      "UPDATE chunk SET data = zeroblob(8) WHERE rowid = (SELECT min(rowid) FROM chunk)");
  const auto section = gather(*study, RunMode::Simulated, words::wordsIn("de"));
  const auto page = asHtml({section});
  EXPECT_NE(
      page.find("Was gefühlt wurde, ist nicht bekannt: traces.db ist beschädigt: "),
      std::string::npos)
      << base::describe(section.curvesReason);
  EXPECT_NE(page.find("Durchgänge, "), std::string::npos) << "the rest is there";
}

TEST(ReportSection, SaysHowFarTheAuditTrailWas) {
  tests::MadeStudy study;
  auto session = Session::enrol(*study, {.cohort = "surgeons"});
  tests::walkToTheEnd(session);
  const auto live = gather(*study, RunMode::Live);
  EXPECT_EQ(
      std::to_string(live.trail.events) + " events, " + storage::inGroupsOfFour(live.trail.hash),
      study->events().headAsText());
  EXPECT_NE(asHtml({live}).find(storage::inGroupsOfFour(live.trail.hash)), std::string::npos);
  EXPECT_EQ(live.commitment, tests::knownSecret().commitment());
  EXPECT_NE(asHtml({live}).find(storage::inGroupsOfFour(live.commitment)), std::string::npos);
  // Simulated sessions are made again from a seed, with the same report.
  EXPECT_TRUE(gather(*study, RunMode::Simulated).commitment.empty());
  EXPECT_TRUE(gather(*study, RunMode::Simulated).trail.hash.empty());
}

TEST(ReportSection, HasNoCellWithADashWhereOnePersonTookPart) {
  tests::MadeStudy study;
  simulateCohorts(*study, study.clock, 1, 3, [](const auto&) {});
  const auto page = asHtml({gather(*study, RunMode::Simulated)});
  const std::regex dash("<td[^>]*>(<[^>]*>)*(–|-|nan)[^<]{0,3}</");
  EXPECT_FALSE(std::regex_search(page, dash)) << page;
  EXPECT_EQ(page.find("CI –"), std::string::npos);
}

TEST(ReportSection, HasItemsThatAreInTheTerminalAsWell) {
  tests::MadeStudy study(tests::protocolFrom(tests::shortProtocol({.form = "background"})));
  simulateCohorts(*study, study.clock, 3, 3, [](const auto&) {});
  const auto results = computeResults(*study, RunMode::Simulated);
  const auto text = resultsAsText(*study, results, Profile::Declared);
  ASSERT_FALSE(results.answers.items.empty());
  for (const auto& one : results.answers.items) {
    EXPECT_NE(text.find("\n" + one.instrument + ", " + one.item + "  "), std::string::npos)
        << one.instrument << ", " << one.item << " is not in\n"
        << text;
    if (!one.mean) continue;
    const auto words = rounded(one.median, 2) + ", " + fmt::format("{:.4g} … ", *one.least);
    EXPECT_NE(text.find(words), std::string::npos) << words << " is not in\n" << text;
  }
  ASSERT_FALSE(results.answers.quotes.empty());
  EXPECT_NE(text.find(", quoted in the report\n"), std::string::npos) << text;
}

/// A simulated participant of a shipped protocol, as a page.
std::string pageOfOne(const char* protocol) {
  tests::MadeStudy study(tests::libraryProtocol(protocol));
  simulateCohorts(*study, study.clock, 1, 3, [](const auto&) {});
  return asHtml({gather(*study, RunMode::Simulated)});
}

TEST(ReportSection, HasNoDashInATableOfOneParticipant) {
  for (const auto* protocol :
       {"punch-face-validity", "punch-counterbalanced", "reaming-hardness"}) {
    const auto page = pageOfOne(protocol);
    EXPECT_NE(page.find("<h2 class=\"appendix\">"), std::string::npos) << protocol;
    const auto dash = page.find("–</td>");
    EXPECT_EQ(dash, std::string::npos) << protocol << page.substr(dash - 300, 320);
  }
}

/// Finds wrong plurals: "1 cuts", "1 participants".
std::string oneOfMany(const std::string& text) {
  static const std::regex kWrong(
      "[^0-9.]1 (participants|people|cuts|trials|answers|comparisons|alternatives|forms|times|"
      "points|sessions|versions)[^a-z]");
  std::smatch found;
  return std::regex_search(text, found, kWrong) ? found.str() : "";
}

TEST(ReportSection, UsesTheSingularForOne) {
  tests::MadeStudy study(
      tests::protocolFrom(tests::shortProtocol({.conditions = {"interpolation", "kalman"}})));
  auto session = Session::enrol(*study, {.cohort = "surgeons"});
  tests::walkToTheEnd(session);
  const auto section = gather(*study, RunMode::Live);
  const auto page = asHtml({section});
  EXPECT_NE(page.find("at least 1 cut each"), std::string::npos);
  EXPECT_NE(page.find(", 1 comparison."), std::string::npos);
  EXPECT_NE(page.find("Surgeons (1 participant): nothing can be tested: "), std::string::npos);
  EXPECT_EQ(oneOfMany(page), "");
  EXPECT_EQ(oneOfMany(resultsAsText(*study, section.results, Profile::Recommended)), "");
  EXPECT_EQ(oneOfMany(resultsAsText(*study, section.results, Profile::AsPublished)), "");
  EXPECT_EQ(oneOfMany("at least 1 cuts each"), " 1 cuts ") << "or this test sees nothing";
}

}  // namespace report_section_test
}  // namespace study::report

// The methods part of a report: what a reviewer asks of the apparatus, the design and the analysis.
#include <algorithm>
#include <regex>

#include <gtest/gtest.h>

#include "analysis/registry/registry.h"
#include "study/report/references.h"
#include "study/report/study_parts.h"
#include "tests/study/report/section.h"

namespace methods_test {
namespace {

using study::Wording;
using study::report::Citations;

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::string methodsOf(const study::report::ReportSection& section) {
  return study::report::methodsAsHtml(section);
}

TEST(Methods, NamesTheDeviceItsAxisItsRateAndItsLimits) {
  const auto text = methodsOf(tests::madeUpSection());
  EXPECT_TRUE(
      has(text,
          "Device: punch. Forces act along one axis (travel [travel units], nominally from 0 to "
          "11) and are "
          "limited to 8 N and 500 N/s. They were computed 1000 times a second."))
      << text;
}

TEST(Methods, CitesTheOriginOfEveryForceModel) {
  const auto text = methodsOf(tests::madeUpSection());
  EXPECT_TRUE(has(
      text,
      "Interpolation: linear interpolation of a cut; FEM: one-dimensional finite "
      "elements; "
      "KF: interpolation and finite elements, fused by a Kalman filter (“Intraoperative Data-Based "
      "Haptic Feedback”, n.d.; Bjelland, 2022)."))
      << text;
  EXPECT_TRUE(has(text, "<p class=\"reference\">Bjelland, Ø. (2022). <em>ARDUINO")) << text;
}

TEST(Methods, ListsNoWorkThatTheTextOnOneParticipantDoesNotCite) {
  auto section = tests::madeUpSection();
  EXPECT_TRUE(
      has(methodsOf(section), "<p class=\"reference\">Fisher, R. A. (1935). <em>The design"));
  section.results.flow = {{.cohort = "professional", .enrolled = 1, .completed = 1}};
  auto& family = section.results.families.front();
  family.family.correction = protocols::CorrectionType::Holm;
  for (auto& cohort : family.cohorts) {
    cohort.within = {};
    cohort.comparisons = {};
  }
  const auto text = methodsOf(section);
  EXPECT_FALSE(has(text, "Holm, S. (1979)")) << text;
  EXPECT_FALSE(has(text, "Fisher, R. A. (1935)")) << text;
}

TEST(Methods, NamesDatesInstitutionAndEthicsOrSaysThatTheyAreMissing) {
  auto section = tests::madeUpSection();
  EXPECT_TRUE(has(methodsOf(section), "no dates of data collection. The study names neither an "));
  section.results.runMode = study::RunMode::Live;
  section.firstDay = "2026-03-01";
  section.lastDay = "2026-04-02";
  const auto inEnglish = [](const std::string& text) {
    return protocols::LocalizedText(std::map<std::string, std::string>{{"en", text}});
  };
  section.protocol.texts["ethics"] = inEnglish("REK 2026/1.");
  const auto partly = methodsOf(section);
  EXPECT_TRUE(has(
      partly,
      "Data were collected from 2026-03-01 to 2026-04-02. Ethics: REK 2026/1. The study names no "
      "institution."))
      << partly;
  section.protocol.texts["institution"] = inEnglish("NTNU");
  EXPECT_TRUE(has(methodsOf(section), "Institution: NTNU. Ethics: REK 2026/1.</p>"));
}

TEST(Methods, ClaimsNoBlindingThatTheDesignGivesAway) {
  auto section = tests::madeUpSection();
  const std::string but = " But a reader of the protocol could tell conditions apart by ";
  EXPECT_TRUE(has(
      methodsOf(section),
      but + "the number of an alternative, the position in a fixed order and the statements that "
            "were asked (“Limitations”)."));
  EXPECT_FALSE(has(methodsOf(section), "anonymous"));
  auto& protocol = section.protocol;
  protocol.labels.policy = protocols::LabelPolicy::Random;
  for (auto& phase : protocol.phases) {
    phase.trials.order.type = protocols::OrderType::LatinSquare;
    phase.trials.questionnaires.clear();
  }
  EXPECT_FALSE(has(methodsOf(section), but));
  EXPECT_TRUE(has(methodsOf(section), "saw labels only"));
}

TEST(Methods, SaysThatOperatorsSawTheForces) {
  auto section = tests::madeUpSection();
  section.results.runMode = study::RunMode::Live;
  section.sessionsWithForces = 2;
  const auto text = methodsOf(section);
  EXPECT_FALSE(has(text, "Participants and operators saw labels only")) << text;
  EXPECT_TRUE(has(text, " sessions the operator saw the forces, which differ between conditions."));
  EXPECT_TRUE(has(weaknessesAsHtml(section), "<li>The operator saw the forces in 2 of "));
  EXPECT_TRUE(has(limitationsAsHtml(section), "<dt>The operator saw the forces in 2 of "));
  section.results.runMode = study::RunMode::Pilot;
  section.sessionsWithForces = 0;
  EXPECT_FALSE(has(weaknessesAsHtml(section), "saw the forces"));
  EXPECT_FALSE(has(methodsOf(section), "operators saw labels only")) << "pilots show the forces";
}

TEST(Methods, NamesEveryPartOfTheProcedureAndWhatHasNoSource) {
  auto section = tests::madeUpSection();
  const auto text = methodsOf(section);
  for (const auto& phase : section.protocol.phases) {
    if (phase.instrument.empty()) continue;
    EXPECT_TRUE(has(text, "“" + section.titleOf(phase.instrument) + "”")) << phase.id;
  }
  EXPECT_TRUE(has(text, "They gave their consent (“"));
  EXPECT_TRUE(has(text, "all of it was simulated"));
  section.results.runMode = study::RunMode::Live;
  EXPECT_FALSE(has(methodsOf(section), "all of it was simulated"));
  EXPECT_TRUE(
      has(text, "<li>parameters of the protocol; nothing was recorded or measured: FEM</li>"));
}

TEST(Methods, CountsWhatEachConditionContributes) {
  const auto text = methodsOf(tests::madeUpSection());
  EXPECT_TRUE(
      has(text,
          "Counted: Interpolation: 12 trials, 37 cuts or strokes, 41 answers; KF: 12 trials, 36 "
          "cuts or "
          "strokes, "
          "41 answers."))
      << text;
  auto section = tests::madeUpSection();
  section.quality.conditions[0].cuts = 36;
  EXPECT_TRUE(
      has(methodsOf(section),
          "Counted for each alternative: 12 trials, 36 cuts or strokes, 41 answers."));
}

TEST(Methods, ExplainsOnlyTestsThatTheReportHas) {
  auto section = tests::madeUpSection();
  EXPECT_TRUE(has(methodsOf(section), "Welch’s t-test (Welch, 1947)"));
  EXPECT_TRUE(has(methodsOf(section), "before they are rounded: Bonferroni."));
  EXPECT_FALSE(has(methodsOf(section), "Schuirmann"));
  auto& family = section.results.families.front().family;
  family.test = protocols::TestType::PairedT;
  family.correction = protocols::CorrectionType::Holm;
  const auto paired = methodsOf(section);
  EXPECT_FALSE(has(paired, "(Welch, 1947)"));
  EXPECT_TRUE(has(paired, "Paired t-test (Student, 1908)"));
  EXPECT_TRUE(has(paired, "before they are rounded: Holm (Holm, 1979)."));
  section.results.families.front().cohorts.clear();
  section.results.votes.clear();
  EXPECT_FALSE(has(methodsOf(section), "Student"));
}

TEST(Methods, ListsEveryWorkThatItCites) {
  const auto text = methodsOf(tests::madeUpSection());
  const std::regex citation(
      R"re(([A-Z][\w–]+)(?: &amp; ([A-Z]\w+))?(?: et al\.)?, ((?:18|19|20)\d\d)[;)])re");
  const auto list = text.substr(text.find("<h4>References</h4>"));
  int cited = 0;
  for (std::sregex_iterator at(text.begin(), text.end(), citation), end; at != end; ++at, ++cited) {
    EXPECT_TRUE(std::regex_search(
        list, std::regex("reference\">" + (*at)[1].str() + "[^<]*\\(" + (*at)[3].str() + "\\)")))
        << at->str();
  }
  EXPECT_GT(cited, 10);
}

TEST(Methods, ListTheWorksThatTheLimitationsName) {
  const auto section = tests::madeUpSection();
  EXPECT_TRUE(
      has(study::report::limitationsAsHtml(section), "(Hurlbert, 1984; Lazic et al., 2020)"));
  const auto text = methodsOf(section);
  const auto list = text.substr(text.find("<h4>References</h4>"));
  for (const auto* work : {"Hurlbert, S. H. (1984)", "Lazic, S. E.", "Williams, E. J. (1949)"}) {
    EXPECT_TRUE(has(list, work)) << work;
  }
}

TEST(Methods, SayWhyACurveIsFlat) {
  auto section = tests::madeUpSection();
  const auto text = [&] { return study::report::renderingAsHtml(section); };
  EXPECT_FALSE(has(text(), "is flat"));
  for (auto& point : section.curves[0].points) point.median = 4.29;
  for (auto& point : section.curves[1].points) point.median = std::min(point.travel, 7.0);
  EXPECT_TRUE(
      has(text(),
          "Interpolation is flat at 4.29 N, to which the published code limits it. FEM is "
          "flat at 7.00 N, its yield force"))
      << text();
  for (auto& point : section.curves[1].points) point.median = std::min(point.travel, 8.0);
  EXPECT_TRUE(has(text(), "FEM is flat at 8.00 N, the largest force that the study allows."));
}

TEST(Citations, AreOfAuthorsAndYearsInApa) {
  Citations citations(Wording::Apa);
  EXPECT_EQ(citations.cite("Mann & Whitney 1947"), "(Mann & Whitney, 1947)");
  EXPECT_EQ(citations.cite("Cronbach 1951, Feldt 1965"), "(Cronbach, 1951; Feldt, 1965)");
  citations.cite(study::report::kReamingPaper);
  const auto list = citations.list({});
  ASSERT_EQ(list.size(), 4U);
  EXPECT_EQ(
      list[2],
      "Mann, H. B., &amp; Whitney, D. R. (1947). On a test of whether one of two random variables "
      "is stochastically larger than the other. <em>The Annals of Mathematical Statistics</em>, "
      "18(1), 50–60. doi:10.1214/aoms/1177730491");
  EXPECT_TRUE(has(list[3], "Heyde, C.-E., Kaluschke, M.")) << list[3];
}

TEST(Citations, AreNumbersInTheVancouverStyle) {
  Citations citations(Wording::Vancouver);
  EXPECT_EQ(citations.cite("Wilson 1927"), "[1]");
  EXPECT_EQ(citations.cite("Cronbach 1951, Wilson 1927"), "[2, 1]");
  const auto list = citations.list({});
  ASSERT_EQ(list.size(), 2U);
  EXPECT_EQ(
      list[1],
      "2. Cronbach LJ. Coefficient alpha and the internal structure of tests. Psychometrika. "
      "1951;16(3):297–334. doi:10.1007/BF02310555");
}

TEST(Citations, KnowTheSourceOfEveryTestThatAReportMayHave) {
  Citations citations(Wording::Apa);
  for (const auto& test : analysis::statisticalTests()) {
    const bool isPooled = test.id == "welch" || test.id == "mixed_model" ||
                          test.id == "ordinal_model" || test.id == "equal_shares";
    if (test.use == analysis::StudyUse::None && !isPooled) continue;
    EXPECT_NO_THROW(citations.cite(test.source)) << test.id;
  }
}

}  // namespace
}  // namespace methods_test

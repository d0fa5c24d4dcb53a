#include "study/report/html_report.h"

#include <gtest/gtest.h>

#include "protocols/load_protocol.h"
#include "protocols/model/messages.h"
#include "study/report/numbering.h"
#include "study/report/print_html.h"
#include "study/report/study_parts.h"
#include "tests/study/report/section.h"

namespace study::report {
namespace html_report_test {

bool has(const std::string& page, const std::string& words) {
  return page.find(words) != std::string::npos;
}

TEST(HtmlReport, HasTheMeansAndVariancesOfThePapersTable) {
  const auto page = asHtml({tests::madeUpSection()});
  // The counts of the synthetic study, which round to the paper's Table 2.
  EXPECT_TRUE(has(
      page,
      "<td>36</td><td>4.06</td><td>1.25</td><td>2.64</td><td>2.58</td><td>3.19</td><td>2.39</td>"));
}

TEST(HtmlReport, HasWelchsTestsWithTheirAdjustedP) {
  const auto page = asHtml({tests::madeUpSection()});
  // study_golden.txt: t 4.34, df 62.52, p 5.3e-5; 2.71, 63.80, .0087, adjusted .026; 1.50, 69.90,
  // .139.
  EXPECT_TRUE(has(
      page, "<td>4.34</td><td>62.52</td><td>&lt; .001</td><td><strong>&lt; .001</strong></td>"));
  EXPECT_TRUE(has(page, "<td>2.71</td><td>63.80</td><td>.009</td><td><strong>.026</strong></td>"));
  EXPECT_TRUE(has(page, "<td>1.50</td><td>69.90</td><td>.139</td><td>.418</td>"));
}

TEST(HtmlReport, GivesTheReasonOfAnUndefinedTestAndPrintsNoNan) {
  const auto page = asHtml({tests::madeUpSection()});
  EXPECT_TRUE(has(page, "not defined: "));
  EXPECT_FALSE(has(page, "nan"));
  EXPECT_FALSE(has(page, ">inf"));
}

TEST(HtmlReport, SaysBesidePooledTestsThatAnswersOfOnePersonAreNotIndependent) {
  const std::string sentence = "these tests take all answers of a person as independent";
  auto section = tests::madeUpSection();
  EXPECT_TRUE(has(asHtml({section}), sentence));
  for (auto& family : section.results.families) {
    for (auto& cohort : family.cohorts) cohort.flags.clear();
  }
  EXPECT_FALSE(has(asHtml({section}), sentence));
}

TEST(HtmlReport, SeparatesVotesBetweenDifferentRenderings) {
  auto section = tests::madeUpSection();
  analysis::VoteCounts others({"kalman", "interpolation"});
  others.add("interpolation", 3);
  section.results.votes.push_back(
      {.cohort = "professional", .phase = "preference-2", .block = "round-2", .votes = others});
  const auto page = asHtml({section});
  EXPECT_TRUE(has(page, ">After</th><th>Interpolation</th><th>FEM</th><th>KF</th>"));
  EXPECT_TRUE(has(page, ">After</th><th>KF</th><th>Interpolation</th>"));
  EXPECT_TRUE(has(page, ">round 2 (also seen)</td><td>0</td><td>3</td>"));
}

// TABLE 4 of the punch paper, row by row.
TEST(HtmlReport, HasTheParticipantFlowAndTheDifferencesOfEachSite) {
  const auto page = asHtml({tests::madeUpSectionOfSites()});
  EXPECT_TRUE(has(page, "<td>oslo</td><td>6</td><td>5</td><td>1</td>"));
  EXPECT_TRUE(has(page, ", oslo</td>"));  // among the means
  EXPECT_TRUE(has(page, "Heterogeneity: Q(1) = "));
  EXPECT_TRUE(has(page, "All sites, random effects (REML, Knapp–Hartung)"));
  EXPECT_TRUE(has(page, "Mixed model, sites as random effects"));
  EXPECT_FALSE(has(page, "nan"));
  EXPECT_FALSE(has(asHtml({tests::madeUpSection()}), "By site"));
}

TEST(HtmlReport, SumsVotesOverRoundsAndCohorts) {
  const auto page = asHtml({tests::madeUpSection()});
  EXPECT_TRUE(has(page, ">Sum</td><td>7</td><td>0</td><td>4</td>"));
  EXPECT_TRUE(has(page, ">Sum</td><td>4</td><td>1</td><td>5</td>"));
  EXPECT_TRUE(has(page, "<td>Total</td><td class=\"words\"></td><td>11</td><td>1</td><td>9</td>"));
  EXPECT_TRUE(has(page, "Sums count a participant once a round."));
}

TEST(HtmlReport, GivesThePOfChiSquaredWhereVotesAreTooManyToBeCounted) {
  auto section = tests::madeUpSection();
  EXPECT_FALSE(has(preferencesAsHtml(section), "χ²"));
  auto& vote = section.results.votes.front();
  vote.votes.add("kalman", 5000);
  vote.test = analysis::equalSharesTest(vote.votes);
  const auto part = preferencesAsHtml(section);
  EXPECT_TRUE(has(part, "<td>χ²: &lt; .001</td>")) << part;
  EXPECT_TRUE(has(part, "χ²: there are too many votes for an exact p")) << part;
}

TEST(HtmlReport, HasNoSumOfOneRoundAndNoTotalOfOneCohort) {
  auto section = tests::madeUpSection();
  auto& votes = section.results.votes;
  votes.erase(votes.begin() + 1, votes.end());
  const auto page = asHtml({section});
  EXPECT_TRUE(has(page, ">round 1 (felt only)</td>"));
  EXPECT_FALSE(has(page, ">Sum</td>"));
  EXPECT_FALSE(has(page, "<td>Total</td>"));
  EXPECT_FALSE(has(page, "Sums count"));
}

TEST(HtmlReport, NamesNoPerson) {
  const auto section = tests::madeUpSection();
  const auto page = asHtml({section});
  const auto& people = section.results.families.front().cohorts.front().table.participants;
  ASSERT_EQ(people.size(), 6U);
  for (const auto& person : people) EXPECT_FALSE(has(page, person)) << person;
}

TEST(HtmlReport, PrintsTheNameOfACorrectionAsASubscript) {
  auto section = tests::madeUpSection();
  section.results.families.front().family.test = protocols::TestType::PairedT;
  const auto page = asHtml({section});
  EXPECT_TRUE(has(page, "p<sub>Bonferroni</sub>"));
  EXPECT_TRUE(has(page, "<th>g<sub>z</sub></th>"));
  EXPECT_FALSE(has(page, "p_Bonferroni"));
}

/// The page before its appendix.
std::string mainPart(const std::string& page) {
  return page.substr(0, page.find("<h2 class=\"appendix\">"));
}

TEST(HtmlReport, AnswersBeforeItsAppendix) {
  const auto main = mainPart(asHtml({tests::madeUpSection()}));
  EXPECT_TRUE(has(main, "“Realism of the three methods”: Interpolation, FEM and KF are compared."));
  EXPECT_TRUE(has(main, "Compared are the answers to 9 questions ("));
  EXPECT_LT(main.find("What weakens the answer"), main.find("Declared: "));
  EXPECT_TRUE(has(main, "<td>Orthopaedic surgeons</td><td>7</td><td>6</td><td>1</td>"));
  EXPECT_FALSE(has(main, "<th>Rejected</th>")) << "nobody was";
  // study_golden.txt: 1.42 [0.76, 2.07], p < .001; 0.86 [0.23, 1.50], adjusted .026; KF 0.56 more
  // than FEM [-0.19, 1.30], adjusted .418. Means of 36 answers: 146, 95 and 115 points.
  EXPECT_TRUE(
      has(main, "Interpolation was rated 1.42 points higher than FEM (95 % CI [0.76, 2.07], "));
  EXPECT_TRUE(has(main, "p<sub>Bonferroni</sub> = .026; within people 0.86, 95 % CI ["));
  EXPECT_FALSE(has(main, "KF was rated 0.56 points higher than FEM")) << "the table has it";
  EXPECT_TRUE(has(main, "<td>Interpolation (4.06) vs. FEM (2.64)</td><td>1.42</td>"));
  EXPECT_TRUE(has(main, "What weakens the answer"));
  EXPECT_FALSE(has(main, "–</td>")) << "a cell without a number";
}

TEST(HtmlReport, BeginsWithAPlainSentence) {
  auto section = tests::madeUpSection();
  auto main = mainPart(asHtml({section}));
  const auto verdict = main.find("<p class=\"verdict\">");
  ASSERT_NE(verdict, std::string::npos);
  EXPECT_LT(verdict, main.find("The question"));
  EXPECT_TRUE(
      has(main,
          ">By the declared test (Welch’s t-test of all answers, pooled), Interpolation was rated "
          "significantly higher than FEM (finite elements) and KF (Kalman filter). Compared within "
          "people (paired t-test of participants’ means, exploratory), this holds for FEM and KF. "
          "Interpolation was named most often: 11 of 21 votes (in 2 rounds; exploratory; not "
          "significant in any cohort).</p>\n<p>The votes answer “"))
      << main.substr(verdict, 600);
  EXPECT_FALSE(has(main, "preferred"));
  section.results.votes.clear();
  EXPECT_FALSE(has(asHtml({section}), "most often"));
  section.results.families.front().isDeclared = false;
  EXPECT_TRUE(
      has(asHtml({section}),
          ">On average Interpolation was rated highest (11 participants). All comparisons are "
          "exploratory.</p>"));
}

TEST(HtmlReport, CountsVotesAsPeopleTimesRoundsAndNamesNoneOfSeveral) {
  auto section = tests::madeUpSection();
  analysis::VoteCounts votes({"interpolation", "finite-elements"});
  votes.add("interpolation", 6);
  votes.add("finite-elements", 5);
  section.results.votes = {
      {.cohort = "professional", .phase = "preference-1", .block = "round-1", .votes = votes},
      {.cohort = "professional", .phase = "preference-2", .block = "round-2", .votes = votes}};
  EXPECT_TRUE(
      has(asHtml({section}),
          "Interpolation was named most often: 12 of 22 votes (11 people × 2 rounds; "
          "exploratory)."));
  section.results.votes.pop_back();
  EXPECT_TRUE(has(asHtml({section}), "6 of 11 votes (one vote each; exploratory)."));
  section.results.votes.front().votes.add("finite-elements", 1);
  EXPECT_FALSE(has(asHtml({section}), " votes (")) << "two were named equally often";
}

TEST(HtmlReport, HasPooledTestsAndTheirFlagsOnlyWhereTheyAreDeclared) {
  auto section = tests::madeUpSection();
  EXPECT_TRUE(has(asHtml({section}), "108 answers of 6 people are treated as 108 independent"));
  section.results.families.front().family.test = protocols::TestType::PairedT;
  const auto page = asHtml({section});
  EXPECT_FALSE(has(page, "independent observations"));
  EXPECT_FALSE(has(page, "Welch’s t-tests"));
}

TEST(HtmlReport, HasNoIdsAndNoPlacesInFiles) {
  auto section = tests::madeUpSection();
  section.warnings.push_back(
      {.path = "$.conditions[2].scene",
       .what = protocols::message("blocks_tell", "kalman"),
       .fix = {}});
  const auto page = asHtml({section});
  EXPECT_TRUE(has(page, "<li>no other condition is felt in the same blocks as ‘KF’")) << page;
  EXPECT_TRUE(has(page, "round 1 (felt only): everybody feels this block in the same order"));
  for (const auto* id :
       {"$.", "kalman", "finite-elements", "round-1", "atinSquare", "professional<"}) {
    EXPECT_FALSE(has(page, id)) << id;
  }
}

TEST(HtmlReport, FoldsItsAppendix) {
  const auto page = asHtml({tests::madeUpSection()});
  EXPECT_TRUE(has(page, "<details><summary><h3>Preferences</h3></summary>"));
  EXPECT_TRUE(has(page, "<details><summary><h3>Methods</h3></summary>"));
  EXPECT_FALSE(has(mainPart(page), "<details>"));
}

TEST(HtmlReport, ShowsNoBlankOfALaboratory) {
  auto section = tests::madeUpSection();
  for (auto& phase : section.protocol.phases) {
    phase.text = protocols::LocalizedText(
        std::map<std::string, std::string>{{"en", "Ask [[name]] for the punch."}});
  }
  const auto page = asHtml({section});
  EXPECT_FALSE(has(page, "[["));
  EXPECT_FALSE(has(page, "blank"));
}

TEST(HtmlReport, HasNoNumbersOfCohortsThatHaveNotAnswered) {
  auto section = tests::madeUpSection();
  auto& cohorts = section.results.families.front().cohorts;
  cohorts[1] = {.cohort = cohorts[1].cohort};
  const auto page = asHtml({section});
  EXPECT_FALSE(has(page, "<em>Non-professionals</em></td>"));
  cohorts[0] = {.cohort = cohorts[0].cohort};
  const auto empty = asHtml({section});
  EXPECT_TRUE(has(empty, "Nothing can be compared yet"));
  EXPECT_TRUE(has(empty, "Nobody has answered yet."));
}

TEST(Numbering, CountsOverStudiesAndFillsInReferences) {
  Numbering numbering;
  const words::Words words;
  const auto first = numbering.numbered(
      "<a href=\"#b\"></a><table><caption>A</caption></table><table><caption "
      "id=\"b\">B</caption></table>",
      words);
  EXPECT_EQ(
      first,
      "<a href=\"#table-2\">Table 2</a><table id=\"table-1\"><caption><b>Table 1.</b> "
      "A</caption></table><table id=\"table-2\"><caption><b>Table 2.</b> B</caption></table>");
  EXPECT_EQ(
      numbering.numbered(
          "<figure><figcaption id=\"b\">C</figcaption></figure><a href=\"#b\"></a>", words),
      "<figure id=\"figure-1\"><figcaption><b>Figure 1.</b> C</figcaption></figure><a "
      "href=\"#figure-1\">Figure 1</a>");
  EXPECT_THROW(numbering.numbered("<a href=\"#none\"></a>", words), std::logic_error);
}

TEST(Numbering, CountsTablesAndFiguresOfTheAppendixByThemselves) {
  Numbering numbering;
  const words::Words words;
  const std::string page =
      "<table><caption>A</caption></table><h2 class=\"appendix\"></h2><table><caption "
      "id=\"b\">B</caption></table><a href=\"#b\"></a>";
  EXPECT_TRUE(has(numbering.numbered(page, words), "<a href=\"#table-A1\">Table A1</a>"));
  const auto second = numbering.numbered(page, words);
  EXPECT_TRUE(has(second, "<b>Table 2.</b> A"));
  EXPECT_TRUE(has(second, "<b>Table A2.</b> B"));
}

TEST(HtmlReport, RefersToEveryTableOfTheAppendix) {
  const auto page = asHtml({tests::madeUpSection()});
  int last = 0;
  while (has(page, "id=\"table-A" + std::to_string(last + 1) + "\"")) ++last;
  EXPECT_GT(last, 3);
  // A part refers to its first and its last table, and the next part goes on from there.
  int referred = 0;
  for (int i = 1; i <= last; ++i) {
    const auto name = "\">Table A" + std::to_string(i) + "</a>";
    if (!has(page, name)) continue;
    const bool beginsRange = has(page, name + " to <a href=\"#table-A");
    EXPECT_TRUE(beginsRange || i == referred + 1 || referred > 0) << i;
    referred = i;
  }
  EXPECT_EQ(referred, last);
}

TEST(PrintHtml, UnfoldsTheAppendixOnAPageOfItsOwn) {
  const auto page = toPrintHtml(
      "<h2 class=\"appendix\">Appendix</h2><details><summary><h3>A</h3></summary>see <a "
      "href=\"#table-1\">Table 1</a></details><table id=\"table-1\"><caption><b>Table 1.</b> "
      "W</caption><thead><tr><th>A</th></tr></thead></table>");
  EXPECT_TRUE(
      has(page.html, "<h2 style=\"page-break-before: always\">Appendix</h2><h3>A</h3>see Table 1"));
  EXPECT_TRUE(has(page.html, "<b>Table 1.</b> W</td>"));
}

TEST(PrintHtml, MovesCaptionsIntoTableHeadsAndExtractsFigures) {
  const auto page = toPrintHtml(
      "<style>x</style><table><caption>What</caption><thead><tr><th>A</th><th>B</th><th "
      "colspan=\"2\">C</th></tr></thead></table>"
      "<figure><svg a></svg><figcaption>Words</figcaption></figure>");
  EXPECT_EQ(page.figures, std::vector<std::string>{"<svg a></svg>"});
  EXPECT_TRUE(
      has(page.html, "<td class=\"caption\" colspan=\"4\" align=\"left\">What</td></tr><tr><th"));
  EXPECT_TRUE(
      has(page.html,
          "<th align=\"left\" style=\"padding-left: 0px\">A</th><th align=\"right\">B</th>"));
  EXPECT_TRUE(has(page.html, "<img src=\"figure:0\">"));
  EXPECT_FALSE(has(page.html, "<caption>"));
}

TEST(PrintHtml, BreaksNoValueAcrossLines) {
  const auto page = toPrintHtml(
      "<p>t(5) = 2.77, p &lt; .001 [0.07, 1.98], 95 % and 95-%-KI</p>"
      "<code>0123456789abcdef01</code>");
  EXPECT_TRUE(
      has(page.html, "t(5)&nbsp;=&nbsp;2.77, p&nbsp;&lt;&nbsp;.&#8288;001 [0.07,&nbsp;1.98]"))
      << page.html;
  const auto numbers = toPrintHtml("<p>500 N/s, F(3, 9) = 2, 107–128, round 1, (0 to 100)</p>");
  EXPECT_TRUE(
      has(numbers.html,
          "500&nbsp;N/&#8288;s, F(3,&nbsp;9)&nbsp;=&nbsp;2, 107–&#8288;128, round&nbsp;1, "
          "(0&nbsp;to&nbsp;100)"))
      << numbers.html;
  EXPECT_TRUE(has(page.html, "95&nbsp;%"));
  EXPECT_TRUE(has(page.html, "95&#8209;%&#8209;KI"));
  EXPECT_TRUE(has(page.html, "<code>01234567&#8203;89abcdef&#8203;01</code>")) << page.html;
}

TEST(HtmlReport, EscapesTextsOfResearchers) {
  const auto page = asHtml({tests::madeUpSection()});
  EXPECT_FALSE(has(page, "<script>"));
  EXPECT_TRUE(has(page, "Cut &amp; &lt;script&gt;"));
}

TEST(HtmlReport, MarksSimulatedStudiesVisibly) {
  auto section = tests::madeUpSection();
  EXPECT_TRUE(has(asHtml({section}), "Simulated: nobody took part"));
  section.results.runMode = RunMode::Live;
  EXPECT_FALSE(has(asHtml({section}), "nobody took part"));
  section.results.runMode = RunMode::Pilot;
  EXPECT_TRUE(has(asHtml({section}), "not for publication"));
}

TEST(HtmlReport, MarksSyntheticMaterialsVisibly) {
  auto section = tests::madeUpSection();
  section.sources = {
      {.kind = "material",
       .file = "bone.json",
       .title = base::Message::verbatim("Specimen <7>"),
       .origin = {protocols::message("source.test_set", "static")},
       .isSynthetic = true,
       .conditions = {"interpolation", "kalman"}},
      {.kind = "cut",
       .file = "cut.json",
       .title = base::Message::verbatim("A recorded cut"),
       .origin = {protocols::message("source.recorded_in", "punch.txt")},
       .isSynthetic = false,
       .conditions = {"finite-elements"}}};
  const auto page = asHtml({section});
  EXPECT_TRUE(has(page, " SYNTHETIC, neither recorded"));
  EXPECT_EQ(page.find("class=\"banner"), page.rfind("class=\"banner")) << "one banner for both";
  EXPECT_TRUE(has(page, "recorded nor measured: Interpolation and KF (from: Specimen &lt;7&gt;)"))
      << page.substr(page.find("SYNTHETIC"), 300);
  EXPECT_FALSE(has(page, "(from: parameters of the protocol)")) << "all have a source";
  EXPECT_TRUE(has(page, "SYNTHETIC: Specimen &lt;7&gt; (material ‘bone.json’), test set static"));
  EXPECT_TRUE(has(page, "<li>A recorded cut (cut "));
  section.sources[1].conditions.clear();
  EXPECT_TRUE(
      has(asHtml({section}), "Specimen &lt;7&gt;); FEM (from: parameters of the protocol)."));
  section.sources[0].isSynthetic = false;
  EXPECT_FALSE(has(asHtml({section}), "SYNTHETIC"));
}

TEST(HtmlReport, PrintsNoDescriptionAsTheQuestion) {
  auto section = tests::madeUpSection();
  section.protocol.study.description = "How it differs from the published one.";
  EXPECT_FALSE(has(headAsHtml(section), "How it differs"));
  EXPECT_TRUE(has(
      methodsAsHtml(section), "describes the study as: “How it differs from the published one.”"));
}

TEST(HtmlReport, NamesNotesInWords) {
  const auto page = asHtml({tests::madeUpSection()});
  EXPECT_TRUE(has(page, "<dt>Several answers of one person counted as independent</dt>"));
  EXPECT_FALSE(has(page, "pseudo_replication"));
  EXPECT_FALSE(has(page, "docs/"));
}

TEST(HtmlReport, SaysWhichConditionsAskedForTooMuchForce) {
  const auto section = tests::madeUpSection();
  const auto answer = answerAsHtml(section);
  EXPECT_TRUE(has(answer, "<p><strong>In each cohort: In 1 of 9 trials")) << answer;
  EXPECT_TRUE(has(answer, "“Interpolation” in 1 of 3.")) << answer;
  const auto rendering = renderingAsHtml(section);
  EXPECT_TRUE(
      has(rendering, "<td>Interpolation</td><td>3 of 12</td><td>12.5 %</td><td>25.0 %</td>"))
      << rendering;
  EXPECT_TRUE(has(rendering, "2 trials, the first one: ")) << rendering;
}

TEST(HtmlReport, HasTheLandmarksOfEachConditionsCuts) {
  const auto page = renderingAsHtml(tests::madeUpSection());
  EXPECT_TRUE(has(page, "<th>Interpolation [travel units; N]</th>")) << page;
  EXPECT_TRUE(has(page, "<td><i>n</i></td><td>3</td>")) << page;
  EXPECT_TRUE(has(page, "<td>yield</td><td>7.20 (0.28); 4.50 (0.71), <i>n</i> = 2</td>")) << page;
  EXPECT_TRUE(has(page, "<td>largest force</td><td>5.50 (0.50)</td>")) << page;
  EXPECT_TRUE(has(page, "yield: the largest force before it falls")) << page;
  EXPECT_FALSE(has(page, "opening: ")) << "has no row";
}

TEST(HtmlReport, HasNoLandmarkOfFewStrokesOrAtTheOrigin) {
  auto section = tests::madeUpSection();
  const auto page = renderingAsHtml(section);
  EXPECT_FALSE(has(page, "<td>opening</td>")) << "one stroke of three";
  EXPECT_FALSE(has(page, "<td>interception</td>")) << "0.00 (0.00); 0.00 (0.00)";
  const std::vector<double> all{7.0, 7.1, 7.2};
  section.landmarks.push_back(
      {"kalman", "opening", analysis::summarise(all), analysis::summarise(all)});
  EXPECT_TRUE(has(renderingAsHtml(section), "<td>opening</td><td><i>n</i> = 1</td><td>7.10 (0.10)"))
      << "where another alternative has it in all strokes";
}

TEST(HtmlReport, HasNoPlaceOfAnOpeningWhereTheForceIsFlat) {
  auto section = tests::madeUpSection();
  const std::vector<double> travels{9.0, 9.5, 9.4};
  const std::vector<double> forces{3.0, 3.001, 2.999};
  section.landmarks = {
      {"interpolation", "opening", analysis::summarise(travels), analysis::summarise(forces)},
      {"interpolation", "largest force", {}, analysis::summarise(forces)}};
  const auto flat = renderingAsHtml(section);
  EXPECT_TRUE(has(flat, "<td>opening</td><td>from 0.0; 3.00 (0.00)</td>")) << flat;
  EXPECT_TRUE(has(flat, "from: the force is flat from there on")) << flat;
  EXPECT_FALSE(has(flat, "<td>largest force</td>")) << "repeats the opening";
  EXPECT_TRUE(has(flat, "less than 0.25 N, or by less than 8 % of the load, counts as no yield."));
  auto& points = section.curves.front().points;
  for (std::size_t i = 0; i < points.size(); ++i) points[i].median = 0.1 * static_cast<double>(i);
  points.back().median = 3.0;
  const auto rising = renderingAsHtml(section);
  EXPECT_TRUE(has(rising, "<td>opening</td><td>9.30 (0.26); 3.00 (0.00)</td>")) << rising;
  EXPECT_FALSE(has(rising, "from: the force")) << rising;
  section.landmarks.back().force = analysis::summarise(travels);
  EXPECT_TRUE(has(renderingAsHtml(section), "<td>largest force</td>"));
  for (auto& point : points) point.median = 3.0;
  points.push_back({12.0, 1.0, 1.0, 1.0});
  points.push_back({13.0, 3.0, 3.0, 3.0});
  EXPECT_FALSE(has(renderingAsHtml(section), "from: the force")) << "flat before it falls";
}

TEST(HtmlReport, SaysWhereAForceFadesBecauseItsCutEnds) {
  auto section = tests::madeUpSection();
  questionnaires::Problems problems;
  section.protocol.conditions =
      protocols::loadProtocolFile("punch-counterbalanced", problems)->protocol.conditions;
  EXPECT_FALSE(has(renderingAsHtml(section), "fades beyond"));
  section.curves.front().points.push_back({14.0, 1.0, 1.0, 1.0});
  EXPECT_TRUE(
      has(renderingAsHtml(section),
          "Interpolation fades beyond 11.0 travel units, where its cut ends."))
      << renderingAsHtml(section);
}

TEST(HtmlReport, ExplainsInACaptionOnlyWhatTheFigureShows) {
  auto section = tests::madeUpSection();
  auto& family = section.results.families.front();
  family.family.equivalenceBound.reset();
  EXPECT_FALSE(has(differencesCaption(family, section.words), "Shaded"));
  EXPECT_TRUE(has(differencesCaption(family, section.words), "95 % interval"));
  family.family.equivalenceBound = 0.5;
  EXPECT_TRUE(has(differencesCaption(family, section.words), "Shaded are differences"));
  section.figures.renderedForce = {"<svg/>"};
  EXPECT_FALSE(has(renderingAsHtml(section), "Dashed"));
  EXPECT_FALSE(has(renderingAsHtml(section), "its hole")) << "no bone is removed";
}

TEST(HtmlReport, IsSelfContained) {
  const auto page = asHtml({tests::madeUpSection()});
  for (const auto* outside : {"http://", "https://", "src=", "<link", "@import", "url("}) {
    EXPECT_FALSE(has(page, outside)) << outside;
  }
}

TEST(HtmlReport, MayContainSeveralStudies) {
  auto other = tests::madeUpSection();
  other.protocol.study.title = "Another study";
  const auto page = asHtml({tests::madeUpSection(), other});
  EXPECT_TRUE(has(page, "<h2>Another study</h2>"));
  EXPECT_TRUE(has(page, "<h2>Cut &amp;"));
}

TEST(HtmlReport, HasTheWarningsOfTheDesign) {
  const auto page = asHtml({tests::madeUpSection()});
  EXPECT_TRUE(has(page, "everybody feels this block in the same order"));
  EXPECT_TRUE(has(page, "3 of 4000 ticks were late"));
}

TEST(HtmlReport, DescribesBenchmarkAndOptionalTrialsInTheMethods) {
  const auto page = asHtml({tests::madeUpSection()});
  EXPECT_TRUE(has(page, "made at least 3 cuts with the real tool."));
  EXPECT_TRUE(has(page, "They read: “Careful: the jaws of the punch are sharp."));
  const auto again = page.find("they could feel each of them once more");
  EXPECT_NE(again, std::string::npos);
  EXPECT_EQ(page.find("they could feel each of them once more", again + 1), std::string::npos)
      << "only before one of both choices";
}

TEST(HtmlReport, NamesFamiliesThatALaterVersionChanged) {
  auto section = tests::madeUpSection();
  const auto page = asHtml({section});
  EXPECT_TRUE(
      has(page,
          "Version 2 (2026-03-01) changed “Realism” after the first participant had begun "
          "(instrument, "));
  EXPECT_TRUE(has(page, "Version 3 (2026-03-02) added “Effort” after"));
  EXPECT_TRUE(has(page, "Version 3 (2026-03-02) dropped “Ease”"));
  EXPECT_TRUE(
      has(page,
          "changed “Fun” after the first participant had begun (alpha); it was put back as it was "
          "declared. "))
      << page;
  EXPECT_TRUE(has(page, "put “Fun” back as it was declared, before anybody had begun with the "));
  EXPECT_TRUE(
      has(page,
          "put “Ease” back as it was declared, but participants had begun with the "
          "change: all of it is exploratory."));
  auto& change = section.history.changes.front();
  change.participants = 4;
  change.before = protocols::Family{.equivalenceBound = 1.0};
  change.after = protocols::Family{.test = protocols::TestType::SignedRank};
  const auto head = headAsHtml(section);
  EXPECT_TRUE(has(head, "Version 2 (2026-03-01, after 4 participants) changed “Realism” after "))
      << head;
  EXPECT_TRUE(
      has(head,
          ", test: before Welch’s t-test of all answers, pooled, now exact signed rank test of "
          "participants’ means, "))
      << head;
  EXPECT_TRUE(has(head, ", equivalence bound: before 1 point, now none): all of it is "));
  section.history = {};
  EXPECT_FALSE(has(asHtml({section}), "versions of the protocol"));
}

TEST(HtmlReport, CallsOnlyTestsConfirmatoryThatWereDeclaredBeforeTheFirstParticipant) {
  auto section = tests::madeUpSection();
  EXPECT_TRUE(has(asHtml({section}), "as the protocol declares. Bold"));
  section.results.families.front().isDeclared = false;
  const auto page = asHtml({section});
  EXPECT_FALSE(has(page, "and confirmatory"));
  EXPECT_TRUE(has(page, "as in the punch paper (exploratory)"));
  EXPECT_TRUE(has(page, "all is exploratory"));
}

TEST(HtmlReport, ComparesRenderedBoneWithItsMaterial) {
  auto section = tests::madeUpSection();
  EXPECT_FALSE(has(asHtml({section}), "Felt against the material"));
  auto& curve = section.curves.front();
  for (const auto& point : curve.points) curve.intended.push_back(point.median + 3.0);
  EXPECT_NEAR(*rmsFromIntended(curve), 3.0, 1e-12);
  const auto page = asHtml({section});
  EXPECT_TRUE(has(page, "Felt against the material"));
  EXPECT_TRUE(has(page, "force: Interpolation 3.00 N."));
  EXPECT_FALSE(has(page, "The reamer advances"));
}

TEST(HtmlReport, SaysWhereHandsPushedAgainstTheLimitOfTheFeed) {
  auto section = tests::madeUpSection();
  auto& curve = section.curves.front();
  curve.mostFeed = 0.002;
  for (const auto& point : curve.points) curve.intended.push_back(point.median);
  auto& limited = curve.points.at(1);
  limited.atMostFeed = 0.51;
  curve.intended.at(1) -= 2.5;
  limited.bin = 1;
  const auto from = fmt::format("{:.1f}", limited.travel * 2.0 / 3.0);
  const auto to = fmt::format("{:.1f}", limited.travel * 4.0 / 3.0);
  const auto page = renderingAsHtml(section);
  EXPECT_TRUE(
      has(page,
          "The reamer advances by at most 0.002 " +
              std::string(section.protocol.device(curve.device)->kind->shown.velocityUnit) + ": "))
      << page;
  EXPECT_TRUE(has(page, "Interpolation up to 2.5 N (" + from + " to " + to)) << page;
  limited.atMostFeed = 0.5;
  EXPECT_FALSE(has(renderingAsHtml(section), "The reamer advances"));
}

}  // namespace html_report_test
}  // namespace study::report

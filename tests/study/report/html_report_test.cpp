#include "study/report/html_report.h"

#include <gtest/gtest.h>

#include "protocols/model/messages.h"
#include "study/report/print_html.h"
#include "tests/study/report/section.h"

namespace study::report {
namespace html_report_test {

bool has(const std::string& page, const std::string& words) {
  return page.find(words) != std::string::npos;
}

TEST(HtmlReport, HasTheMeansAndVariancesOfThePapersTable) {
  const auto page = asHtml({tests::madeUpSection()});
  // The counts of the synthetic study, which round to the paper's Table 2.
  EXPECT_TRUE(has(page, "<td>4.1</td><td>1.3</td><td>36</td>"));
  EXPECT_TRUE(has(page, "<td>2.6</td><td>2.6</td><td>36</td>"));
  EXPECT_TRUE(has(page, "<td>3.2</td><td>2.4</td><td>36</td>"));
}

TEST(HtmlReport, HasWelchsTestsWithTheirAdjustedP) {
  const auto page = asHtml({tests::madeUpSection()});
  // study_golden.txt: t 4.34, df 62.52, p 5.3e-5; 2.71, 63.80, .0087, adjusted .026; 1.50, 69.90,
  // .139.
  EXPECT_TRUE(has(page, "<td>4.34</td><td>62.52</td><td>&lt; .001</td><td>&lt; .001</td>"));
  EXPECT_TRUE(has(page, "<td>2.71</td><td>63.80</td><td>.009</td><td>.026</td>"));
  EXPECT_TRUE(has(page, "<td>1.50</td><td>69.90</td><td>.139</td><td>.418</td>"));
}

TEST(HtmlReport, GivesTheReasonOfAnUndefinedTestAndPrintsNoNan) {
  const auto page = asHtml({tests::madeUpSection()});
  EXPECT_TRUE(has(page, "not defined: "));
  EXPECT_FALSE(has(page, "nan"));
  EXPECT_FALSE(has(page, ">inf"));
}

TEST(HtmlReport, SeparatesVotesBetweenDifferentRenderings) {
  auto section = tests::madeUpSection();
  analysis::VoteCounts others({"kalman", "interpolation"});
  others.add("interpolation", 3);
  section.results.votes.push_back({"professional", "preference-2", "round-2", others, {}, {}});
  const auto page = asHtml({section});
  EXPECT_TRUE(has(page, "<th>After</th><th>Interpolation</th><th>FEM</th><th>KF</th>"));
  EXPECT_TRUE(has(page, "<th>After</th><th>KF</th><th>Interpolation</th>"));
  EXPECT_TRUE(has(page, "<td>round-2</td><td>0</td><td>3</td>"));
}

// TABLE 4 of the punch paper, row by row.
TEST(HtmlReport, SumsVotesOverRoundsAndCohorts) {
  const auto page = asHtml({tests::madeUpSection()});
  EXPECT_TRUE(has(page, "<td>Sum</td><td>7</td><td>0</td><td>4</td>"));
  EXPECT_TRUE(has(page, "<td>Sum</td><td>4</td><td>1</td><td>5</td>"));
  EXPECT_TRUE(has(page, "<td>Total</td><td></td><td>11</td><td>1</td><td>9</td>"));
  EXPECT_TRUE(has(page, "Sums count a participant once a round."));
}

TEST(HtmlReport, HasNoSumOfOneRoundAndNoTotalOfOneCohort) {
  auto section = tests::madeUpSection();
  auto& votes = section.results.votes;
  votes.erase(votes.begin() + 1, votes.end());
  const auto page = asHtml({section});
  EXPECT_TRUE(has(page, "<td>round-1</td>"));
  EXPECT_FALSE(has(page, "<td>Sum</td>"));
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
  const auto page = asHtml({tests::madeUpSection()});
  EXPECT_TRUE(has(page, "p<sub>Bonferroni</sub>"));
  EXPECT_TRUE(has(page, "g<sub>z</sub> = "));
  EXPECT_FALSE(has(page, "p_Bonferroni"));
}

TEST(PrintHtml, MovesCaptionsIntoTableHeadsAndExtractsFigures) {
  const auto page = forPrint(
      "<style>x</style><table><caption>What</caption><thead><tr><th>A</th><th>B</th><th "
      "colspan=\"2\">C</th></tr></thead></table>"
      "<figure><svg a></svg><figcaption>Words</figcaption></figure>");
  EXPECT_EQ(page.figures, std::vector<std::string>{"<svg a></svg>"});
  EXPECT_TRUE(
      has(page.html, "<td class=\"caption\" colspan=\"4\" align=\"left\">What</td></tr><tr><th"));
  EXPECT_TRUE(has(page.html, "<th align=\"left\">A</th><th align=\"right\">B</th>"));
  EXPECT_TRUE(has(page.html, "<img src=\"figure:0\">"));
  EXPECT_FALSE(has(page.html, "<caption>"));
}

TEST(PrintHtml, BreaksNoValueAcrossLines) {
  const auto page = forPrint(
      "<p>t(5) = 2.77, p &lt; .001 [0.07, 1.98], 95 % and 95-%-KI</p>"
      "<code>0123456789abcdef01</code>");
  EXPECT_TRUE(
      has(page.html, "t(5)&nbsp;=&nbsp;2.77, p&nbsp;&lt;&nbsp;.&#8288;001 [0.07,&nbsp;1.98]"))
      << page.html;
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
  EXPECT_TRUE(has(page, "<p class=\"banner\">SYNTHETIC"));
  EXPECT_TRUE(has(page, "SYNTHETIC: Specimen &lt;7&gt; (material 'bone.json'), test set static"));
  EXPECT_TRUE(has(page, "<li>A recorded cut (cut "));
  section.sources[0].isSynthetic = false;
  EXPECT_FALSE(has(asHtml({section}), "SYNTHETIC"));
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
  EXPECT_TRUE(has(page, "made at least 3 cuts with the real tool (benchmark)."));
  EXPECT_TRUE(has(page, "They read: “Please take the real punch"));
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
  section.history = {};
  EXPECT_FALSE(has(asHtml({section}), "versions of the protocol"));
}

TEST(HtmlReport, CallsOnlyTestsConfirmatoryThatWereDeclaredBeforeTheFirstParticipant) {
  auto section = tests::madeUpSection();
  EXPECT_TRUE(has(asHtml({section}), "declared in the protocol: confirmatory"));
  section.results.families.front().isDeclared = false;
  const auto page = asHtml({section});
  EXPECT_FALSE(has(page, "confirmatory"));
  EXPECT_TRUE(has(page, "Profile as-published (exploratory)"));
  EXPECT_TRUE(has(page, "all is exploratory"));
}

TEST(HtmlReport, ComparesRenderedBoneWithItsMaterial) {
  auto section = tests::madeUpSection();
  EXPECT_FALSE(has(asHtml({section}), "Felt against the material"));
  auto& curve = section.curves.front();
  for (const auto& point : curve.points) curve.meant.push_back(point.median + 3.0);
  EXPECT_NEAR(*rmsFromMeant(curve), 3.0, 1e-12);
  const auto page = asHtml({section});
  EXPECT_TRUE(has(page, "Felt against the material"));
  EXPECT_TRUE(has(page, "<td>3.00</td>"));
}

}  // namespace html_report_test
}  // namespace study::report

#include "study/report/html_report.h"

#include <gtest/gtest.h>

#include "tests/study/report/section.h"

namespace study::report {
namespace {

bool has(const std::string& page, const std::string& words) {
  return page.find(words) != std::string::npos;
}

TEST(HtmlReport, HasTheMeansAndVariancesOfThePapersTable) {
  const auto page = asHtml({tests::madeUpSection()});
  // The counts are those of the synthetic study, which round to the paper's Table 2.
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

TEST(HtmlReport, SaysWhyATestIsNotDefinedAndPrintsNoNan) {
  const auto page = asHtml({tests::madeUpSection()});
  EXPECT_TRUE(has(page, "not defined: "));
  EXPECT_FALSE(has(page, "nan"));
  EXPECT_FALSE(has(page, ">inf"));
}

TEST(HtmlReport, EscapesWhatResearchersWrote) {
  const auto page = asHtml({tests::madeUpSection()});
  EXPECT_FALSE(has(page, "<script>"));
  EXPECT_TRUE(has(page, "Cut &amp; &lt;script&gt;"));
}

TEST(HtmlReport, SaysInPlainSightThatNobodyTookPart) {
  auto section = tests::madeUpSection();
  EXPECT_TRUE(has(asHtml({section}), "Simulated: nobody took part"));
  section.results.runMode = RunMode::Live;
  EXPECT_FALSE(has(asHtml({section}), "nobody took part"));
  section.results.runMode = RunMode::Pilot;
  EXPECT_TRUE(has(asHtml({section}), "not for publication"));
}

TEST(HtmlReport, NeedsNothingBesideItself) {
  const auto page = asHtml({tests::madeUpSection()});
  for (const auto* outside : {"http://", "https://", "src=", "<link", "@import", "url("}) {
    EXPECT_FALSE(has(page, outside)) << outside;
  }
}

TEST(HtmlReport, HoldsSeveralStudies) {
  auto other = tests::madeUpSection();
  other.protocol.study.title = "Another study";
  const auto page = asHtml({tests::madeUpSection(), other});
  EXPECT_TRUE(has(page, "<h2>Another study</h2>"));
  EXPECT_TRUE(has(page, "<h2>Cut &amp;"));
}

TEST(HtmlReport, TellsWhatTheDesignLeavesOpen) {
  const auto page = asHtml({tests::madeUpSection()});
  EXPECT_TRUE(has(page, "everybody feels this block in the same order"));
  EXPECT_TRUE(has(page, "3 of 4000 ticks were late"));
}

TEST(HtmlReport, HoldsFeltBoneAgainstItsMaterial) {
  auto section = tests::madeUpSection();
  EXPECT_FALSE(has(asHtml({section}), "Felt against the material"));
  auto& curve = section.curves.front();
  for (const auto& point : curve.points) curve.meant.push_back(point.median + 3.0);
  EXPECT_NEAR(*rmsFromMeant(curve), 3.0, 1e-12);
  const auto page = asHtml({section});
  EXPECT_TRUE(has(page, "Felt against the material"));
  EXPECT_TRUE(has(page, "<td>3.00</td>"));
}

}  // namespace
}  // namespace study::report

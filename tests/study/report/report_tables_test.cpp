// Every table of a report, by caption and column headings: each number is in its place.
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/data/reason.h"
#include "study/report/html_report.h"
#include "study/results/results_text.h"
#include "tests/study/made_study.h"
#include "tests/study/report/numbered_section.h"
#include "tests/study/report/section.h"

namespace study::report {
namespace report_tables_test {

using Cells = std::vector<std::string>;
using Row = std::map<std::string, std::string>;

/// Text as it is displayed: without elements, and with characters for entities.
std::string asRead(const std::string& html) {
  std::string text;
  bool isElement = false;
  for (const char c : html) {
    if (c == '<') isElement = true;
    if (!isElement) text += c;
    if (c == '>') isElement = false;
  }
  const std::vector<std::pair<std::string, std::string>> entities{
      {"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&#39;", "'"}, {"&amp;", "&"}};
  for (const auto& [entity, character] : entities) {
    for (auto at = text.find(entity); at != std::string::npos; at = text.find(entity, at + 1)) {
      text.replace(at, entity.size(), character);
    }
  }
  return text;
}

/// The content of each element of a kind within @p html.
Cells elements(const std::string& html, const std::string& kind) {
  Cells found;
  std::size_t at = 0;
  while ((at = html.find("<" + kind, at)) != std::string::npos) {
    const auto next = html[at + 1 + kind.size()];
    const auto begin = html.find('>', at) + 1;
    at = begin;
    if (next != '>' && next != ' ') continue;  // <thead> is no <th>
    found.push_back(html.substr(begin, html.find("</" + kind + ">", begin) - begin));
  }
  return found;
}

struct Table {
  std::string caption;
  Cells headings;
  std::vector<Cells> rows;

  /// The rows that have a cell for every heading, by heading.
  std::vector<Row> byHeading() const {
    std::vector<Row> all;
    for (const auto& cells : rows) {
      if (cells.size() != headings.size()) continue;
      auto& row = all.emplace_back();
      for (std::size_t i = 0; i < cells.size(); ++i) row[headings[i]] = cells[i];
    }
    return all;
  }
};

/// A caption without "Table 3. ".
std::string withoutNumber(const std::string& caption) {
  EXPECT_TRUE(caption.starts_with("Table ")) << caption;
  return caption.substr(caption.find(". ") + 2);
}

/// The only table of @p page whose caption begins with @p caption.
Table tableOf(const std::string& page, const std::string& caption) {
  std::vector<Table> found;
  for (const auto& html : elements(page, "table")) {
    Table table{.caption = withoutNumber(asRead(elements(html, "caption").at(0)))};
    if (!table.caption.starts_with(caption)) continue;
    for (const auto& head : elements(html, "th")) table.headings.push_back(asRead(head));
    for (const auto& line : elements(html.substr(html.find("<tbody>")), "tr")) {
      auto& cells = table.rows.emplace_back();
      for (const auto& cell : elements(line, "td")) cells.push_back(asRead(cell));
    }
    found.push_back(std::move(table));
  }
  if (found.size() != 1) {
    throw std::runtime_error(std::to_string(found.size()) + " tables begin with: " + caption);
  }
  return found.front();
}

/// A page with a different number in every place.
class ReportTables : public testing::Test {
 protected:
  /// The only row of the table with that caption.
  Row row(const std::string& caption) const {
    const auto rows = tableOf(page_, caption).byHeading();
    if (rows.size() != 1) throw std::runtime_error(std::to_string(rows.size()) + " rows");
    return rows.front();
  }

  void expectSaid(const std::string& words) const {
    EXPECT_NE(text_.find(words), std::string::npos) << words;
  }

  ReportSection section_ = tests::numberedSection();
  std::string page_ = asHtml({section_});
  std::string text_ = asRead(page_);
};

TEST_F(ReportTables, OfParticipantsHasEachEndInItsColumn) {
  const Row expected{
      {"Cohort", "Orthopaedic surgeons"},
      {"Enrolled", "11"},
      {"Completed", "12"},
      {"In progress", "13"},
      {"Declined", "14"},
      {"Withdrawn", "15"},
      {"Rejected", "16"},
      {"Device failed", "17"},
      {"Erased", "18"}};
  EXPECT_EQ(row("Who took part"), expected);
}

TEST_F(ReportTables, OfTheAnswerHasTheDeclaredTestWithTheDifferenceWithinPeople) {
  const Row expected{
      {"Comparison", "Interpolation (4.00) vs. FEM (1.67)"},
      {"Difference", "3.02"},
      {"99 % CI", "[3.08, 3.09]"},
      {"gz", "3.16"},
      {"pHolm", ".343"}};
  EXPECT_EQ(row("Declared: "), expected);
  expectSaid(
      "on average; Interpolation was rated 3.02 points higher than FEM (99 % CI [3.08, 3.09], "
      "pHolm = .343; TOST p = .327)");
}

TEST_F(ReportTables, OfMeansHasMeanVarianceAndCountOfEachCondition) {
  const auto table = tableOf(page_, "Mean M and variance s²");
  EXPECT_EQ(
      table.headings, (Cells{"", "Interpolation", "FEM", "", "M", "s²", "n", "M", "s²", "n"}));
  ASSERT_EQ(table.rows.size(), 1U);
  EXPECT_EQ(
      table.rows[0], (Cells{"Orthopaedic surgeons", "4.00", "2.40", "6", "1.67", "0.33", "3"}));
}

TEST_F(ReportTables, OfMeansHasOneCountWhereAllOfARowAreTheSame) {
  auto& conditions = section_.results.families.front().cohorts.front().conditions;
  conditions[1].answers = conditions[0].answers;
  const auto table = tableOf(asHtml({section_}), "Mean M and variance s²");
  EXPECT_EQ(table.headings, (Cells{"", "", "Interpolation", "FEM", "", "n", "M", "s²", "M", "s²"}));
  EXPECT_EQ(table.rows[0], (Cells{"Orthopaedic surgeons", "6", "4.00", "2.40", "4.00", "2.40"}));
}

TEST_F(ReportTables, NameTheScaleOfTheirMeans) {
  const auto page = asHtml({tests::madeUpSection()});
  const std::string scale = "; scale from 1 (strongly disagree) to 5 (strongly agree)</caption>";
  for (const auto* caption : {"Bonferroni correction", "Mean M and variance s² of the n answers"}) {
    EXPECT_NE(page.find(caption + scale), std::string::npos) << caption;
  }
}

TEST_F(ReportTables, OfWelchsTestsHasThePlainIntervalAndBothP) {
  const Row expected{
      {"Comparison", "Interpolation vs. FEM"},
      {"Difference", "2.07"},
      {"99 % CI", "[2.15, 2.16]"},
      {"t", "2.09"},
      {"df", "21.11"},
      {"p", ".212"},
      {"pHolm", ".214"}};
  section_.results.families.front().family.test = protocols::TestType::Welch;
  const auto table = tableOf(asHtml({section_}), "Welch’s t-tests with Holm correction, α = 0.01");
  EXPECT_EQ(table.byHeading(), std::vector{expected});
  EXPECT_EQ(table.rows[0], Cells{"Orthopaedic surgeons, α per test 0.0025"});
}

TEST_F(ReportTables, OfDifferencesHasWhatTheTableOfTheAnswerHasNot) {
  const auto table = tableOf(page_, "Differences of participants’ means");
  EXPECT_EQ(
      table.headings,
      (Cells{"Comparison", "t", "df", "gz", "99 % CI", "BF10", "Odds ratio", "99 % CI"}));
  EXPECT_EQ(table.rows[0], Cells{"Orthopaedic surgeons, 301 participants"});
  // exp(1 ± 2.5758 · 0.1)
  EXPECT_EQ(
      table.rows[1],
      (Cells{
          "Interpolation vs. FEM",
          "3.05",
          "36",
          "3.16",
          "[3.17, 3.18]",
          "3.25",
          "2.72",
          "[2.10, 3.52]"}));
}

TEST_F(ReportTables, OfDifferencesHasThemWherePooledTestsAreDeclared) {
  section_.results.families.front().family.test = protocols::TestType::Welch;
  const auto table = tableOf(asHtml({section_}), "Differences of participants’ means");
  EXPECT_EQ(table.headings[1], "Difference");
  EXPECT_EQ(table.rows[1][1], "3.02");
  EXPECT_EQ(table.rows[1][2], "[3.08, 3.09]");
}

TEST_F(ReportTables, OfTestsWithinPeopleHasEachTestInItsColumn) {
  const Row expected{
      {"Comparison", "Interpolation vs. FEM"},
      {"Paired t", ".307 (.341)"},
      {"Sign flip", ".319 (.342)"},
      {"Signed rank *", ".321 (.343)"},
      {"Mixed model", ".333 (.344)"},
      {"Ordinal model", ".335 (.345)"},
      {"Equivalence", ".327"}};
  EXPECT_EQ(
      row("Tests of these differences: p, and in brackets p after Holm correction"), expected);
  EXPECT_NE(page_.find("<strong>.321 (.343)</strong>"), std::string::npos)
      << "the declared test is significant";
}

TEST_F(ReportTables, BetweenCohortsHasEachTestInItsColumn) {
  const Row expected{
      {"Method", "FEM"},
      {"U", "703.5"},
      {"exact p", ".704"},
      {"Brunner–Munzel p", ".708"},
      {"Cliff’s δ", "0.71"},
      {"95 % CI", "[0.73, 0.74]"}};
  EXPECT_EQ(row("Between cohorts, on participants’ means"), expected);
}

TEST_F(ReportTables, SayWhatANegativeAlphaMeansWhereverItStands) {
  auto& alpha = section_.results.families.front().cohorts.front().checks.methods.front().alpha;
  alpha.value = -0.64;
  alpha.reason = analysis::reason("negative_alpha");
  const auto text = asRead(asHtml({section_}));
  const std::string caution =
      "α is negative: the statements do not measure one thing, or some are keyed the other way.";
  EXPECT_NE(text.find("−0.64 ‡"), std::string::npos);
  EXPECT_NE(text.find("‡: " + caution), std::string::npos) << "below the table";
  EXPECT_NE(text.find("participants each; "), std::string::npos);
  EXPECT_NE(text.find(". " + caution), std::string::npos) << "among the evidence of validity";
}

TEST_F(ReportTables, OfTheScaleHasReliabilityInItsColumns) {
  const Row expected{
      {"Method", "Interpolation"},
      {"Statements", "52"},
      {"Cronbach’s α", "0.53"},
      {"95 % CI", "[0.54, 0.55]"},
      {"McDonald’s ω", "0.58"}};
  EXPECT_EQ(row("Reliability of the statements"), expected);
}

TEST_F(ReportTables, OfScoresHasMeanDeviationAndIntervalInTheirColumns) {
  const Row expected{
      {"Score", "Total"},
      {"About", "KF"},
      {"Orthopaedic surgeons, n = 3", "9.02 (9.03) [9.04, 9.05], 91 without a score"}};
  EXPECT_EQ(row("Scores of participants"), expected);
}

TEST_F(ReportTables, OfAcceptabilityHasThresholdShareAndInterval) {
  const Row expected{
      {"Statement", "It was easy."},
      {"Cohort", "Orthopaedic surgeons"},
      {"About", "KF"},
      {"From", "9.5"},
      {"n", "97"},
      {"Acceptable", "21 %"},
      {"95 % CI", "[22 %, 23 %]"}};
  EXPECT_EQ(row("Scored: participants at or above the threshold of acceptability"), expected);
}

TEST_F(ReportTables, OfPreferencesHasVotesAndIntervalsOfEachCondition) {
  const Row expected{
      {"Cohort", "Orthopaedic surgeons"},
      {"After", "round 1 (felt only)"},
      {"Interpolation", "81 [11 %, 12 %]"},
      {"FEM", "82 [13 %, 14 %]"},
      {"KF", "83 [15 %, 16 %]"},
      {"exact p", ".804"}};
  EXPECT_EQ(row("How many participants named each method"), expected);
}

// R: t.test(c(1, 2, 4.5)): mean 2.5, interval -1.98 6.98
TEST_F(ReportTables, OfForcesHasThePooledAndTheMeanDifference) {
  const Row expected{
      {"Pair", "Interpolation vs. FEM"},
      {"All strokes [N]", "3.00"},
      {"n", "3"},
      {"By participant [N]", "2.50"},
      {"95 % CI", "[−1.98, 6.98]"}};
  EXPECT_EQ(row("Manipulation check"), expected);
  expectSaid(
      "Felt against the material, root mean square difference of the median force: Interpolation "
      "1.25 N.");
}

// Python, mean ± 4.3027 stdev/√3: 1.9963 and 2.0037; of 1.9995, 2 and 2.0105 1.9879 and 2.0188
TEST_F(ReportTables, OfForcesHaveNoIntervalOfWhichBothEndsArePrintedAlike) {
  const std::string alike = "both its ends would be printed alike";
  const auto pageOf = [&](const std::vector<double>& differences) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (auto& [bin, force] : section_.curves[0].medians["P" + std::to_string(i)]) {
        force = 4.0 + differences[i];
      }
    }
    return asHtml({section_});
  };
  auto page = pageOf({1.9985, 2.0, 2.0015});
  EXPECT_EQ(tableOf(page, "Manipulation check").headings.back(), "By participant [N]");
  EXPECT_NE(page.find(alike), std::string::npos);
  page = pageOf({1.9995, 2.0, 2.0105});
  EXPECT_EQ(tableOf(page, "Manipulation check").rows.front().back(), "[1.99, 2.02]");
  EXPECT_EQ(page.find(alike), std::string::npos);
}

TEST_F(ReportTables, OfForcesHaveNoSecondColumnOfOneParticipant) {
  for (auto& curve : section_.curves) curve.medians.erase("P1"), curve.medians.erase("P2");
  const auto table = tableOf(asHtml({section_}), "Manipulation check");
  EXPECT_EQ(table.headings, (Cells{"Pair", "All strokes [N]", "n"}));
}

TEST_F(ReportTables, OfSitesHaveEachEstimateInItsRow) {
  section_.results.families.front().cohorts.front().sites = tests::numberedSites();
  const auto page = asHtml({section_});
  const auto table = tableOf(page, "Differences of participants’ means by site");
  EXPECT_EQ(table.headings, (Cells{"Site", "n", "Difference", "99 % CI", "p", "Weight"}));
  const std::vector<Cells> expected{
      {"Orthopaedic surgeons: Interpolation vs. FEM"},
      {"Graz", "801", "8.02", "[8.07, 8.08]", ".806", "9 %"},
      {"All sites, one effect", "", "8.13", "[8.14, 8.15]", ".816", ""},
      {"All sites, random effects (REML, Knapp–Hartung)", "", "8.29", "[8.32, 8.33]", ".836", ""},
      {"Heterogeneity: Q(83) = 8.11, p = .812; I² = 28 %; τ² = 8.270"},
      {"Mixed model, sites as random effects", "", "8.49", "[8.51, 8.52]", ".853", ""}};
  EXPECT_EQ(table.rows, expected);
}

TEST_F(ReportTables, OfTheAnswerHasMeansWhereNothingIsTested) {
  section_.results.families.front().cohorts.front().within.rows.clear();
  const auto table = tableOf(asHtml({section_}), "The mean of each method");
  EXPECT_EQ(table.headings, (Cells{"Method", "M", "Answers"}));
  ASSERT_EQ(table.rows.size(), 3U);
  EXPECT_EQ(table.rows[1], (Cells{"Interpolation", "4.00", "6"}));
  EXPECT_EQ(table.rows[2], (Cells{"FEM", "1.67", "3"}));
}

TEST_F(ReportTables, OfValidityEvidenceHasTheSmallestAndTheLargestNumber) {
  auto& family = section_.results.families.front();
  auto& checks = family.cohorts.front().checks.methods;
  checks.push_back(checks.front());
  checks.back().method = "finite-elements";
  checks.back().alpha.value = 0.59;
  family.between.push_back(family.between.front());
  family.between.back().tests.front().effect.value = 0.79;
  family.between.back().tests.front().p = 0.01;
  const auto rows = tableOf(asHtml({section_}), "Validity evidence").byHeading();
  ASSERT_EQ(rows.size(), 5U);
  const auto expectEvidence = [&](std::size_t row, const char* source, const std::string& words) {
    EXPECT_EQ(rows[row].at("Source"), source);
    EXPECT_NE(rows[row].at("Evidence").find(words), std::string::npos) << rows[row].at("Evidence");
  };
  expectEvidence(1, "Response process", "103 of 101 trials passed every check");
  expectEvidence(
      2,
      "Internal structure",
      "Cronbach’s α of the statements about a method: 0.53 to 0.59, of 501 participants each; ");
  expectEvidence(
      3,
      "Relations to other variables",
      "Cliff’s δ between cohorts: 0.71 to 0.79 (exploratory); the exact p is significant in 1 of "
      "2 ");
}

TEST_F(ReportTables, HaveOtherNumbersInSentencesBesideThem) {
  expectSaid(
      "6.01 points from one position to the next, 95 % CI [6.06, 6.07], t(64) = 6.03, "
      "p = .605.");
  expectSaid("Friedman χ²(2) = 4.02, p = .403, Kendall’s W = 0.44, exact p = .405");
  expectSaid(
      "Repeated-measures ANOVA F(47, 48) = 4.06, p = .409, partial η² = 0.41, "
      "Greenhouse–Geisser ε = 0.42, p = .411");
  expectSaid(
      "101 trials, 106 cuts or strokes: 103 passed every check, 104 did with a warning, 105 "
      "failed.");
  expectSaid("more than the force limit for 10.7 s of 10.8 s of contact.");
  expectSaid("Not among them: 102 times");
  expectSaid("99 % of the ticks were at most 109 µs late.");
}

TEST_F(ReportTables, HaveSentencesBesideThemAsMedicalJournalsWriteThem) {
  section_.wording = Wording::Vancouver;
  text_ = asRead(asHtml({section_}));
  expectSaid("(99 % CI 3.08 to 3.09, PHolm = 0.343; TOST P = 0.327)");
  expectSaid("Friedman χ²(2) = 4.02, P = 0.403, Kendall’s W = 0.44, exact P = 0.405");
}

TEST_F(ReportTables, HaveVancouversNumbersInEveryTable) {
  section_.wording = Wording::Vancouver;
  const auto page = asHtml({section_});
  for (auto at = page.find("<td>"); at != std::string::npos; at = page.find("<td>", at + 1)) {
    const auto cell = page.substr(at + 4, page.find("</td>", at) - at - 4);
    EXPECT_FALSE(cell.starts_with(".")) << cell;
    EXPECT_EQ(cell.find("&lt; ."), std::string::npos) << cell;
    const bool isInterval = cell.starts_with("[") && cell.find('%') == std::string::npos;
    EXPECT_FALSE(isInterval) << cell;
  }
}

// What prints 3.12 beside 3.13 for one number: fmt rounds halves to even, and differences are a
// little off.
TEST(Rounding, IsAwayFromZeroWhateverTheLastBits) {
  EXPECT_EQ(study::rounded(3.125, 2), "3.13");
  EXPECT_EQ(study::rounded(0.125, 2), "0.13");
  EXPECT_EQ(study::rounded(-1.125, 2), "−1.13");
  EXPECT_EQ(study::rounded(-0.004, 2), "0.00") << "zero has no sign";
  EXPECT_EQ(study::rounded(4.325 - 3.2, 2), "1.13");
  EXPECT_EQ(study::rounded(1.005, 2), "1.01");
  EXPECT_EQ(study::rounded(1.0049999, 2), "1.00");
  EXPECT_EQ(study::rounded(62.5, 0), "63");
  EXPECT_EQ(study::formatP(0.0625), ".063");
}

TEST(Wording, WritesBoundsAndOnesWithTheirDigits) {
  EXPECT_EQ(formatPWithSymbol(0.0001), "p < .001");
  EXPECT_EQ(formatPWithSymbol(0.0001, "Holm", Wording::Vancouver), "P_Holm < 0.001");
  EXPECT_EQ(formatPWithSymbol(1.0, {}, Wording::Vancouver), "P > 0.999");
  EXPECT_EQ(formatPWithSymbol(std::nullopt, {}, Wording::Vancouver), "P = –");
}

TEST_F(ReportTables, HaveTheConfidenceThatGoesWithTheAlphaOfTheFamily) {
  for (const auto& [alpha, heading] :
       {std::pair{0.05, "95 % CI"}, std::pair{0.01, "99 % CI"}, std::pair{0.1, "90 % CI"}}) {
    section_.results.families.front().family.alpha = alpha;
    const auto page = asHtml({section_});
    EXPECT_EQ(tableOf(page, "Declared: ").headings.at(2), heading);
    EXPECT_EQ(tableOf(page, "Differences of participants’ means").headings.at(4), heading);
  }
}

/// The terminal's output of the same results.
class ResultsText : public testing::Test {
 protected:
  void expectSaid(Profile profile, const std::string& words) {
    const auto text = resultsAsText(*study_, tests::numberedSection().results, profile);
    EXPECT_NE(text.find(words), std::string::npos) << words << "\nis not in\n" << text;
  }

  tests::MadeStudy study_{tests::libraryProtocol("punch-face-validity")};
};

TEST_F(ResultsText, HasTheNumbersOfTheReportsTablesAsPublished) {
  const auto profile = Profile::AsPublished;
  expectSaid(profile, "Orthopaedic surgeons: 11 enrolled, 12 completed, 13 in progress, 62 left");
  expectSaid(profile, "4.00 / 2.40 (n=6)");
  expectSaid(profile, "1.67 / 0.33 (n=3)");
  expectSaid(profile, "(alpha per test 0.0025)");
  expectSaid(profile, "difference   2.07, t(21.11) =   2.09, p = .212    adjusted p = .214");
  expectSaid(profile, "Interpolation 81");
  expectSaid(profile, "FEM 82");
  expectSaid(profile, "KF 83");
  expectSaid(profile, "exact p = .804");
  expectSaid(profile, "9.02 9.03 [9.04, 9.05], n = 3");
}

TEST_F(ResultsText, WritesLargeAnswersWithoutAnExponent) {
  auto results = tests::numberedSection().results;
  results.answers.items = {
      {.instrument = "background-knee",
       .item = "knees",
       .cohort = "professional",
       .values = {2905.0, 14117.0},
       .mean = 8511.0,
       .median = 8511.0,
       .least = 2905.0,
       .most = 14117.0}};
  const auto text = resultsAsText(*study_, results, Profile::Declared);
  EXPECT_NE(text.find(", 2905 … 14117, n = 2"), std::string::npos) << text;
}

TEST_F(ResultsText, CallsConfirmatoryTestsSignificantOnly) {
  auto results = tests::numberedSection().results;
  auto& family = results.families.front();
  const auto isCalledSignificant = [&] {
    return resultsAsText(*study_, results, Profile::AsPublished).find(" significant") !=
           std::string::npos;
  };
  EXPECT_FALSE(family.isConfirmatory("welch"));
  EXPECT_FALSE(isCalledSignificant());
  family.family.test = protocols::TestType::Welch;
  family.isDeclared = true;
  EXPECT_TRUE(isCalledSignificant());
}

TEST_F(ResultsText, HasTheNumbersOfTheReportsTablesWithinPeople) {
  const auto profile = Profile::Recommended;
  expectSaid(profile, "Orthopaedic surgeons: 41 participants who judged every method");
  expectSaid(
      profile,
      "t(36) = 3.05, p = .307, p_Holm = .341, mean difference 3.02, 99 % CI [3.08, 3.09], "
      "g_z = 3.16 [3.17, 3.18]");
  expectSaid(profile, "Order: 6.01 points from one position to the next [6.06, 6.07], p = .605");
  expectSaid(profile, "Scale, Interpolation: Cronbach's α = 0.53, ω = 0.58, Shapiro–Wilk p = .512");
  expectSaid(
      profile, "U = 703.5, exact p = .704, Cliff's δ = 0.71 [0.73, 0.74]; Brunner–Munzel p = .708");
}

TEST_F(ResultsText, SaysWhatANegativeAlphaMeans) {
  auto results = tests::numberedSection().results;
  auto& alpha = results.families.front().cohorts.front().checks.methods.front().alpha;
  alpha.reason = analysis::reason("negative_alpha");
  const auto text = resultsAsText(*study_, results, Profile::Recommended);
  EXPECT_NE(text.find("\n    α is negative: the statements do not"), std::string::npos) << text;
}

}  // namespace report_tables_test
}  // namespace study::report

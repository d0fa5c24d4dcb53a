// The tables of an export that hold results, of numberedSection(): each number is in its column.
#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "study/export/condition_codes.h"
#include "study/export/statistics_table.h"
#include "tests/study/exported_rows.h"
#include "tests/study/made_study.h"
#include "tests/study/report/numbered_section.h"

namespace study::report {
namespace exported_results_test {

using Row = tests::ExportedRow;

/// The columns that say what a row is about, where it has numbers.
const std::set<std::string> kAbout{
    "run_mode",
    "cohort",
    "family_id",
    "instrument",
    "blocks",
    "items",
    "groups",
    "group1",
    "group2",
    "design",
    "unit",
    "method",
    "declared",
    "p_adj_method",
    "alpha",
    "m",
    "flags"};

class ExportedResults : public testing::Test {
 protected:
  std::string code(const std::string& condition) {
    return conditionCodes(*study_, RunMode::Live).at(condition);
  }

  FamilyResult& family() { return results_.families.front(); }

  /// The only row of a method; without the cells that are empty.
  Row rowOf(const std::string& method) {
    if (rows_.empty()) {
      rows_ = tests::rowsOf(statisticsTable(*study_, {.isBlinded = false}, {results_}));
    }
    std::vector<Row> found;
    for (const auto& row : rows_) {
      if (row.at("method") == method) found.push_back(tests::filledCells(row));
    }
    EXPECT_EQ(found.size(), 1U) << method;
    return found.empty() ? Row() : found.front();
  }

  Row numbersOf(const std::string& method) {
    auto row = rowOf(method);
    std::erase_if(row, [](const auto& cell) { return kAbout.contains(cell.first); });
    return row;
  }

  Row conditionAnswered(const std::string& method) {
    auto row = rowOf(method);
    std::erase_if(row, [](const auto& cell) { return !kAbout.contains(cell.first); });
    return row;
  }

  tests::MadeStudy study_{tests::libraryProtocol("punch-face-validity")};
  Results results_ = tests::numberedSection().results;
  std::vector<Row> rows_;  ///< of the table of statistics, once a test has asked for one
};

TEST_F(ExportedResults, HaveAColumnForEveryNumberOfATest) {
  analysis::TestRow test{.id = "friedman"};
  test.n1 = 11;
  test.n2 = 12;
  test.moments = {{{1.5, 4.0}, {2.5, 9.0}}};
  test.estimate = {"difference", 13.5};
  test.standardError = 14.5;
  test.statistic = {"chi2", 15.5};
  test.df = 16.5;
  test.df2 = 17.5;
  test.p = 0.18;
  test.log10P = -19.5;
  test.adjusted = 0.21;
  test.interval = {22.5, 23.5};
  test.adjustedInterval = {24.5, 25.5};
  test.effect = {"kendall_w", 26.5};
  test.effectInterval = {27.5, 28.5};
  test.more = {
      {"p_permutation", 0.29}, {"epsilon", 0.31}, {"p_epsilon", 0.32}, {"equivalence_bound", 33.5}};
  family().cohorts.front().within.overall = {test};
  const Row expected{
      {"n1", "11"},
      {"n2", "12"},
      {"mean1", "1.5"},
      {"mean2", "2.5"},
      {"sd1", "2"},
      {"sd2", "3"},
      {"estimate", "13.5"},
      {"se", "14.5"},
      {"statistic_name", "chi2"},
      {"statistic", "15.5"},
      {"df", "16.5"},
      {"df2", "17.5"},
      {"p", "0.18"},
      {"log10_p", "-19.5"},
      {"p_permutation", "0.29"},
      {"epsilon", "0.31"},
      {"p_epsilon", "0.32"},
      {"equivalence_bound", "33.5"},
      {"p_adj", "0.21"},
      {"conf_level", "0.99"},
      {"conf_low", "22.5"},
      {"conf_high", "23.5"},
      {"conf_low_adj", "24.5"},
      {"conf_high_adj", "25.5"},
      {"effect_name", "kendall_w"},
      {"effect", "26.5"},
      {"effect_low", "27.5"},
      {"effect_high", "28.5"}};
  EXPECT_EQ(numbersOf("friedman"), expected);
}

TEST_F(ExportedResults, SayWhatAComparisonIsAbout) {
  family().cohorts.front().table.rounds = {"round-1", "round-2"};
  family().cohorts.front().table.statements = {"1.1", "2.1"};
  const Row expected{
      {"run_mode", "live"},
      {"cohort", "professional"},
      {"family_id", family().family.id},
      {"instrument", "punch-face-validity"},
      {"blocks", "round-1 round-2"},
      {"items", "1.1 2.1"},
      {"m", "4"},
      {"group1", code("interpolation")},
      {"group2", code("finite-elements")},
      {"design", "paired"},
      {"unit", "participant"},
      {"method", "signed_rank"},
      {"declared", "true"},
      {"p_adj_method", "holm"},
      {"alpha", "0.01"}};
  EXPECT_EQ(conditionAnswered("signed_rank"), expected);
}

TEST_F(ExportedResults, OfPositionReliabilityAndDistributionAreInTheirColumns) {
  EXPECT_EQ(
      numbersOf("order_slope"),
      (
          Row{{"n1", "0"},
              {"estimate", "6.01"},
              {"se", "6.02"},
              {"statistic_name", "t"},
              {"statistic", "6.03"},
              {"df", "64"},
              {"p", "0.605"},
              {"conf_level", "0.95"},
              {"conf_low", "6.06"},
              {"conf_high", "6.07"}}));
  EXPECT_EQ(
      numbersOf("brown_forsythe"),
      (
          Row{{"statistic_name", "F"},
              {"statistic", "5.13"},
              {"df", "54"},
              {"df2", "55"},
              {"p", "0.516"},
              {"conf_level", "0.99"}}));
  EXPECT_EQ(
      numbersOf("cronbach_alpha"),
      (
          Row{{"n1", "501"},
              {"conf_level", "0.95"},
              {"effect_name", "cronbach_alpha"},
              {"effect", "0.53"},
              {"effect_low", "0.54"},
              {"effect_high", "0.55"}}));
  EXPECT_EQ(
      numbersOf("omega_total"),
      (
          Row{{"n1", "506"},
              {"conf_level", "0.99"},
              {"effect_name", "omega_total"},
              {"effect", "0.58"}}));
  EXPECT_EQ(
      numbersOf("shapiro_wilk"),
      (
          Row{{"n1", "509"},
              {"statistic_name", "W"},
              {"statistic", "0.511"},
              {"p", "0.512"},
              {"conf_level", "0.99"}}));
}

TEST_F(ExportedResults, OfAnswerProbabilitiesAndCohortsAreInTheirColumns) {
  EXPECT_EQ(
      numbersOf("answer_probability"),
      (
          Row{{"acceptable_from", "4"},
              {"n1", "415"},
              {"statistic_name", "observed_share"},
              {"statistic", "0.41"},
              {"conf_level", "0.99"},
              {"effect_name", "probability"},
              {"effect", "0.42"},
              {"effect_low", "0.43"},
              {"effect_high", "0.44"}}));
  EXPECT_EQ(
      numbersOf("mann_whitney"),
      (
          Row{{"cohort2", "non-professional"},
              {"n1", "701"},
              {"n2", "702"},
              {"statistic_name", "U"},
              {"statistic", "703.5"},
              {"p", "0.704"},
              {"conf_level", "0.95"},
              {"effect_name", "cliff_delta"},
              {"effect", "0.71"},
              {"effect_low", "0.73"},
              {"effect_high", "0.74"}}));
}

/// Without the name of the site: the study of this test is on one machine.
TEST_F(ExportedResults, OfSitesAreInTheirColumns) {
  auto& cohort = family().cohorts.front();
  cohort.table.methods = {"interpolation"};
  cohort.sites = tests::numberedSites();
  EXPECT_EQ(
      numbersOf("site_answers"), (Row{{"n1", "6"}, {"mean1", "4"}, {"sd1", "1.5491933384829668"}}));
  EXPECT_EQ(
      numbersOf("site_difference"),
      (
          Row{{"n1", "801"},
              {"estimate", "8.02"},
              {"se", "8.03"},
              {"statistic_name", "t"},
              {"statistic", "8.04"},
              {"df", "8.05"},
              {"p", "0.806"},
              {"conf_level", "0.99"},
              {"conf_low", "8.07"},
              {"conf_high", "8.08"}}));
  EXPECT_EQ(
      numbersOf("pooled_sites"),
      (
          Row{{"n1", "84"},
              {"estimate", "8.29"},
              {"se", "8.31"},
              {"statistic_name", "t"},
              {"statistic", "8.34"},
              {"df", "8.35"},
              {"p", "0.836"},
              {"conf_level", "0.99"},
              {"conf_low", "8.32"},
              {"conf_high", "8.33"},
              {"effect_name", "i2"},
              {"effect", "0.37"}}));
}

TEST_F(ExportedResults, OfQuestionnairesAreInTheirColumns) {
  EXPECT_EQ(
      numbersOf("score"),
      (
          Row{{"score", "total"},
              {"n_missing", "91"},
              {"n1", "3"},
              {"mean1", "9.02"},
              {"sd1", "9.03"},
              {"conf_level", "0.95"},
              {"conf_low", "9.04"},
              {"conf_high", "9.05"}}));
  EXPECT_EQ(
      numbersOf("acceptability"),
      (
          Row{{"item_id", "ease"},
              {"acceptable_from", "9.5"},
              {"n1", "97"},
              {"conf_level", "0.95"},
              {"effect_name", "share"},
              {"effect", "0.21"},
              {"effect_low", "0.22"},
              {"effect_high", "0.23"}}));
}

// SciPy: r = binomtest(81, 246); r.proportion_ci(method="wilson"), r.proportion_ci(method="exact")
TEST_F(ExportedResults, OfAVoteAreInTheirColumns) {
  auto& vote = results_.votes.front();
  vote.test.chiSquared = 8.06;
  vote.test.degreesOfFreedom = 8.07;
  const auto rows = tests::rowsOf(votesTable(*study_, {.isBlinded = false}, {results_}));
  ASSERT_EQ(rows.size(), 3U);
  auto row = *std::ranges::find_if(
      rows, [&](const auto& one) { return one.at("condition_code") == code("interpolation"); });
  for (const auto& [column, expected] : std::vector<std::pair<std::string, double>>{
           {"share", 81.0 / 246.0},
           {"share_low", 0.273561584734},
           {"share_high", 0.390225200708},
           {"share_low_exact", 0.270888085092},
           {"share_high_exact", 0.391821903781}}) {
    EXPECT_NEAR(std::stod(row.at(column)), expected, 1e-9) << column;
    row.erase(column);
  }
  const Row expected{
      {"run_mode", "live"},
      {"cohort", "professional"},
      {"preference", "preference-1"},
      {"block", "round-1"},
      {"item_id", row.at("item_id")},
      {"condition_code", code("interpolation")},
      {"votes", "81"},
      {"votes_total", "246"},
      {"conf_level", "0.95"},
      {"p_exact", "0.804"},
      {"chi2", "8.06"},
      {"chi2_df", "8.07"},
      {"p_chi2", "0.805"},
      {"reason", ""}};
  EXPECT_EQ(row, expected);
}

}  // namespace exported_results_test
}  // namespace study::report

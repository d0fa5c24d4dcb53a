#include "analysis/summary/site_comparison.h"

#include <stdexcept>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/analysis/golden_file.h"

namespace site_comparison_test {

using analysis::AnswerTable;

/// Eight people, two methods, two statements each. Those of Oslo see a difference of about 2, those
/// of Bergen about none.
AnswerTable made() {
  AnswerTable table{.methods = {"a", "b"}, .rounds = {"1"}, .statements = {"1", "2"}};
  const std::vector<std::vector<int>> scores{
      {5, 4, 3, 2},
      {4, 4, 2, 1},
      {5, 5, 3, 4},
      {4, 5, 2, 3},  // Oslo
      {3, 3, 3, 2},
      {2, 3, 3, 3},
      {4, 3, 3, 4},
      {3, 2, 2, 2}};  // Bergen
  for (std::size_t person = 0; person < scores.size(); ++person) {
    table.participants.push_back("P" + std::to_string(person));
    for (std::size_t i = 0; i < 4; ++i) {
      table.answers.push_back(
          {.participant = person,
           .method = i / 2,
           .statement = i % 2,
           .position = static_cast<int>(i / 2) + 1,
           .score = double(scores[person][i])});
    }
  }
  return table;
}

const std::vector<std::string> kSites{
    "oslo", "oslo", "oslo", "oslo", "bergen", "bergen", "bergen", "bergen"};
const std::vector<analysis::DeclaredPair> kPair{{"a", "b"}};

TEST(SiteComparison, ComparesWithinPeopleSiteBySiteAndPools) {
  const auto all = analysis::compareSites(made(), kSites, kPair, 0.95);
  ASSERT_EQ(all.rows.size(), 1U);
  const auto& row = all.rows.front();
  ASSERT_EQ(row.sites.size(), 2U);
  // R: d <- c(2, 2.5, 1.5, 2); t.test(d); e <- c(.5, -.5, 0, .5); t.test(e)
  EXPECT_EQ(row.sites[0].site, "bergen");
  EXPECT_NEAR(row.sites[0].test.meanDifference.value(), 0.125, 1e-15);
  EXPECT_NEAR(row.sites[0].test.standardError.value(), 0.239356776939085, 1e-14);
  EXPECT_NEAR(row.sites[1].test.meanDifference.value(), 2.0, 1e-15);
  EXPECT_NEAR(row.sites[1].test.standardError.value(), 0.204124145231932, 1e-14);
  // R: rma(c(.125, 2), sei = c(0.239356776939085, 0.204124145231932), method = "REML")
  ASSERT_TRUE(row.pooled.has_value());
  EXPECT_NEAR(row.pooled->reml.estimate, 1.06667, 0.02);
  EXPECT_NEAR(row.sites[0].weight + row.sites[1].weight, 1.0, 1e-12);
  EXPECT_LT(row.pooled->heterogeneityP, 1e-6);
  EXPECT_TRUE(row.leaveOneOut.empty());  // of two sites, one is left
}

TEST(SiteComparison, CountsTheAnswersOfEachSite) {
  const auto all = analysis::compareSites(made(), kSites, kPair, 0.95);
  ASSERT_EQ(all.answers.size(), 2U);
  const auto& oslo = all.answers[1];
  EXPECT_EQ(oslo.site, "oslo");
  EXPECT_EQ(oslo.participants, 4U);
  ASSERT_EQ(oslo.methods.size(), 2U);
  EXPECT_EQ(oslo.methods[0].total(), 8U);
  EXPECT_EQ(oslo.methods[0].mean(), 4.5);  // 5 4 4 4 5 5 4 5
  EXPECT_EQ(oslo.methods[1].mean(), 2.5);
  EXPECT_EQ(all.answers[0].methods[1].mean(), 2.75);
}

TEST(SiteComparison, ModelsSitesAsFixedAndAsRandomEffects) {
  const auto all = analysis::compareSites(made(), kSites, kPair, 0.95);
  const auto& row = all.rows.front();
  ASSERT_TRUE(all.randomSites.fit.has_value());
  ASSERT_TRUE(all.fixedSites.fit.has_value());
  // Balanced data: each model's difference is that of the means.
  EXPECT_NEAR(row.fixedSites.estimate.value.value(), 1.0625, 1e-12);
  EXPECT_NEAR(row.randomSites.estimate.value.value(), 1.0625, 1e-9);
  // Sites that differ in the effect make it less certain.
  EXPECT_GT(row.randomSites.standardError.value(), 2.0 * row.fixedSites.standardError.value());
  const auto& components = all.randomSites.fit->components;
  EXPECT_EQ(components.back().name, "site:method");
  EXPECT_GT(components.back().variance, 0.1);
}

/// The answers of tests/data/stats/sites/models_golden.R, with the site of each participant.
std::pair<AnswerTable, std::vector<std::string>> tableOf(const nlohmann::json& answers) {
  AnswerTable table{.methods = {"a", "b"}, .rounds = {"1"}, .statements = {"1", "2"}};
  std::vector<std::string> sites;
  for (const auto& answer : answers) {
    const auto person = answer[0].get<std::string>();
    if (table.participants.empty() || table.participants.back() != person) {
      table.participants.push_back(person);
      sites.push_back(answer[1].get<std::string>());
    }
    const std::size_t method = answer[2] == "a" ? 0 : 1;
    table.answers.push_back(
        {.participant = table.participants.size() - 1,
         .method = method,
         .statement = static_cast<std::size_t>(answer[3] == "1" ? 0 : 1),
         .position = static_cast<int>(method) + 1,
         .score = answer[4].get<double>()});
  }
  return {table, sites};
}

void expectAsInLme4(
    const analysis::TestRow& row,
    const analysis::LinearMixedResult& model,
    const nlohmann::json& golden) {
  const auto number = [](const nlohmann::json& text) { return std::stod(text.get<std::string>()); };
  // lme4 minimises the deviance, of which it knows some ten digits: half as many of the variances.
  EXPECT_NEAR(row.estimate.value.value(), number(golden["a_minus_b"]), 1e-6);
  EXPECT_NEAR(row.standardError.value(), number(golden["se"]), 1e-6);
  ASSERT_TRUE(model.fit.has_value());
  EXPECT_NEAR(-2.0 * model.fit->logLikelihood, number(golden["reml_deviance"]), 1e-8);
  EXPECT_NEAR(model.fit->residualVariance, number(golden["variances"]["Residual"]), 1e-5);
  EXPECT_EQ(model.fit->components.size() + 1, golden["variances"].size());
  for (const auto& component : model.fit->components) {
    EXPECT_NEAR(component.variance, number(golden["variances"][component.name]), 1e-5)
        << component.name;
  }
}

TEST(SiteComparison, ModelsSitesAsLme4Does) {
  const auto golden = tests::statsJson("sites/models.json");
  const auto [table, sites] = tableOf(golden["answers"]);
  const auto all = analysis::compareSites(table, sites, kPair, 0.95);
  const auto& row = all.rows.front();
  expectAsInLme4(row.fixedSites, all.fixedSites, golden["fixed"]);
  expectAsInLme4(row.randomSites, all.randomSites, golden["random"]);
}

TEST(SiteComparison, LeavesASiteOfOnePersonOutOfThePool) {
  auto sites = kSites;
  sites[0] = "tromso";
  const auto row = analysis::compareSites(made(), sites, kPair, 0.95).rows.front();
  ASSERT_EQ(row.sites.size(), 3U);
  EXPECT_FALSE(row.sites[2].test.reason.empty());
  EXPECT_EQ(row.sites[2].weight, 0.0);
  EXPECT_EQ(row.pooled.value().sites, 2U);
}

TEST(SiteComparison, SaysWhyNothingIsPooled) {
  const std::vector<std::string> alone(8, "oslo");
  const auto row = analysis::compareSites(made(), alone, kPair, 0.95).rows.front();
  EXPECT_FALSE(row.pooled.has_value());
  EXPECT_EQ(row.reason.key(), "two_sites_needed");
  EXPECT_THROW(
      analysis::compareSites(made(), std::vector<std::string>{"oslo"}, kPair, 0.95),
      std::invalid_argument);
}

}  // namespace site_comparison_test

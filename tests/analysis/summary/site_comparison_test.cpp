#include "analysis/summary/site_comparison.h"

#include <stdexcept>

#include <gtest/gtest.h>

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
  EXPECT_LT(row.pooled->qP, 1e-6);
  EXPECT_TRUE(row.withoutEach.empty());  // of two sites, one is left
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

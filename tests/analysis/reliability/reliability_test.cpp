#include "analysis/reliability/reliability.h"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace reliability_test {

using analysis::cronbachAlpha;
using analysis::omegaTotal;
using Table = std::vector<std::vector<double>>;

const Table kAnswers{
    {4, 5, 3, 4},
    {2, 1, 2, 2},
    {3, 4, 4, 5},
    {5, 5, 4, 4},
    {1, 2, 1, 3},
    {3, 3, 2, 1},
    {4, 3, 5, 4}};

double varianceOf(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  const auto n = static_cast<double>(values.size());
  double squares = 0.0;
  for (const double value : values) squares += (value - sum / n) * (value - sum / n);
  return squares / (n - 1.0);
}

TEST(CronbachAlpha, FollowsFromTheVariances) {
  std::vector<double> sums;
  double ofItems = 0.0;
  for (const auto& row : kAnswers) sums.push_back(row[0] + row[1] + row[2] + row[3]);
  for (std::size_t item = 0; item < 4; ++item) {
    std::vector<double> column;
    for (const auto& row : kAnswers) column.push_back(row[item]);
    ofItems += varianceOf(column);
  }
  const auto alpha = cronbachAlpha(kAnswers);

  EXPECT_NEAR(alpha.value.value(), 4.0 / 3.0 * (1.0 - ofItems / varianceOf(sums)), 1e-14);
  EXPECT_EQ(alpha.respondents, 7U);
  EXPECT_EQ(alpha.items, 4U);
  EXPECT_LT(alpha.interval->low, *alpha.value);
  EXPECT_GT(alpha.interval->high, *alpha.value);
}

TEST(CronbachAlpha, HasAWiderIntervalForMoreConfidence) {
  EXPECT_LT(cronbachAlpha(kAnswers, 0.99).interval->low, cronbachAlpha(kAnswers).interval->low);
}

TEST(CronbachAlpha, IsOneForItemsThatDifferByConstants) {
  const auto alpha = cronbachAlpha(Table{{1, 2}, {2, 3}, {4, 5}});
  EXPECT_EQ(alpha.value, 1.0);
  EXPECT_EQ(alpha.interval->low, 1.0);
}

TEST(CronbachAlpha, IsNegativeForItemsThatPullApart) {
  EXPECT_LT(cronbachAlpha(Table{{1, 5}, {2, 4.5}, {4, 2}}).value.value(), 0.0);
}

TEST(CronbachAlpha, GivesAReasonIfItIsUndefined) {
  EXPECT_EQ(cronbachAlpha(Table{{1, 5}, {5, 1}, {3, 3}}).reason.key(), "sums_same");
  EXPECT_FALSE(cronbachAlpha(Table{{1, 5}}).value.has_value());
  EXPECT_FALSE(cronbachAlpha(Table{{1}, {5}}).reason.empty());
  EXPECT_THROW(cronbachAlpha(Table{{1, 2}, {1}}), std::invalid_argument);
  EXPECT_THROW(cronbachAlpha(kAnswers, 1.0), std::invalid_argument);
}

TEST(OmegaTotal, IsAlphaOfParallelItems) {
  // all rotations of three answers that sum to 0, about four levels: variances and covariances are
  // all the same
  Table answers;
  for (const double level : {1.0, 3.0, 5.0, 6.0}) {
    answers.push_back({level + 1.0, level - 1.0, level});
    answers.push_back({level - 1.0, level, level + 1.0});
    answers.push_back({level, level + 1.0, level - 1.0});
  }
  const auto omega = omegaTotal(answers);

  EXPECT_NEAR(omega.value.value(), cronbachAlpha(answers).value.value(), 1e-13);
  EXPECT_NEAR(omega.loadings[0], omega.loadings[2], 1e-13);
  EXPECT_FALSE(omega.isImproper);
}

TEST(OmegaTotal, IsAtLeastAlphaIfOneFactorFits) {
  // factor levels × independent errors of each item: one factor fits exactly
  Table answers;
  for (const double f : {-1.0, 1.0}) {
    for (const double e1 : {-1.0, 1.0}) {
      for (const double e2 : {-1.0, 1.0}) {
        for (const double e3 : {-1.0, 1.0}) {
          answers.push_back({2.0 * f + e1, f + e2, 0.5 * f + 2.0 * e3});
        }
      }
    }
  }
  const auto omega = omegaTotal(answers);

  // (2 + 1 + .5)² / ((2 + 1 + .5)² + 1 + 1 + 4)
  EXPECT_NEAR(omega.value.value(), 12.25 / 18.25, 1e-13);
  EXPECT_GT(*omega.value, cronbachAlpha(answers).value.value());
  EXPECT_NEAR(omega.loadings[0], 2.0 / std::sqrt(5.0), 1e-13);
}

TEST(CronbachAlpha, SaysWhatANegativeValueMeans) {
  const auto alpha = cronbachAlpha(Table{{1, 5}, {2, 4}, {4, 1}});
  EXPECT_LT(alpha.value.value(), 0.0);
  EXPECT_EQ(alpha.reason.key(), "negative_alpha");
  EXPECT_TRUE(cronbachAlpha(kAnswers).reason.empty());
}

TEST(OmegaTotal, DoesNotDependOnUnits) {
  Table scaled = kAnswers;
  for (auto& row : scaled) {
    for (double& answer : row) answer *= 1e-200;
  }
  EXPECT_NEAR(omegaTotal(scaled).value.value(), omegaTotal(kAnswers).value.value(), 1e-12);
}

TEST(OmegaTotal, GivesAReasonIfItIsUndefined) {
  EXPECT_FALSE(omegaTotal(Table{{1, 2}, {2, 3}, {4, 4}}).value.has_value());
  EXPECT_EQ(
      omegaTotal(Table{{1, 2, 4}, {2, 3, 4}, {4, 4, 4}}).reason,
      analysis::reason("item_without_variance", 3));
  EXPECT_EQ(omegaTotal(Table{}).reason.key(), "three_respondents_needed");
  EXPECT_THROW(omegaTotal(Table{{1, 2, 3}, {1, 2}}), std::invalid_argument);
}

}  // namespace reliability_test

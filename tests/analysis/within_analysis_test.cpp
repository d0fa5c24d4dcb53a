// Which way round differences are: first − second, in every test of a comparison.
#include "analysis/within_analysis.h"

#include <gtest/gtest.h>

namespace {

/// Four people judge three methods three times each: "good" on the whole a point above "fair", and
/// that two points above "poor".
analysis::AnswerTable judged() {
  analysis::AnswerTable table{
      .lowest = 1,
      .highest = 7,
      .participants = {"P1", "P2", "P3", "P4"},
      .methods = {"poor", "good", "fair"},
      .rounds = {"round"},
      .statements = {"S1", "S2", "S3"},
      .answers = {}};
  const int scores[3][4][3] = {
      {{1, 2, 1}, {3, 2, 4}, {2, 1, 3}, {1, 3, 1}},   // poor: 24 of 12
      {{5, 4, 5}, {6, 5, 3}, {4, 6, 6}, {5, 6, 5}},   // good: 60
      {{4, 3, 5}, {5, 4, 4}, {3, 3, 4}, {4, 5, 4}}};  // fair: 48
  for (std::size_t method = 0; method < 3; ++method) {
    for (std::size_t person = 0; person < 4; ++person) {
      for (std::size_t statement = 0; statement < 3; ++statement) {
        table.answers.push_back(
            {.participant = person,
             .method = method,
             .statement = statement,
             .position = static_cast<int>(method) + 1,
             .score = scores[method][person][statement]});
      }
    }
  }
  return table;
}

void expectDifference(const analysis::WithinComparison& row, double difference) {
  SCOPED_TRACE(row.group1 + " - " + row.group2);
  EXPECT_NEAR(row.paired.meanDifference.value(), difference, 1e-12);
  EXPECT_NEAR(row.mixed.estimate, difference, 1e-9) << "balanced, so the same as the means'";
  EXPECT_GT(row.mixed.t.value() * difference, 0.0);
  EXPECT_EQ(row.mixed.name, row.group1 + " - " + row.group2);
  ASSERT_TRUE(row.ordinal.has_value()) << row.ordinalReason;
  EXPECT_GT(row.ordinal->estimate * difference, 0.0);
  EXPECT_EQ(row.ordinal->oddsRatio > 1.0, difference > 0.0);
  EXPECT_GT(row.location.estimate.value() * difference, 0.0);
  EXPECT_GT(row.effects.hedgesGz.value.value() * difference, 0.0);
  EXPECT_GT(row.signedRank.rankBiserial.value() * difference, 0.0);
  EXPECT_LT(row.interval->low, difference);
  EXPECT_GT(row.interval->high, difference);
}

TEST(WithinAnalysis, TakesTheSecondMethodFromTheFirstInEveryTest) {
  const std::vector<analysis::DeclaredPair> pairs{
      {"good", "fair"}, {"fair", "good"}, {"poor", "good"}, {"fair", "poor"}};
  const auto result = analysis::compareWithin(judged(), pairs, {});
  ASSERT_EQ(result.rows.size(), 4U);
  expectDifference(result.rows[0], 1.0);
  expectDifference(result.rows[1], -1.0);
  expectDifference(result.rows[2], -3.0);
  expectDifference(result.rows[3], 2.0);
}

}  // namespace

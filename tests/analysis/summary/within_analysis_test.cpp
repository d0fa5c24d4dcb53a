// Which way round differences are: first − second, in every test of a comparison.
#include "analysis/summary/within_analysis.h"

#include <gtest/gtest.h>

#include "tests/analysis/study_answers.h"

namespace within_analysis_test {

/// The answers of the synthetic study's professionals: 36 to each method, with the means 146/36
/// (interpolation), 95/36 (fem) and 115/36 (kalman).
analysis::AnswerTable professionals() {
  const auto answers = tests::studyAnswers("professional");
  analysis::AnswerTable table{
      .participants = answers.participant.levels,
      .methods = answers.method.levels,
      .rounds = answers.round.levels,
      .statements = {"any"},
      .answers = {}};
  for (std::size_t i = 0; i < answers.scores.size(); ++i) {
    table.answers.push_back(
        {.participant = answers.participant.levelOfAnswer[i],
         .method = answers.method.levelOfAnswer[i],
         .round = answers.round.levelOfAnswer[i],
         .position = 1,
         .score = static_cast<int>(answers.scores[i])});
  }
  return table;
}

void expectDifference(const analysis::WithinComparison& row, double difference) {
  SCOPED_TRACE(row.group1 + " - " + row.group2);
  const auto& paired = row.test("paired_t");
  const auto& rank = row.test("signed_rank");
  const auto& mixed = row.test("mixed_model");
  const auto& ordinal = row.test("ordinal_model");
  EXPECT_NEAR(paired.estimate.value.value(), difference, 1e-12);
  EXPECT_NEAR(mixed.estimate.value.value(), difference, 1e-9)
      << "balanced, so the same as the means'";
  EXPECT_GT(mixed.statistic.value.value() * difference, 0.0);
  for (const auto& test : row.tests) {
    EXPECT_EQ(test.group1, row.group1);
    EXPECT_EQ(test.group2, row.group2);
  }
  ASSERT_TRUE(ordinal.p) << base::describe(ordinal.reason);
  EXPECT_GT(ordinal.estimate.value.value() * difference, 0.0);
  EXPECT_EQ(ordinal.effect.value.value() > 1.0, difference > 0.0);
  EXPECT_GT(rank.estimate.value.value() * difference, 0.0);
  EXPECT_GT(paired.effect.value.value() * difference, 0.0);
  EXPECT_GT(rank.effect.value.value() * difference, 0.0);
  EXPECT_LT(paired.interval->low, difference);
  EXPECT_GT(paired.interval->high, difference);
}

TEST(WithinAnalysis, SubtractsTheSecondMethodFromTheFirstInEveryTest) {
  const std::vector<analysis::DeclaredPair> pairs{
      {"interpolation", "fem"},
      {"fem", "interpolation"},
      {"kalman", "interpolation"},
      {"kalman", "fem"}};
  const auto result = analysis::compareWithin(professionals(), pairs, {});
  ASSERT_EQ(result.rows.size(), 4U);
  expectDifference(result.rows[0], 51.0 / 36.0);
  expectDifference(result.rows[1], -51.0 / 36.0);
  expectDifference(result.rows[2], -31.0 / 36.0);
  expectDifference(result.rows[3], 20.0 / 36.0);
}

}  // namespace within_analysis_test

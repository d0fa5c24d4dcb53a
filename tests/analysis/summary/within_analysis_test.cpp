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
  EXPECT_NEAR(row.paired.meanDifference.value(), difference, 1e-12);
  EXPECT_NEAR(row.mixed.estimate, difference, 1e-9) << "balanced, so the same as the means'";
  EXPECT_GT(row.mixed.t.value() * difference, 0.0);
  EXPECT_EQ(row.mixed.name, row.group1 + " - " + row.group2);
  ASSERT_TRUE(row.ordinal.has_value()) << base::describe(row.ordinalReason);
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

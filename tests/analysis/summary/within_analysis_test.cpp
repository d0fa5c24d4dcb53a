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
         .score = answers.scores[i]});
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

// R: ordinal::clmm, clmm_prof_from_4 of tests/data/stats/study/study_golden.json
TEST(WithinAnalysis, HasTheProbabilityOfAnswersAboveTheMiddleOfEachMethod) {
  const auto result = analysis::compareWithin(professionals(), {}, {});
  ASSERT_EQ(result.probabilities.size(), 3U);
  const std::vector<std::string> methods{"interpolation", "fem", "kalman"};
  const std::vector<double> shares{26.0 / 36.0, 12.0 / 36.0, 18.0 / 36.0};
  const std::vector<double> probabilities{0.7148, 0.3072, 0.4519};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& row = result.probabilities[i];
    EXPECT_EQ(row.id, "answer_probability");
    EXPECT_EQ(row.group1, methods[i]);
    EXPECT_EQ(row.n1, 36U);
    EXPECT_EQ(row.additionalNumber("from"), 4.0);
    EXPECT_DOUBLE_EQ(row.statistic.value.value(), shares[i]);
    EXPECT_NEAR(row.effect.value.value(), probabilities[i], 1e-3);
    EXPECT_LT(row.effectInterval->low, row.effect.value);
    EXPECT_GT(row.effectInterval->high, row.effect.value);
    EXPECT_FALSE(row.p);
  }
}

TEST(WithinAnalysis, TestsNothingWhereOnePersonAnswered) {
  auto table = professionals();
  std::erase_if(table.answers, [](const auto& answer) { return answer.participant > 0; });
  const std::vector<analysis::DeclaredPair> pairs{{"interpolation", "fem"}};
  const auto result = analysis::compareWithin(table, pairs, {});
  EXPECT_FALSE(result.overall.empty());
  auto tests = result.overall;
  for (const auto& test : result.rows.at(0).tests) {
    if (test.isInFamily) tests.push_back(test);
  }
  for (const auto& test : tests) {
    EXPECT_FALSE(test.p) << test.id;
    EXPECT_FALSE(test.reason.empty()) << test.id;
  }
}

TEST(WithinAnalysis, SaysWhyThereIsNoProbability) {
  auto table = professionals();
  for (auto& answer : table.answers)
    answer.score = 1 + static_cast<int>(answer.score) % 3;  // nobody answers 4 or 5
  const auto none = analysis::compareWithin(table, {}, {});
  for (const auto& row : none.probabilities) {
    EXPECT_FALSE(row.effect.value);
    EXPECT_EQ(row.statistic.value, 0.0);
    EXPECT_EQ(row.reason, analysis::reason("one_side_of_level", 4));
  }
  for (auto& answer : table.answers) answer.score = 5;
  const auto same = analysis::compareWithin(table, {}, {});
  ASSERT_EQ(same.probabilities.size(), 3U);
  EXPECT_EQ(same.probabilities[0].reason, analysis::reason("all_answers_same"));
  EXPECT_EQ(same.probabilities[0].statistic.value, 1.0);
}

}  // namespace within_analysis_test

#include <gtest/gtest.h>

#include "analysis/summary/answer_checks.h"

namespace analysis {
namespace position_effect_test {

/// Everybody judges both methods; the scores stand by participant: of A, then of B.
AnswerTable table(const std::vector<std::pair<int, int>>& scores, bool isCrossed) {
  AnswerTable table{
      .lowest = 1, .highest = 7, .methods = {"A", "B"}, .rounds = {"1"}, .statements = {"s"}};
  for (std::size_t i = 0; i < scores.size(); ++i) {
    table.participants.push_back("P" + std::to_string(i));
    const int first = isCrossed && i % 2 == 1 ? 2 : 1;
    table.answers.push_back(
        {.participant = i, .method = 0, .position = first, .score = double(scores[i].first)});
    table.answers.push_back(
        {.participant = i, .method = 1, .position = 3 - first, .score = double(scores[i].second)});
  }
  return table;
}

TEST(PositionEffect, FindsThatLaterPositionsAreRatedHigher) {
  // Second is one point above first, whichever it is; B is two above A.
  const auto effect = positionEffect(table({{2, 5}, {3, 4}, {3, 6}, {4, 5}}, true));
  ASSERT_EQ(effect.positions.size(), 2U);
  EXPECT_EQ(effect.positions[0].participants, 4U);
  EXPECT_NEAR(effect.positions[0].mean, 3.5, 1e-12);
  EXPECT_NEAR(effect.positions[1].mean, 4.5, 1e-12);
  EXPECT_NEAR(*effect.slope.meanDifference, 1.0, 1e-12);
}

TEST(PositionEffect, HasStudentsIntervalOfTheSlopes) {
  // Slopes of the four: residuals (A: 2 3 3 5, mean 3.25; B: 5 4 6 5, mean 5).
  const auto effect = positionEffect(table({{2, 5}, {3, 4}, {3, 6}, {5, 5}}, true));
  // By hand: 1.25, 0.75, 1.25, 1.75; mean 1.25, s = 0.408248, t = 1.25 / 0.204124.
  EXPECT_NEAR(*effect.slope.meanDifference, 1.25, 1e-12);
  EXPECT_NEAR(*effect.slope.t, 6.123724356957945, 1e-12);
  // R 4.2: 1.25 + c(-1, 1) * qt(.975, 3) * 0.2041241452319315
  EXPECT_NEAR(effect.slopeInterval->low, 0.600385868187445, 1e-12);
  EXPECT_NEAR(effect.slopeInterval->high, 1.899614131812555, 1e-12);
}

TEST(PositionEffect, TakesRoundingErrorsForNoSlope) {
  auto scores = table({{1, 2}, {1, 2}, {1, 2}, {1, 2}, {1, 2}, {1, 2}}, true);
  for (auto& answer : scores.answers) answer.score += answer.method == 0 ? 0.1 : 1.0 / 3.0;
  const auto effect = positionEffect(scores);
  EXPECT_EQ(effect.slope.meanDifference, 0.0);
  EXPECT_FALSE(effect.slope.p);
  EXPECT_FALSE(effect.slopeInterval);
  EXPECT_EQ(effect.slope.reason.key(), "pairs_equal");
}

TEST(PositionEffect, ReportsThatOrderAndMethodAreConfounded) {
  const auto effect = positionEffect(table({{2, 5}, {3, 7}, {4, 4}}, false));
  EXPECT_TRUE(effect.positions.empty());
  EXPECT_FALSE(effect.slope.p);
  EXPECT_FALSE(effect.slopeInterval);
  EXPECT_EQ(effect.slope.reason.key(), "one_position_each");
}

TEST(PositionEffect, IsEmptyWithoutParticipants) {
  const auto effect = positionEffect(table({}, true));
  EXPECT_TRUE(effect.positions.empty());
  EXPECT_FALSE(effect.slope.p);
  EXPECT_FALSE(effect.slopeInterval);
}

}  // namespace position_effect_test
}  // namespace analysis

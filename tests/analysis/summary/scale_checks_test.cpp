#include <gtest/gtest.h>

#include "analysis/summary/answer_checks.h"

namespace analysis {
namespace scale_checks_test {

AnswerTable threeStatements() {
  // Five people, three statements about one method.
  const std::vector<std::vector<int>> scores{{1, 2, 1}, {2, 2, 3}, {3, 3, 3}, {4, 3, 5}, {5, 5, 4}};
  AnswerTable table{.methods = {"A", "B"}, .rounds = {"1", "2"}, .statements = {"x", "y", "z"}};
  for (std::size_t i = 0; i < scores.size(); ++i) {
    table.participants.push_back("P" + std::to_string(i));
    for (std::size_t j = 0; j < 3; ++j) {
      table.answers.push_back(
          {.participant = i, .method = 0, .statement = j, .score = double(scores[i][j])});
    }
  }
  return table;
}

TEST(ScaleChecks, UsesTheStatementsAboutAMethodAsItems) {
  const auto checks = scaleChecks(threeStatements());
  ASSERT_EQ(checks.methods.size(), 2U);
  const auto& alpha = checks.methods[0].alpha;
  EXPECT_EQ(alpha.items, 3U);
  EXPECT_EQ(alpha.respondents, 5U);
  // Variances 2.5, 1.5, 2.2; of the sums 4 7 9 12 14: 15.7; 1.5 (1 - 6.2 / 15.7).
  EXPECT_NEAR(*alpha.value, 1.5 * (1.0 - 6.2 / 15.7), 1e-12);
  EXPECT_EQ(checks.methods[0].normality.n, 5U);
}

TEST(ScaleChecks, LeavesOutParticipantsWithAMissingStatement) {
  auto table = threeStatements();
  table.answers.pop_back();
  EXPECT_EQ(scaleChecks(table).methods[0].alpha.respondents, 4U);
}

TEST(ScaleChecks, AveragesAStatementOverRounds) {
  auto table = threeStatements();
  const auto once = *scaleChecks(table).methods[0].alpha.value;
  for (std::size_t i = 0, n = table.answers.size(); i < n; ++i) {
    auto again = table.answers[i];
    again.round = 1;
    table.answers.push_back(again);
  }
  EXPECT_NEAR(*scaleChecks(table).methods[0].alpha.value, once, 1e-12);
}

TEST(ScaleChecks, GivesAReasonForAMethodWithoutAnswers) {
  const auto checks = scaleChecks(threeStatements());
  EXPECT_FALSE(checks.methods[1].alpha.value);
  EXPECT_FALSE(checks.methods[1].alpha.reason.empty());
  EXPECT_FALSE(checks.spread.p);
}

}  // namespace scale_checks_test
}  // namespace analysis

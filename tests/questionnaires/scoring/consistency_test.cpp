#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "questionnaires/scoring/scoring.h"

namespace questionnaires {
namespace consistency_test {

/// 1…7; b is turned round.
Instrument twoScales() {
  const Scale seven{.lowest = 1, .points = 7};
  return {
      .items =
          {{.id = "a", .scale = seven},
           {.id = "b", .key = -1, .scale = seven},
           {.id = "c", .scale = seven},
           {.id = "d", .scale = seven}},
      .scores = {{.id = "first", .items = {"a", "b"}}, {.id = "second", .items = {"c", "d"}}},
      .consistency =
          ConsistencyRule{.scores = {"first", "second"}, .widestRange = 3.0, .suspiciousFrom = 2}};
}

std::vector<Answer> given(std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d) {
  return {{"a", a}, {"b", b}, {"c", c}, {"d", d}};
}

TEST(Consistency, ReportsNothingWithoutARule) {
  EXPECT_FALSE(consistencyOf(Instrument{}, {}).has_value());
}

TEST(Consistency, LooksAtKeyedAnswers) {
  EXPECT_TRUE(consistencyOf(twoScales(), given(7, 1, 4, 4))->contradictoryScores.empty());
  EXPECT_EQ(
      consistencyOf(twoScales(), given(7, 7, 4, 4))->contradictoryScores,
      std::vector<std::string>{"first"});
}

TEST(Consistency, AllowsTheWidestRangeItself) {
  EXPECT_TRUE(consistencyOf(twoScales(), given(4, 4, 1, 4))->contradictoryScores.empty());
  EXPECT_EQ(consistencyOf(twoScales(), given(4, 4, 1, 5))->contradictoryScores.size(), 1U);
}

TEST(Consistency, WarnsFromSoManyContradictionsOn) {
  const auto one = consistencyOf(twoScales(), given(7, 7, 4, 4));
  EXPECT_FALSE(one->isSuspicious);
  EXPECT_EQ(one->warning, "");
  const auto two = consistencyOf(twoScales(), given(7, 7, 1, 7));
  EXPECT_TRUE(two->isSuspicious);
  EXPECT_EQ(two->warning.find("in 2 of 2 scales the answers lie more than 3 apart"), 0U);
}

TEST(Consistency, FindsNoContradictionInFewerThanTwoAnswers) {
  EXPECT_TRUE(consistencyOf(twoScales(), {{"a", std::int64_t{7}}})->contradictoryScores.empty());
  EXPECT_TRUE(consistencyOf(twoScales(), {})->contradictoryScores.empty());
}

}  // namespace consistency_test
}  // namespace questionnaires

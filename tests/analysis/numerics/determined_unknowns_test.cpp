#include "analysis/numerics/determined_unknowns.h"

#include <gtest/gtest.h>

namespace analysis {
namespace determined_unknowns_test {

TEST(DeterminedUnknowns, AreThoseOfSingleValuesAndOfSumsThatDifferByOne) {
  EXPECT_EQ(determinedUnknowns({}), 0U);
  EXPECT_EQ(determinedUnknowns({{}}), 0U);
  EXPECT_EQ(determinedUnknowns({{0, 0, 0}}), 0U);
  EXPECT_EQ(determinedUnknowns({{0, 1, 0}}), 1U);
  EXPECT_EQ(determinedUnknowns({{1, 1, 1}}), 0U);
  EXPECT_EQ(determinedUnknowns({{1, 1, 1}, {1, 1, 0}}), 1U);
  EXPECT_EQ(determinedUnknowns({{1, 1, 1}, {1, 1, 1}, {2, 2, 2}}), 0U);
}

TEST(DeterminedUnknowns, AreFoundWhereOnlyAllEquationsTogetherShowThem) {
  EXPECT_EQ(determinedUnknowns({{1, 1, 0, 0}, {1, 0, 1, 0}}), 0U);
  EXPECT_EQ(determinedUnknowns({{1, 1, 0, 0}, {1, 0, 1, 0}, {0, 1, 1, 0}}), 3U);
  EXPECT_EQ(determinedUnknowns({{1, 1, 1, 1}, {1, 1, 0, 0}, {0, 0, 1, 1}}), 0U);
  EXPECT_EQ(determinedUnknowns({{1, 1, 1, 1}, {1, 1, 0, 0}, {0, 0, 1, 0}}), 2U);
}

}  // namespace determined_unknowns_test
}  // namespace analysis

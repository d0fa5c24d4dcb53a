#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "analysis/hypothesis_tests/anova.h"
#include "analysis/hypothesis_tests/t_tests.h"

namespace repeated_measures_anova_test {

using analysis::repeatedMeasuresAnova;
using Table = std::vector<std::vector<double>>;

TEST(RepeatedMeasuresAnova, OfTwoConditionsIsThePairedTest) {
  const auto anova = repeatedMeasuresAnova(Table{{3, 1}, {4, 4}, {5, 2}, {2, 1}, {4, 5}});
  const auto paired =
      analysis::pairedTTest(std::vector<double>{3, 4, 5, 2, 4}, std::vector<double>{1, 4, 2, 1, 5});

  EXPECT_NEAR(anova.f.value(), *paired.t * *paired.t, 1e-14);
  EXPECT_NEAR(anova.p.value(), *paired.p, 1e-14);
  EXPECT_DOUBLE_EQ(anova.greenhouseGeisser.value(), 1.0);
  EXPECT_DOUBLE_EQ(anova.pGreenhouseGeisser.value(), *anova.p);
}

TEST(RepeatedMeasuresAnova, DoesNotDependOnOffsetsOfParticipantsAndUnits) {
  const auto plain = repeatedMeasuresAnova(Table{{3, 1, 2}, {4, 4, 1}, {5, 2, 2}, {2, 1, 3}});
  const auto moved =
      repeatedMeasuresAnova(Table{{1e9 + 3, 1e9 + 1, 1e9 + 2}, {4, 4, 1}, {-5, -8, -8}, {2, 1, 3}});
  const auto tiny = repeatedMeasuresAnova(Table{
      {3e-200, 1e-200, 2e-200},
      {4e-200, 4e-200, 1e-200},
      {5e-200, 2e-200, 2e-200},
      {2e-200, 1e-200, 3e-200}});

  EXPECT_NEAR(moved.f.value(), plain.f.value(), 1e-13);
  EXPECT_NEAR(moved.greenhouseGeisser.value(), plain.greenhouseGeisser.value(), 1e-13);
  EXPECT_NEAR(tiny.f.value(), plain.f.value(), 1e-13);
}

TEST(RepeatedMeasuresAnova, HasTheSmallestEpsilonIfOneContrastHasAllTheSpread) {
  // every participant's residuals are a multiple of (1, −1, 0): ε = 1 / (k − 1)
  const auto result = repeatedMeasuresAnova(Table{{1, -1, 0}, {2, -2, 0}, {-1, 1, 0}, {5, -5, 0}});
  EXPECT_NEAR(result.greenhouseGeisser.value(), 0.5, 1e-15);
  EXPECT_GT(result.pGreenhouseGeisser.value(), result.p.value());
}

TEST(RepeatedMeasuresAnova, GivesAReasonIfItIsUndefined) {
  const auto alike = repeatedMeasuresAnova(Table{{1, 2, 3}, {4, 5, 6}});
  EXPECT_EQ(alike.f, INFINITY);
  EXPECT_FALSE(alike.p.has_value());
  EXPECT_EQ(alike.partialEtaSquared, 1.0);
  EXPECT_FALSE(alike.reason.empty());

  const auto flat = repeatedMeasuresAnova(Table{{0.1, 0.1, 0.1}, {0.3, 0.3, 0.3}});
  EXPECT_FALSE(flat.f.has_value());
  EXPECT_FALSE(flat.partialEtaSquared.has_value());
  EXPECT_EQ(flat.reason.key(), "conditions_not_told_apart");

  EXPECT_EQ(repeatedMeasuresAnova(Table{}).reason.key(), "two_participants_needed");
  EXPECT_EQ(repeatedMeasuresAnova(Table{{1, 2}}).reason.key(), "two_participants_needed");
  EXPECT_EQ(repeatedMeasuresAnova(Table{{1}, {2}}).reason.key(), "two_conditions_needed");
}

TEST(RepeatedMeasuresAnova, RefusesAnIncompleteTable) {
  EXPECT_THROW(repeatedMeasuresAnova(Table{{1, 2}, {1}}), std::invalid_argument);
  EXPECT_THROW(repeatedMeasuresAnova(Table{{1, 2}, {1, NAN}}), std::invalid_argument);
}

}  // namespace repeated_measures_anova_test

#include "analysis/models/fixed_effects.h"

#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace fixed_effects_test {

using analysis::FixedEffects;
using Numbers = std::vector<double>;

const std::vector<std::string> kMethod{"kalman", "fem", "interpolation", "fem"};
const std::vector<std::string> kRound{"1", "1", "2", "2"};
const std::vector<std::string> kOrder{"interpolation", "fem", "other", "kalman"};

Numbers columnOf(const FixedEffects& fixed, std::size_t column) {
  const auto values = fixed.column(column);
  return {values.begin(), values.end()};
}

FixedEffects design() {
  FixedEffects fixed(4);
  fixed.add(analysis::factorOf("method", kMethod, kOrder));
  fixed.add(analysis::factorOf("round", kRound));
  return fixed;
}

TEST(Factor, KeepsTheOrderOfAppearanceOrADeclaredOne) {
  using Levels = std::vector<std::string>;
  EXPECT_EQ(
      analysis::factorOf("method", kMethod).levels, (Levels{"kalman", "fem", "interpolation"}));
  const auto declared = analysis::factorOf("method", kMethod, kOrder);
  EXPECT_EQ(declared.levels, (Levels{"interpolation", "fem", "kalman"}));
  EXPECT_EQ(declared.levelOfAnswer, (std::vector<std::size_t>{2, 1, 0, 1}));
  EXPECT_THROW(analysis::factorOf("method", kMethod, kRound), std::invalid_argument);
}

TEST(Factor, CrossesOnlyCombinationsThatOccur) {
  const auto cells =
      interactionOf(analysis::factorOf("method", kMethod), analysis::factorOf("round", kRound));
  EXPECT_EQ(cells.name, "method:round");
  EXPECT_EQ(
      cells.levels, (std::vector<std::string>{"kalman:1", "fem:1", "interpolation:2", "fem:2"}));
  EXPECT_THROW(interactionOf(cells, analysis::Factor{}), std::invalid_argument);
}

TEST(FixedEffects, AreCodedByTreatment) {
  const auto fixed = design();
  ASSERT_EQ(fixed.columns(), 4U);
  EXPECT_EQ(fixed.name(0), "(Intercept)");
  EXPECT_EQ(fixed.name(1), "method fem");
  EXPECT_EQ(fixed.name(3), "round 2");
  EXPECT_EQ(columnOf(fixed, 0), (Numbers{1, 1, 1, 1}));
  EXPECT_EQ(columnOf(fixed, 1), (Numbers{0, 1, 0, 1}));
  EXPECT_EQ(columnOf(fixed, 2), (Numbers{1, 0, 0, 0}));
  EXPECT_EQ(columnOf(fixed, 3), (Numbers{0, 0, 1, 1}));
}

TEST(FixedEffects, WeighADifferenceByTheColumnsOfItsLevels) {
  const auto fixed = design();
  EXPECT_EQ(fixed.difference("method", "interpolation", "kalman"), (Numbers{0, 0, -1, 0}));
  EXPECT_EQ(fixed.difference("method", "fem", "kalman"), (Numbers{0, 1, -1, 0}));
  EXPECT_EQ(fixed.difference("round", "2", "1"), (Numbers{0, 0, 0, 1}));
}

TEST(FixedEffects, RejectInvalidFactors) {
  auto fixed = design();
  EXPECT_THROW(fixed.add(analysis::factorOf("round", kRound)), std::invalid_argument);
  EXPECT_THROW(fixed.add(analysis::Factor{}), std::invalid_argument);
  EXPECT_THROW(fixed.difference("method", "fem", "other"), std::invalid_argument);
  EXPECT_THROW(fixed.factor("cohort"), std::invalid_argument);
}

TEST(FixedEffects, CombineALevelWithAllLevelsOfOtherFactors) {
  const auto fixed = design();
  using Rows = std::vector<Numbers>;
  EXPECT_EQ(fixed.combinations("method", "interpolation"), (Rows{{1, 0, 0, 0}, {1, 0, 0, 1}}));
  EXPECT_EQ(fixed.combinations("method", "kalman"), (Rows{{1, 0, 1, 0}, {1, 0, 1, 1}}));
  EXPECT_EQ(fixed.combinations("round", "2"), (Rows{{1, 0, 0, 1}, {1, 1, 0, 1}, {1, 0, 1, 1}}));
  EXPECT_THROW(fixed.combinations("method", "other"), std::invalid_argument);
  EXPECT_THROW(fixed.combinations("cohort", "a"), std::invalid_argument);
}

}  // namespace fixed_effects_test

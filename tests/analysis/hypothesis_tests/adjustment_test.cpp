#include "analysis/hypothesis_tests/adjustment.h"

#include <cmath>
#include <stdexcept>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace adjustment_test {

using analysis::adjust;
using analysis::Adjustment;
using PValues = std::vector<std::optional<double>>;

TEST(Adjustment, MultipliesByTheNumberOfTests) {
  // R: p.adjust(c(.01, .02, .04), "bonferroni")
  const auto adjusted = adjust(PValues{0.01, 0.02, 0.04});

  EXPECT_DOUBLE_EQ(adjusted[0].value(), 0.03);
  EXPECT_DOUBLE_EQ(adjusted[1].value(), 0.06);
  EXPECT_DOUBLE_EQ(adjusted[2].value(), 0.12);
}

TEST(Adjustment, NeverExceedsOne) {
  EXPECT_EQ(adjust(PValues{0.4, 0.5, 0.6}).back(), 1.0);
}

TEST(Adjustment, DoesNotCountTestsWithoutAPValue) {
  const auto adjusted = adjust(PValues{0.01, std::nullopt, 0.2});

  EXPECT_DOUBLE_EQ(adjusted[0].value(), 0.02);
  EXPECT_FALSE(adjusted[1].has_value());
  EXPECT_DOUBLE_EQ(adjusted[2].value(), 0.4);
}

TEST(Adjustment, KeepsTheSmallestPValues) {
  EXPECT_EQ(adjust(PValues{0.0, 5e-324}), (PValues{0.0, 1e-323}));
}

TEST(Adjustment, OfNoTestsIsEmpty) {
  EXPECT_TRUE(adjust(PValues{}).empty());
  EXPECT_EQ(adjust(PValues{std::nullopt}), PValues{std::nullopt});
}

TEST(Adjustment, RefusesInvalidProbabilities) {
  EXPECT_THROW(adjust(PValues{1.5}), std::invalid_argument);
  EXPECT_THROW(adjust(PValues{-0.1}), std::invalid_argument);
  EXPECT_THROW(adjust(PValues{std::nan("")}), std::invalid_argument);
}

TEST(Adjustment, IsNamedAsInAFile) {
  const std::vector<std::string_view> names{
      "bonferroni", "holm", "hochberg", "hommel", "bh", "by", "holm-sidak"};
  ASSERT_EQ(names.size(), analysis::kAdjustments.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    EXPECT_EQ(nameOf(analysis::kAdjustments[i]), names[i]);
  }
}

TEST(Adjustment, OfTheStepwiseKindsIsThatOfTheirDefinition) {
  const PValues p{0.04, 0.01, 0.03};  // in order: .01, .03, .04

  const auto expectAll = [&](Adjustment method, double first, double second, double third) {
    SCOPED_TRACE(nameOf(method));
    const auto adjusted = adjust(p, method);
    EXPECT_DOUBLE_EQ(adjusted[0].value(), first);
    EXPECT_DOUBLE_EQ(adjusted[1].value(), second);
    EXPECT_DOUBLE_EQ(adjusted[2].value(), third);
  };
  expectAll(Adjustment::Holm, 0.06, 0.03, 0.06);               // 3 · .01; 2 · .03
  expectAll(Adjustment::Hochberg, 0.04, 0.03, 0.04);           // 1 · .04 is less than 2 · .03
  expectAll(Adjustment::BenjaminiHochberg, 0.04, 0.03, 0.04);  // 3/1 · .01; 3/3 · .04
  expectAll(Adjustment::HolmSidak, 0.0591, 0.029701, 0.0591);  // 1 − .99³; 1 − .97²
}

TEST(Adjustment, IsTheSameForOneTestByEveryMethod) {
  for (const auto method : analysis::kAdjustments) {
    for (const double p : {0.0, 0.04, 1.0}) {
      EXPECT_DOUBLE_EQ(adjust(PValues{p, std::nullopt}, method)[0].value(), p) << nameOf(method);
    }
  }
}

TEST(Adjustment, OrdersTheMethodsAsTheirTheoryDoes) {
  const PValues p{0.012, 0.3, 0.001, 0.04, 0.018, 0.9, 0.02};
  const auto holm = adjust(p, Adjustment::Holm);
  const auto hochberg = adjust(p, Adjustment::Hochberg);
  const auto hommel = adjust(p, Adjustment::Hommel);
  const auto discoveries = adjust(p, Adjustment::BenjaminiHochberg);
  for (std::size_t i = 0; i < p.size(); ++i) {
    EXPECT_LE(holm[i], adjust(p)[i]);
    EXPECT_LE(hochberg[i], holm[i]);
    EXPECT_LE(hommel[i], hochberg[i]);
    EXPECT_LE(discoveries[i], hommel[i]);
    EXPECT_GE(discoveries[i], p[i]);
  }
}

TEST(Adjustment, KeepsTheSmallestPValuesByEveryMethod) {
  for (const auto method : analysis::kAdjustments) {
    const auto adjusted = adjust(PValues{1e-300, 0.5, 1e-310}, method);
    EXPECT_GT(adjusted[0].value(), 0.0) << nameOf(method);
    EXPECT_GT(adjusted[2].value(), 0.0) << nameOf(method);
    EXPECT_LE(adjusted[0].value(), 1e-299) << nameOf(method);
  }
}

TEST(Adjustment, SharesAlphaAmongTheTests) {
  EXPECT_DOUBLE_EQ(analysis::alphaPerTest(0.05, 3), 0.05 / 3.0);
  EXPECT_THROW(analysis::alphaPerTest(0.05, 0), std::invalid_argument);
  EXPECT_THROW(analysis::alphaPerTest(1.0, 3), std::invalid_argument);
  EXPECT_THROW(analysis::alphaPerTest(std::nan(""), 3), std::invalid_argument);
}

}  // namespace adjustment_test

#include "analysis/adjustment.h"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace {

using analysis::adjust;
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

TEST(Adjustment, DoesNotCountWhatHasNoPValue) {
  const auto adjusted = adjust(PValues{0.01, std::nullopt, 0.2});

  EXPECT_DOUBLE_EQ(adjusted[0].value(), 0.02);
  EXPECT_FALSE(adjusted[1].has_value());
  EXPECT_DOUBLE_EQ(adjusted[2].value(), 0.4);
}

TEST(Adjustment, KeepsTheSmallestPValues) {
  EXPECT_EQ(adjust(PValues{0.0, 5e-324}), (PValues{0.0, 1e-323}));
}

TEST(Adjustment, OfNothingIsNothing) {
  EXPECT_TRUE(adjust(PValues{}).empty());
  EXPECT_EQ(adjust(PValues{std::nullopt}), PValues{std::nullopt});
}

TEST(Adjustment, RefusesWhatIsNoProbability) {
  EXPECT_THROW(adjust(PValues{1.5}), std::invalid_argument);
  EXPECT_THROW(adjust(PValues{-0.1}), std::invalid_argument);
  EXPECT_THROW(adjust(PValues{std::nan("")}), std::invalid_argument);
}

TEST(Adjustment, SharesAlphaAmongTheTests) {
  EXPECT_DOUBLE_EQ(analysis::alphaPerTest(0.05, 3), 0.05 / 3.0);
  EXPECT_THROW(analysis::alphaPerTest(0.05, 0), std::invalid_argument);
  EXPECT_THROW(analysis::alphaPerTest(1.0, 3), std::invalid_argument);
  EXPECT_THROW(analysis::alphaPerTest(std::nan(""), 3), std::invalid_argument);
}

}  // namespace

#include "analysis/data/two_way_layout.h"

#include <stdexcept>

#include <gtest/gtest.h>

namespace two_way_layout_test {

using analysis::twoWayLayout;
using Table = std::vector<std::vector<double>>;

TEST(TwoWayLayout, HasTheMeanSquaresOfShroutAndFleiss) {
  // Shrout & Fleiss 1979, tables 2 and 3: B = 11.24, W = 6.26, J = 32.49, E = 1.02
  const auto layout = twoWayLayout(
      Table{{9, 2, 5, 8}, {6, 1, 3, 2}, {8, 4, 6, 8}, {7, 1, 2, 6}, {10, 5, 6, 9}, {6, 2, 4, 7}});
  const double residual = layout.residualMeanSquare().high;

  EXPECT_NEAR(layout.rowMeanSquare().high / residual, 11.24 / 1.02, 0.06);
  EXPECT_NEAR(layout.withinMeanSquare().high / residual, 6.26 / 1.02, 0.04);
  EXPECT_NEAR(layout.columnMeanSquare().high / residual, 32.49 / 1.02, 0.16);
}

TEST(TwoWayLayout, HasNoResidualsWhereRowsAndColumnsAddUp) {
  Table table;
  for (const double row : {0.1, 0.7, 1e6, -3.3}) {
    table.push_back({row, row, row});
  }
  EXPECT_TRUE(twoWayLayout(table).residualSquares.isZero());
  EXPECT_TRUE(twoWayLayout(table).columnSquares.isZero());
  EXPECT_FALSE(twoWayLayout(table).rowSquares.isZero());
}

TEST(TwoWayLayout, TakesRoundingErrorsForNoSpread) {
  const auto shifted = twoWayLayout(Table{{0.3, 0.1}, {0.6, 0.4}, {1.1, 0.9}, {2.3, 2.1}});
  EXPECT_TRUE(shifted.residualSquares.isZero());
  EXPECT_TRUE(shifted.residuals.front().isZero());
  EXPECT_FALSE(shifted.columnSquares.isZero());
  EXPECT_TRUE(twoWayLayout(Table{{0.1 + 0.2, 0.3}, {0.7, 0.8 - 0.1}}).columnSquares.isZero());
  EXPECT_FALSE(twoWayLayout(Table{{1.0, 1.0 + 1e-13}, {1.0, 1.0}}).residualSquares.isZero());
}

TEST(TwoWayLayout, MayBeEmpty) {
  EXPECT_EQ(twoWayLayout(Table{}).rows, 0U);
  EXPECT_EQ(twoWayLayout(Table{{}, {}}).columns, 0U);
}

TEST(TwoWayLayout, RejectsAnIncompleteTable) {
  EXPECT_THROW(twoWayLayout(Table{{1, 2}, {1, 2, 3}}), std::invalid_argument);
}

}  // namespace two_way_layout_test

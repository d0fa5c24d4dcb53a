#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "analysis/numerics/exact_arithmetic.h"

namespace analysis {

/// A complete table of one value per row and column, and its sums of squares.
///
///     Σ (x − x̄)² = rowSquares + columnSquares + residualSquares
///
/// Rows are participants or blocks, columns are conditions, items or raters. All sums are
/// multiplied by (rows · columns)², and nothing is divided: if there is no spread, or none but
/// rounding errors of the values (isRoundingError()), a sum is exactly 0.
struct TwoWayLayout {
  std::size_t rows = 0;
  std::size_t columns = 0;
  DoubleDouble rowSquares;
  DoubleDouble columnSquares;
  DoubleDouble residualSquares;
  /// The residuals of the additive model, row by row, multiplied by rows · columns.
  std::vector<DoubleDouble> residuals;

  /// Mean squares, in the units of the sums of squares. @pre at least two rows and two columns.
  DoubleDouble rowMeanSquare() const;
  DoubleDouble columnMeanSquare() const;
  DoubleDouble residualMeanSquare() const;
  /// Mean square within rows: columns and residuals pooled.
  DoubleDouble withinMeanSquare() const;
};

/// The values are scaled by a power of two, so that their squares fit into a double: only ratios of
/// the sums of squares are meaningful.
///
/// @throws std::invalid_argument  if a row has fewer or more values than the first, or a value is
///     infinite or NaN.
TwoWayLayout twoWayLayout(std::span<const std::vector<double>> table);

}  // namespace analysis

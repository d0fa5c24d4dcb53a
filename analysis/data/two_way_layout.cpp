#include "analysis/data/two_way_layout.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace analysis {
namespace {

/// The power of two that scales the largest magnitude to about one, limited to the range of a
/// double.
double unitOf(std::span<const std::vector<double>> table) {
  double largest = 0.0;
  for (const auto& row : table) {
    if (row.size() != table.front().size()) {
      throw std::invalid_argument("every row of a table has as many values as the first");
    }
    for (const double value : row) {
      if (!std::isfinite(value)) throw std::invalid_argument("a value is infinite or no number");
      largest = std::max(largest, std::abs(value));
    }
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  constexpr int kSmallest = -1000;
  return std::ldexp(1.0, -std::max(exponent, kSmallest));
}

double asDouble(std::size_t count) {
  return static_cast<double>(count);
}

using Table = std::vector<std::vector<DoubleDouble>>;

/// All values minus the first one, so that a common offset loses no digits.
Table shiftedValues(std::span<const std::vector<double>> table) {
  const double unit = unitOf(table);
  const double pivot = table.front().front() * unit;
  Table shifted;
  shifted.reserve(table.size());
  for (const auto& row : table) {
    auto& values = shifted.emplace_back();
    for (const double value : row) {
      values.push_back(DoubleDouble::difference(value * unit, pivot));
    }
  }
  return shifted;
}

/// The sum of squares of effects; makes them zero if rounding errors are all that they are.
/// @param cells  by which the effects are multiplied. The values are of size one.
DoubleDouble squaresOf(std::vector<DoubleDouble>& effects, double cells) {
  const auto isNoise = [&](const DoubleDouble& effect) {
    return isRoundingError(effect.high, cells);
  };
  if (std::ranges::all_of(effects, isNoise)) std::ranges::fill(effects, DoubleDouble());
  DoubleDouble squares;
  for (const auto& effect : effects) squares = squares + effect * effect;
  return squares;
}

/// count · sum − total for each of @p sums.
std::vector<DoubleDouble> effectsOf(
    std::vector<DoubleDouble> sums, double count, const DoubleDouble& total) {
  for (auto& sum : sums) sum = sum * count - total;
  return sums;
}

}  // namespace

DoubleDouble TwoWayLayout::rowMeanSquare() const {
  return rowSquares / asDouble(rows - 1);
}

DoubleDouble TwoWayLayout::columnMeanSquare() const {
  return columnSquares / asDouble(columns - 1);
}

DoubleDouble TwoWayLayout::residualMeanSquare() const {
  return residualSquares / asDouble((rows - 1) * (columns - 1));
}

DoubleDouble TwoWayLayout::withinMeanSquare() const {
  return (columnSquares + residualSquares) / asDouble(rows * (columns - 1));
}

TwoWayLayout twoWayLayout(std::span<const std::vector<double>> table) {
  TwoWayLayout layout;
  layout.rows = table.size();
  layout.columns = table.empty() ? 0 : table.front().size();
  if (layout.rows == 0 || layout.columns == 0) return layout;

  const Table shifted = shiftedValues(table);
  const double rows = asDouble(layout.rows);
  const double columns = asDouble(layout.columns);
  std::vector<DoubleDouble> rowSums(layout.rows);
  std::vector<DoubleDouble> columnSums(layout.columns);
  DoubleDouble total;
  for (std::size_t i = 0; i < layout.rows; ++i) {
    for (std::size_t j = 0; j < layout.columns; ++j) {
      rowSums[i] = rowSums[i] + shifted[i][j];
      columnSums[j] = columnSums[j] + shifted[i][j];
    }
    total = total + rowSums[i];
  }

  auto rowEffects = effectsOf(rowSums, rows, total);
  auto columnEffects = effectsOf(columnSums, columns, total);
  layout.rowSquares = squaresOf(rowEffects, rows * columns) * columns;
  layout.columnSquares = squaresOf(columnEffects, rows * columns) * rows;
  layout.residuals.reserve(layout.rows * layout.columns);
  for (std::size_t i = 0; i < layout.rows; ++i) {
    for (std::size_t j = 0; j < layout.columns; ++j) {
      layout.residuals.push_back(
          shifted[i][j] * (rows * columns) - rowSums[i] * rows - columnSums[j] * columns + total);
    }
  }
  layout.residualSquares = squaresOf(layout.residuals, rows * columns);
  return layout;
}

}  // namespace analysis

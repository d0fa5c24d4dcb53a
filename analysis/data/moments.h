#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "analysis/data/likert_counts.h"
#include "analysis/numerics/exact_arithmetic.h"

namespace analysis {

/// Size, mean and variance of a group, with more digits and a larger range than a double has.
///
/// So two means that agree in their first sixteen digits still differ, and values of 1e-200 still
/// have a variance.
struct Moments {
  std::uint64_t n = 0;
  /// The mean is in units of 2^exponent, the variance in units of 4^exponent.
  int exponent = 0;
  DoubleDouble mean;      ///< [2^exponent]; 0 for n = 0
  DoubleDouble variance;  ///< [4^exponent], divided by n − 1; 0 for n < 2

  /// Whether all values are equal.
  bool isConstant() const noexcept { return variance.isZero(); }
};

/// Computes the moments from the values minus the first value, in double-double arithmetic, with
/// the corrected two-pass variance
///
///     s² = (Σ r² − (Σ r)² / n) / (n − 1),   r = x − m.
///
/// @throws std::invalid_argument  if a value is infinite or NaN.
Moments momentsOf(std::span<const double> values);

/// The exact moments, computed in whole numbers: see LikertCounts::variance().
Moments momentsOf(const LikertCounts& counts);

/// Size, mean and variance of a group, as doubles for a table.
struct Summary {
  std::uint64_t n = 0;
  std::optional<double> mean;      ///< std::nullopt for n = 0
  std::optional<double> variance;  ///< divided by n − 1; std::nullopt for n < 2, or beyond a double
  /// Square root of the variance; may be defined although the variance exceeds the range of a
  /// double.
  std::optional<double> standardDeviation;
};

/// @throws std::invalid_argument  if a value is infinite or NaN.
Summary summarise(std::span<const double> values);
Summary summarise(const Moments& moments);

/// The difference of the means of two groups, and the variance of each group, in common units; for
/// t-tests and effect sizes.
///
/// The units are powers of two, so that scaling neither rounds nor overflows.
struct Contrast {
  int meanExponent = 0;
  DoubleDouble difference;  ///< mean of group 1 − mean of group 2 [2^meanExponent]

  int spreadExponent = 0;
  DoubleDouble variance1;  ///< [4^spreadExponent]
  DoubleDouble variance2;  ///< [4^spreadExponent]
};

Contrast contrastOf(const Moments& group1, const Moments& group2);

/// difference / standardError as a double; ±infinity beyond its range, 0 where the difference is 0.
///
/// @param standardError  [2^spreadExponent]
double tOf(const Contrast& contrast, const DoubleDouble& standardError);

}  // namespace analysis

#pragma once

#include <cstdint>
#include <span>

#include "analysis/data/likert_counts.h"
#include "analysis/numerics/double_double.h"

namespace analysis {

/// How many, how large on average, how scattered: a group as a test sees it, finer than a double
/// and beyond its range.
///
/// Two means that agree in their first sixteen digits still have a difference, and values of
/// 1e-200 still have a variance.
struct Moments {
  std::uint64_t n = 0;
  int exponent = 0;       ///< the powers of two that mean and variance are counted in
  DoubleDouble mean;      ///< [2^exponent]; 0 for n = 0
  DoubleDouble variance;  ///< [4^exponent], with n − 1; 0 for n < 2

  /// All answered with one voice.
  bool isConstant() const noexcept { return variance.isZero(); }
};

/// The values are shifted by the first of them and summed as double-doubles; the variance is the
/// corrected two-pass one,
///
///     s² = (Σ r² − (Σ r)² / n) / (n − 1),   r = x − m.
///
/// @throws std::invalid_argument  if a value is infinite or no number.
Moments momentsOf(std::span<const double> values);

/// Exactly, from whole numbers: see LikertCounts::variance().
Moments momentsOf(const LikertCounts& counts);

}  // namespace analysis

#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "analysis/data/reason.h"

namespace analysis {

/// The result of the Shapiro–Wilk test.
struct ShapiroWilkResult {
  std::size_t n = 0;
  std::optional<double> w;  ///< in 0 … 1; near 1 for normally distributed values
  std::optional<double> p;  ///< small for values that are unlikely from a normal distribution
  Reason reason;            ///< why something above is missing; empty if nothing is
};

/// The Shapiro–Wilk test of normality (1965), in the approximation of Royston 1995, Applied
/// Statistics algorithm AS R94, for 3 … 5000 values:
///
///     W = (Σ aᵢ x₍ᵢ₎)² / Σ (x − x̄)²
///
/// with weights a from the normal quantiles of (i − 3/8)/(n + 1/4), the two outermost corrected by
/// a polynomial in 1/√n; and a transform of 1 − W that is nearly normal. For n = 3, p is exact:
/// (6/π)(asin √W − asin √(3/4)). The coefficients of the polynomials have four significant digits,
/// so p is accurate to about four.
///
/// Likert answers on a few points are never normal: Palpate reports this test, and chooses no other
/// test by it.
///
/// @throws std::invalid_argument  if a value is infinite or NaN.
ShapiroWilkResult shapiroWilkTest(std::span<const double> values);

/// The result of the Brown–Forsythe test of the spread of several groups.
struct BrownForsytheResult {
  std::optional<double> f;
  std::optional<double> degreesOfFreedom1;  ///< k − 1
  std::optional<double> degreesOfFreedom2;  ///< n − k
  std::optional<double> p;
  std::optional<double> log10P;  ///< defined even if p is too small for a double
  Reason reason;                 ///< why something above is missing; empty if nothing is
};

/// Do k groups differ in their spread? Levene's test about the medians (Brown & Forsythe 1974): the
/// one-way analysis of variance of |x − median of its group|.
///
/// Report it together with a test of means; do not use it to choose between tests.
///
/// @throws std::invalid_argument  if a value is infinite or NaN.
BrownForsytheResult brownForsytheTest(std::span<const std::vector<double>> groups);

}  // namespace analysis

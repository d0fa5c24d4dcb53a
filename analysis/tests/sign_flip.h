#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "analysis/data/reason.h"

namespace analysis {

/// What the sign-flip test says about paired differences; what is missing has its reason.
struct SignFlipResult {
  std::uint64_t n = 0;
  std::optional<double> p;         ///< exact, two-sided
  std::optional<double> pLess;     ///< exact P(Σ ≤ observed)
  std::optional<double> pGreater;  ///< exact P(Σ ≥ observed)
  Reason reason;                   ///< why p is missing; empty if it is not
};

/// The permutation test of paired differences (Fisher 1935): had every difference its sign by the
/// toss of a coin, how probable would a sum be as far from zero as this one?
///
///     p = #{ s ∈ {−1, 1}ᴺ : |Σ sᵢ dᵢ| ≥ |Σ dᵢ| } / 2ᴺ
///
/// Sums are compared as whole numbers, so that ties are ties: differences that are multiples of a
/// common unit but for rounding (commonUnitOf()) as those multiples, by dynamic programming over
/// sums; others exactly as the doubles that they are, for at most 40 that are not zero.
///
/// @throws std::invalid_argument  if a difference is infinite or NaN.
SignFlipResult signFlipTest(std::span<const double> differences);

}  // namespace analysis

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "analysis/data/ranks.h"
#include "analysis/numerics/exact_arithmetic.h"

namespace analysis {

/// The exact law of Mann & Whitney's U if every n₁ of all values were as likely to be group 1: that
/// of the given midranks, ties included, by dynamic programming over rank sums in 31 digits.
class RankSums {
 public:
  /// Whether the distribution fits into memory and is computed within about a second: two groups of
  /// some 50 values.
  static bool canHold(const TiedGroups& groups);

  /// @throws std::invalid_argument  for groups that canHold() refuses, and for an empty one.
  explicit RankSums(const TiedGroups& groups);

  /// P(2U ≤ u)
  double atMost(std::int64_t doubledU) const;
  /// P(2U ≥ u)
  double atLeast(std::int64_t doubledU) const;
  /// P(|2U − n₁n₂| ≥ |u − n₁n₂|): as far from its mean.
  double asFar(std::int64_t doubledU) const;

 private:
  std::int64_t doubledUAt(std::size_t index) const;

  std::int64_t mean_ = 0;  // of 2U
  std::int64_t least_ = 0;
  std::int64_t step_ = 1;  // negative where group 2 is the smaller one and its sums are counted
  std::vector<DoubleDouble> probabilities_;
};

}  // namespace analysis

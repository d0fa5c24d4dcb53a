#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "analysis/numerics/double_double.h"

namespace analysis {

/// The exact law of Σ wᵢ Bᵢ, where each Bᵢ is 0 or 1 by the toss of a fair coin: what a signed rank
/// or a sign-flip statistic follows if differences are as likely up as down.
///
/// By dynamic programming over the sums, one weight after another, in 31 digits.
class SubsetSums {
 public:
  /// Whether the law can be held and computed within about a second.
  static bool canHold(std::span<const std::uint64_t> weights);

  /// @throws std::invalid_argument  for weights that canHold() refuses.
  explicit SubsetSums(std::span<const std::uint64_t> weights);

  /// P(sum ≤ s)
  double atMost(std::uint64_t sum) const;
  /// P(sum ≥ s)
  double atLeast(std::uint64_t sum) const;
  /// min(1, 2 min(P(sum ≤ s), P(sum ≥ s)))
  double twoSided(std::uint64_t sum) const;

 private:
  std::uint64_t unit_ = 1;  // all sums are multiples of it
  std::vector<DoubleDouble> probabilities_;
};

}  // namespace analysis

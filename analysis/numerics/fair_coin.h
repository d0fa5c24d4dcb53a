#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "analysis/numerics/exact_arithmetic.h"

namespace analysis {

/// A probability that may be too small for a double.
struct SmallProbability {
  std::optional<double> p;  ///< std::nullopt below 2.2e-308
  double log10P = 0.0;
};

constexpr std::uint64_t kMostBinomialTrials = std::uint64_t{1} << 24;

/// P(heads ≤ k) of n tosses of a fair coin: Σ C(n, i) / 2ⁿ over i = 0 … k, summed with 31 digits.
/// @throws std::invalid_argument  for more heads than tosses, or more than kMostBinomialTrials.
SmallProbability symmetricBinomialCdf(std::uint64_t heads, std::uint64_t tosses);

/// min(1, 2 min(P(heads ≤ k), P(heads ≥ k))): the two-sided exact binomial test of one half.
/// @throws std::invalid_argument  for more heads than tosses, or more than kMostBinomialTrials.
SmallProbability symmetricBinomialP(std::uint64_t heads, std::uint64_t tosses);

/// The exact distribution of Σ wᵢ Bᵢ, where each Bᵢ is 0 or 1 with probability ½: the null
/// distribution of the signed rank and the sign-flip statistic.
///
/// Computed by dynamic programming over the sums, one weight after another, with 31 digits.
class WeightedBernoulliSum {
 public:
  /// Whether the distribution fits into memory and is computed within about a second: at most 500
  /// weights, and at most 5·10⁷ additions.
  static bool isFeasible(std::span<const std::uint64_t> weights);

  /// @throws std::invalid_argument  for weights that are not feasible.
  explicit WeightedBernoulliSum(std::span<const std::uint64_t> weights);

  /// P(sum ≤ s)
  double atMost(std::uint64_t sum) const;
  /// P(sum ≥ s)
  double atLeast(std::uint64_t sum) const;
  /// min(1, 2 min(P(sum ≤ s), P(sum ≥ s)))
  double twoSided(std::uint64_t sum) const;

 private:
  std::uint64_t unit_ = 1;                   ///< the greatest common divisor of the weights
  std::vector<DoubleDouble> probabilities_;  ///< [i]: probability of the sum i · unit_
};

}  // namespace analysis

#pragma once

#include <cstdint>
#include <optional>

namespace analysis {

/// A probability that may be too small for a double.
struct SmallProbability {
  std::optional<double> p;  ///< nothing below 2.2e-308
  double log10P = 0.0;
};

constexpr std::uint64_t kMostTosses = std::uint64_t{1} << 24;

/// P(heads ≤ k) of n tosses of a fair coin: Σ C(n, i) / 2ⁿ over i ≤ k, summed in 31 digits.
/// @throws std::invalid_argument  for more heads than tosses, or more than kMostTosses.
SmallProbability headsAtMost(std::uint64_t heads, std::uint64_t tosses);

/// min(1, 2 min(P(heads ≤ k), P(heads ≥ k))): the two-sided exact binomial test of one half.
/// @throws std::invalid_argument  as above.
SmallProbability fairCoinP(std::uint64_t heads, std::uint64_t tosses);

}  // namespace analysis

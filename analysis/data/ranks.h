#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "analysis/numerics/exact_arithmetic.h"

namespace analysis {

/// The ranks of values from the smallest, 1, to the largest; equal values get the mean of their
/// ranks.
struct Midranks {
  /// Twice the midrank of each value, a whole number, in the order of the values.
  std::vector<std::uint64_t> doubled;
  Int128 tieSum = 0;  ///< Σ (t³ − t) over the groups of t equal values
};

/// @throws std::invalid_argument  if a value is infinite or NaN.
Midranks midranksOf(std::span<const double> values);

/// How often one value occurs in each group.
struct TiedValue {
  std::uint64_t first = 0;
  std::uint64_t second = 0;
};

/// Two groups reduced to what a rank test uses: the order of the distinct values, and how often
/// each occurs.
struct TiedGroups {
  /// The largest size of a group for which every sum of squared ranks fits into 128 bits.
  static constexpr std::uint64_t kLargestGroup = std::uint64_t{1} << 24;

  std::uint64_t n1 = 0;
  std::uint64_t n2 = 0;
  std::vector<TiedValue> values;  ///< from the smallest to the largest; each occurs at least once

  bool areTooLargeForExactRanks() const noexcept {
    return n1 > kLargestGroup || n2 > kLargestGroup;
  }
  bool isEmpty() const noexcept { return n1 == 0 || n2 == 0; }
};

/// @throws std::invalid_argument  if a value is infinite or NaN.
TiedGroups tiedGroupsOf(std::span<const double> group1, std::span<const double> group2);

/// Sums of placements. The placement of a value is the number of smaller values in the other group,
/// plus half the number of equal ones. Placements are doubled, so that they are whole numbers.
struct Placements {
  Int128 sum1 = 0;      ///< doubled placements of group 1: 2 U₁
  Int128 sum2 = 0;      ///< doubled placements of group 2: 2 n₁ n₂ − 2 U₁
  Int128 squares1 = 0;  ///< sum of squared doubled placements of group 1
  Int128 squares2 = 0;
  Int128 equalPairs = 0;  ///< number of pairs of equal values, one from each group
  Int128 tieSum = 0;      ///< Σ (t³ − t) over all values of both groups together
};

/// @param groups  areTooLargeForExactRanks() is false.
/// @throws std::invalid_argument  for larger groups.
Placements placementsOf(const TiedGroups& groups);

}  // namespace analysis

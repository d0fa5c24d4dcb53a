#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "analysis/numerics/interval.h"
#include "analysis/published/answer_lattice.h"
#include "analysis/published/published_convention.h"
#include "analysis/published/published_table.h"

namespace analysis {

/// Tests quickly, for very many pairs of groups, whether the p value of two groups lies between two
/// limits.
///
/// Compares t with the quantiles at the whole degrees of freedom below and above, which decides
/// most pairs; p is computed only for a t between these.
class PValueWindow {
 public:
  PValueWindow(const Interval& p, const PublishedConvention& convention);

  /// @param group1  has at least two answers, as @p group2
  bool contains(const LatticePoint& group1, const LatticePoint& group2) const;

 private:
  struct Limits {
    double nearest = 0.0;  ///< |t| at the largest p of the window
    double furthest = 0.0;
  };

  const Limits& limitsAt(std::size_t degreesOfFreedom) const;

  Interval p_;
  PublishedConvention convention_;
  mutable std::vector<Limits> limits_;  ///< [degrees of freedom], computed on first use
};

/// The sizes of all groups, in the order of the table.
using GroupSizes = std::vector<std::uint64_t>;

/// The group sizes for which answers exist that reproduce all printed numbers of a row.
struct ConsistentSizes {
  PublishedConvention convention;
  std::uint64_t triedCombinations = 0;  ///< number of combinations of sizes that were tried
  /// The combinations for which answers exist that reproduce the whole row.
  std::vector<GroupSizes> fitting;
  /// For each group, the sizes that its mean and variance alone allow (GRIM, GRIMMER).
  std::vector<std::vector<std::uint64_t>> possibleSizes;
  /// Answers that reproduce the whole row at the sizes of largestFittingSizes(): for each group,
  /// the count of each point of the scale from the lowest. Empty if no sizes fit.
  std::vector<std::vector<std::uint64_t>> exampleAnswers;

  /// The sizes that fit if all groups have the same size.
  std::vector<std::uint64_t> equalSizes() const;
  /// The fitting combination with the largest total; the first one of several.
  std::optional<GroupSizes> largestFittingSizes() const;
};

/// The largest number of combinations of sizes that consistentSizes() tries.
inline constexpr double kMostSizeCombinations = 2e6;

/// Finds all combinations of sizes for which sums and sums of squares exist, one pair for each
/// group, that reproduce every printed mean, variance and p.
///
/// A p is compared with the limits of its printed value to about 1e-12.
///
/// @param sizes  for each group, the sizes to try, each within the lattice.
/// @throws std::invalid_argument  unless there is one list for each group and none is empty, and
///     for more than kMostSizeCombinations combinations.
ConsistentSizes consistentSizes(
    const PublishedTable& table,
    std::span<const std::vector<std::uint64_t>> sizes,
    const AnswerLattice& lattice,
    const PublishedConvention& convention);

}  // namespace analysis

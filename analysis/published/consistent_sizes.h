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

/// Whether two groups have a p between two limits, for very many pairs of groups.
///
/// Most pairs are decided by their t alone, from the quantiles at the whole degrees of freedom
/// below and above; a p is computed only for a t between these.
class TWindow {
 public:
  TWindow(const Interval& p, const PublishedConvention& convention);

  /// @param group1  and group2: of two answers at least.
  bool holds(const LatticePoint& group1, const LatticePoint& group2) const;

 private:
  struct Limits {
    double nearest = 0.0;  ///< t at the larger p
    double furthest = 0.0;
  };

  const Limits& limitsAt(std::size_t degreesOfFreedom) const;

  Interval p_;
  PublishedConvention convention_;
  mutable std::vector<Limits> limits_;  ///< [degrees of freedom], as far as they were asked for
};

/// The sizes of all groups, in the order of the table.
using GroupSizes = std::vector<std::uint64_t>;

/// The group sizes for which answers on a scale exist that print the whole row.
struct ConsistentSizes {
  PublishedConvention convention;
  std::uint64_t tried = 0;          ///< combinations of sizes
  std::vector<GroupSizes> fitting;  ///< those for which answers exist that print the whole row
  /// For every group the sizes that its mean and variance alone allow (GRIM, GRIMMER).
  std::vector<std::vector<std::uint64_t>> possible;
  /// Answers of every group that print the whole row, at the sizes of fewestMissing(): how often
  /// each point of the scale was given, from the lowest up. Empty where nothing fits.
  std::vector<std::vector<std::uint64_t>> example;

  /// Those that are the same in every group.
  std::vector<std::uint64_t> equalSizes() const;
  /// The one with most answers in all; the first of several.
  std::optional<GroupSizes> fewestMissing() const;
};

/// How many combinations of sizes may be tried.
inline constexpr double kMostSizeCombinations = 2e6;

/// Tries every combination of sizes: are there sums and sums of squares, one pair for each group,
/// that print every mean, variance and p?
///
/// A p on a border is decided to about 1e-12.
///
/// @param sizes  for each group those to be tried, each within the lattice.
/// @throws std::invalid_argument  for other than one list for every group, an empty list, and
///     beyond kMostSizeCombinations.
ConsistentSizes consistentSizes(
    const PublishedTable& table,
    std::span<const std::vector<std::uint64_t>> sizes,
    const AnswerLattice& lattice,
    const PublishedConvention& convention);

}  // namespace analysis

#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "analysis/numerics/interval.h"
#include "analysis/published/consistent_sizes.h"
#include "analysis/published/published_convention.h"
#include "analysis/published/published_table.h"

namespace analysis {

/// A possible mean and variance (divided by n − 1) of a group.
struct MeanAndVariance {
  double mean = 0.0;
  double variance = 0.0;
};

/// One mean and variance for each group that together give *all* printed p values, which is a
/// stronger condition than each p alone; std::nullopt if none are found.
///
/// The variances are taken from a grid (nine values of each group, down to three where there are
/// many groups). For given variances, a printed p is a range of the difference of two means; a
/// shortest-path algorithm decides exactly whether means exist that satisfy all ranges. A result
/// therefore proves that the row is possible; std::nullopt proves nothing, because a solution may
/// lie between the points of the grid.
///
/// @param sizes  one for each group, at least 2.
/// @throws std::invalid_argument  for another number of sizes than of groups.
std::optional<std::vector<MeanAndVariance>> momentsGivingAllP(
    const PublishedTable& table,
    std::span<const std::uint64_t> sizes,
    const PublishedConvention& convention);

/// The range of p values of two groups whose means and variances would be printed as @p group1 and
/// @p group2.
///
/// p falls with the difference of the means, so the smallest and the largest difference bound it.
/// At a fixed ratio of the variances, p rises with their size, so the extremes of p lie on the
/// edges of the rectangle of variances. The edges are searched, corners included. (Along an edge p
/// usually rises as well, but not always, because Welch's degrees of freedom change.)
///
/// @param n1  at least 2, as @p n2
Interval attainableP(
    const PublishedGroup& group1,
    std::uint64_t n1,
    const PublishedGroup& group2,
    std::uint64_t n2,
    const PublishedConvention& convention);

/// Whether two intervals have a number in common.
bool doOverlap(const Interval& a, const Interval& b);

/// The p values that are possible for one comparison, and whether the printed one is among them.
struct ComparisonCheck {
  Interval attainable;
  bool isAttainable = false;  ///< whether some attainable p would be printed like the published one
};

/// The check of a row of a published table at given group sizes, under one convention.
struct ConventionCheck {
  PublishedConvention convention;
  GroupSizes sizes;
  std::vector<ComparisonCheck> comparisons;  ///< in the order of the table
  /// Means and variances that together give all printed p values; std::nullopt if none were found.
  std::optional<std::vector<MeanAndVariance>> row;

  bool areAllAttainable() const;
};

/// @param sizes  one for each group, at least 2.
/// @throws std::invalid_argument  for another number of sizes than of groups.
ConventionCheck checkConvention(
    const PublishedTable& table, const GroupSizes& sizes, const PublishedConvention& convention);

}  // namespace analysis

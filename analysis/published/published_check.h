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

/// A group with the mean and the variance (n − 1) that it may have had.
struct MeanAndVariance {
  double mean = 0.0;
  double variance = 0.0;
};

/// One mean and one variance for each group that give *all* printed p values at once, which is a
/// stronger condition than each p alone; std::nullopt if none are found.
///
/// The variances are taken from a grid (nine values of each group, down to three where there are
/// many groups). For given variances a printed p is a range of the difference of two means, and
/// whether means fulfil all ranges together is a question of shortest paths: answered exactly. So
/// what is found proves that the row fits, and what is not found may lie between the grid's points.
///
/// @param sizes  of every group, at least 2.
/// @throws std::invalid_argument  for another number of sizes than of groups.
std::optional<std::vector<MeanAndVariance>> momentsOfRow(
    const PublishedTable& table,
    std::span<const std::uint64_t> sizes,
    const PublishedConvention& convention);

/// Every p that two groups may have, whose means and variances are printed like this.
///
/// p falls with the difference of the means, so the nearest and the furthest two means bound it.
/// Where the ratio of both variances is held, p rises with their size; so its extremes lie on the
/// edges of the rectangle of variances, and these are searched, corners included. (Along an edge p
/// usually rises as well, but Welch's degrees of freedom may bend it.)
///
/// @param n1  and n2: at least 2.
Interval attainableP(
    const PublishedGroup& group1,
    std::uint64_t n1,
    const PublishedGroup& group2,
    std::uint64_t n2,
    const PublishedConvention& convention);

/// Whether two intervals share a number.
bool overlap(const Interval& a, const Interval& b);

/// One printed p value, and the range of possible ones.
struct ComparisonCheck {
  Interval attainable;
  bool isAttainable = false;  ///< some attainable p would be printed like this
};

/// A row of a published table at given sizes of the groups, by one convention.
struct ConventionCheck {
  PublishedConvention convention;
  GroupSizes sizes;
  std::vector<ComparisonCheck> comparisons;         ///< in the order of the table
  std::optional<std::vector<MeanAndVariance>> row;  ///< means and variances that give all p at once

  bool allAttainable() const;
};

/// @param sizes  of every group, at least 2.
/// @throws std::invalid_argument  for another number of sizes than of groups.
ConventionCheck checkAt(
    const PublishedTable& table, const GroupSizes& sizes, const PublishedConvention& convention);

}  // namespace analysis

#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "analysis/published/published_convention.h"
#include "analysis/published/published_table.h"

namespace analysis {

/// A group with the mean and the variance (n − 1) that it may have had.
struct RealGroup {
  double mean = 0.0;
  double variance = 0.0;
};

/// One mean and one variance for each group that give *all* printed p values at once, which is more
/// than each comparison for itself; std::nullopt if none are found.
///
/// The variances are taken from a grid (nine values of each group, down to three where there are
/// many groups). For given variances a printed p is a range of the difference of two means, and
/// whether means fulfil all ranges together is a question of shortest paths: answered exactly. So
/// what is found proves that the row fits, and what is not found may lie between the grid's points.
///
/// @param sizes  of every group, at least 2.
/// @throws std::invalid_argument  for another number of sizes than of groups.
std::optional<std::vector<RealGroup>> realRow(
    const PublishedTable& table,
    std::span<const std::uint64_t> sizes,
    const PublishedConvention& convention);

}  // namespace analysis

#pragma once

#include <optional>
#include <vector>

#include "analysis/numerics/interval.h"
#include "analysis/published/fitting_sizes.h"
#include "analysis/published/published_convention.h"
#include "analysis/published/published_table.h"
#include "analysis/published/real_row.h"

namespace analysis {

/// One printed p, and what it may have been.
struct ComparisonCheck {
  Interval attainable;
  bool follows = false;  ///< some attainable p would be printed like this
};

/// A row of a published table at given sizes of the groups, by one convention.
struct ConventionCheck {
  PublishedConvention convention;
  GroupSizes sizes;
  std::vector<ComparisonCheck> comparisons;   ///< in the order of the table
  std::optional<std::vector<RealGroup>> row;  ///< means and variances that give all p at once

  bool eachFollows() const;
};

/// @param sizes  of every group, at least 2.
/// @throws std::invalid_argument  for another number of sizes than of groups.
ConventionCheck checkAt(
    const PublishedTable& table, const GroupSizes& sizes, const PublishedConvention& convention);

}  // namespace analysis

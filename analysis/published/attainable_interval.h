#pragma once

#include <cstdint>

#include "analysis/numerics/interval.h"
#include "analysis/published/published_convention.h"
#include "analysis/published/published_table.h"

namespace analysis {

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

}  // namespace analysis

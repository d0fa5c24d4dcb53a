#include "analysis/published/published_check.h"

#include <algorithm>
#include <stdexcept>

#include "analysis/published/attainable_interval.h"

namespace analysis {

bool ConventionCheck::eachFollows() const {
  return std::ranges::all_of(comparisons, &ComparisonCheck::follows);
}

ConventionCheck checkAt(
    const PublishedTable& table, const GroupSizes& sizes, const PublishedConvention& convention) {
  if (sizes.size() != table.groups.size()) {
    throw std::invalid_argument("every group has one size");
  }
  ConventionCheck check{.convention = convention, .sizes = sizes};
  for (const auto& [first, second, p] : table.comparisons) {
    const Interval attainable = attainableP(
        table.groups[first], sizes[first], table.groups[second], sizes[second], convention);
    check.comparisons.push_back(
        {.attainable = attainable, .follows = overlap(attainable, p.bounds(convention.reading))});
  }
  if (check.eachFollows()) check.row = realRow(table, sizes, convention);
  return check;
}

}  // namespace analysis

#include "analysis/published/published_check.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace analysis {
namespace {

constexpr int kStepsOfEdge = 64;  // p bends slightly along an edge: an extreme may lie inside

double between(const Interval& range, int step) {
  if (step == kStepsOfEdge) return range.high;
  return range.low + (range.high - range.low) * step / kStepsOfEdge;
}

/// The nearest and the furthest that two means may be from each other.
Interval distanceOf(const Interval& mean1, const Interval& mean2) {
  const double furthest = std::max(mean1.high - mean2.low, mean2.high - mean1.low);
  const double nearest = std::max({mean1.low - mean2.high, mean2.low - mean1.high, 0.0});
  return {.low = nearest, .high = furthest};
}

}  // namespace

Interval attainableP(
    const PublishedGroup& group1,
    std::uint64_t n1,
    const PublishedGroup& group2,
    std::uint64_t n2,
    const PublishedConvention& convention) {
  const Interval distance =
      distanceOf(group1.mean.bounds(convention.reading), group2.mean.bounds(convention.reading));
  const Interval variance1 = varianceBounds(group1, n1, convention);
  const Interval variance2 = varianceBounds(group2, n2, convention);
  const auto p = [&](double difference, double v1, double v2) {
    return pOf(difference, spreadOfDifference(convention.test, v1, n1, v2, n2), convention.tails);
  };

  Interval found{.low = 1.0, .high = 0.0};
  for (int step = 0; step <= kStepsOfEdge; ++step) {
    const double v1 = between(variance1, step);
    const double v2 = between(variance2, step);
    found.low = std::min(
        {found.low, p(distance.high, variance1.low, v2), p(distance.high, v1, variance2.low)});
    found.high = std::max(
        {found.high, p(distance.low, variance1.high, v2), p(distance.low, v1, variance2.high)});
  }
  return found;
}

bool overlap(const Interval& a, const Interval& b) {
  return a.low <= b.high && b.low <= a.high;
}

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

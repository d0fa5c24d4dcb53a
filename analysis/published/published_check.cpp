#include "analysis/published/published_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "analysis/numerics/distributions.h"

namespace analysis {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The condition m_to − m_from ≤ most. Node 0 is the number zero, node g + 1 the mean of group g.
struct Bound {
  std::size_t from = 0;
  std::size_t to = 0;
  double most = 0.0;
};

/// Numbers that satisfy all bounds, by the Bellman–Ford algorithm; std::nullopt if there are none:
/// then a cycle of bounds has a negative sum, and the numbers fall in every round.
std::optional<std::vector<double>> solveBounds(
    const std::vector<Bound>& bounds, std::size_t nodes) {
  std::vector<double> number(nodes, 0.0);
  for (std::size_t round = 0; round <= nodes; ++round) {
    bool isChanged = false;
    for (const auto& bound : bounds) {
      const double most = number[bound.from] + bound.most;
      // With a tolerance, so that rounding alone does not make a negative cycle.
      if (most < number[bound.to] - 1e-12) {
        number[bound.to] = most;
        isChanged = true;
      }
    }
    if (!isChanged) return number;
  }
  return std::nullopt;
}

/// The range of |m₁ − m₂| that gives the printed p.
Interval distancesGivingP(
    const Interval& p, const SpreadOfDifference& spread, PublishedConvention::Tails tails) {
  const double factor = tails == PublishedConvention::Tails::Two ? 1.0 : 2.0;
  const StudentDistribution distribution(spread.degreesOfFreedom);
  const auto distanceAt = [&](double twoSided) {
    if (twoSided <= 0.0) return kInfinity;
    return twoSided >= 1.0 ? 0.0 : distribution.twoSidedQuantile(twoSided) * spread.standardError;
  };
  if (factor * p.low > 1.0) return {.low = kInfinity, .high = -kInfinity};
  return {.low = distanceAt(factor * p.high), .high = distanceAt(factor * p.low)};
}

class RowSearch {
 public:
  RowSearch(
      const PublishedTable& table,
      std::span<const std::uint64_t> sizes,
      const PublishedConvention& convention)
      : table_(table), convention_(convention) {
    const std::size_t groups = table.groups.size();
    gridPoints_ = groups <= 4 ? 9 : (groups == 5 ? 5 : 3);  // at most 3^8 = 6561 combinations
    for (std::size_t g = 0; g < groups; ++g) {
      const Interval range = varianceBounds(table.groups[g], sizes[g], convention);
      std::vector<double> grid;
      for (std::size_t i = 0; i < gridPoints_; ++i) {
        const double part = (static_cast<double>(i) + 0.5) / static_cast<double>(gridPoints_);
        grid.push_back(range.low + (range.high - range.low) * part);
      }
      variances_.push_back(grid);
      const Interval mean = table.groups[g].mean.bounds(convention.rounding);
      means_.push_back({.from = 0, .to = g + 1, .most = mean.high});
      means_.push_back({.from = g + 1, .to = 0, .most = -mean.low});
    }
    for (const auto& comparison : table.comparisons) ranges_.push_back(rangesOf(comparison, sizes));
  }

  std::optional<std::vector<MeanAndVariance>> found() const {
    std::vector<std::size_t> at(table_.groups.size(), 0);
    do {
      if (const auto means = meansWithinBounds(at, 0, means_)) {
        std::vector<MeanAndVariance> row;
        for (std::size_t g = 0; g < at.size(); ++g) {
          row.push_back({.mean = (*means)[g + 1] - (*means)[0], .variance = variances_[g][at[g]]});
        }
        return row;
      }
    } while (advance(at));
    return std::nullopt;
  }

 private:
  std::vector<Interval> rangesOf(
      const PublishedComparison& comparison, std::span<const std::uint64_t> sizes) const {
    const auto& [first, second, p] = comparison;
    std::vector<Interval> ranges;
    for (const double v1 : variances_[first]) {
      for (const double v2 : variances_[second]) {
        const auto spread =
            spreadOfDifference(convention_.test, v1, sizes[first], v2, sizes[second]);
        ranges.push_back(
            distancesGivingP(p.bounds(convention_.rounding), spread, convention_.tails));
      }
    }
    return ranges;
  }

  bool advance(std::vector<std::size_t>& at) const {
    for (auto& index : at) {
      if (++index < gridPoints_) return true;
      index = 0;
    }
    return false;
  }

  /// Backtracking search. Once the larger mean is chosen, a range of |m₁ − m₂| becomes two bounds.
  /// Adds one comparison after another, each in both directions, and backtracks as soon as the
  /// bounds contradict each other.
  std::optional<std::vector<double>> meansWithinBounds(
      const std::vector<std::size_t>& at,
      std::size_t next,
      const std::vector<Bound>& bounds) const {
    auto numbers = solveBounds(bounds, table_.groups.size() + 1);
    if (!numbers || next == table_.comparisons.size()) return numbers;
    const auto& comparison = table_.comparisons[next];
    const auto& range = ranges_[next][at[comparison.first] * gridPoints_ + at[comparison.second]];
    if (!std::isfinite(range.low) || range.low > range.high) return std::nullopt;
    for (const bool isPositive : {true, false}) {
      const std::size_t above = 1 + (isPositive ? comparison.first : comparison.second);
      const std::size_t below = 1 + (isPositive ? comparison.second : comparison.first);
      auto more = bounds;
      more.push_back({.from = below, .to = above, .most = range.high});
      more.push_back({.from = above, .to = below, .most = -range.low});
      if (auto means = meansWithinBounds(at, next + 1, more)) return means;
    }
    return std::nullopt;
  }

  const PublishedTable& table_;
  PublishedConvention convention_;
  std::size_t gridPoints_ = 9;
  std::vector<std::vector<double>> variances_;  ///< [group][point of the grid]
  std::vector<Bound> means_;
  std::vector<std::vector<Interval>> ranges_;  ///< [comparison][both points of the grid]
};

}  // namespace

std::optional<std::vector<MeanAndVariance>> momentsGivingAllP(
    const PublishedTable& table,
    std::span<const std::uint64_t> sizes,
    const PublishedConvention& convention) {
  if (sizes.size() != table.groups.size()) {
    throw std::invalid_argument("every group has one size");
  }
  return RowSearch(table, sizes, convention).found();
}

namespace {

constexpr int kStepsOfEdge = 64;  // p may be non-monotonic along an edge: an extreme may lie inside

double pointOfRange(const Interval& range, int step) {
  if (step == kStepsOfEdge) return range.high;
  return range.low + (range.high - range.low) * step / kStepsOfEdge;
}

/// The smallest and the largest distance of two means.
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
      distanceOf(group1.mean.bounds(convention.rounding), group2.mean.bounds(convention.rounding));
  const Interval variance1 = varianceBounds(group1, n1, convention);
  const Interval variance2 = varianceBounds(group2, n2, convention);
  const auto p = [&](double difference, double v1, double v2) {
    return pOf(difference, spreadOfDifference(convention.test, v1, n1, v2, n2), convention.tails);
  };

  Interval found{.low = 1.0, .high = 0.0};
  for (int step = 0; step <= kStepsOfEdge; ++step) {
    const double v1 = pointOfRange(variance1, step);
    const double v2 = pointOfRange(variance2, step);
    found.low = std::min(
        {found.low, p(distance.high, variance1.low, v2), p(distance.high, v1, variance2.low)});
    found.high = std::max(
        {found.high, p(distance.low, variance1.high, v2), p(distance.low, v1, variance2.high)});
  }
  return found;
}

bool doOverlap(const Interval& a, const Interval& b) {
  return a.low <= b.high && b.low <= a.high;
}

bool ConventionCheck::areAllAttainable() const {
  return std::ranges::all_of(comparisons, &ComparisonCheck::isAttainable);
}

ConventionCheck checkConvention(
    const PublishedTable& table, const GroupSizes& sizes, const PublishedConvention& convention) {
  if (sizes.size() != table.groups.size()) {
    throw std::invalid_argument("every group has one size");
  }
  ConventionCheck check{.convention = convention, .sizes = sizes};
  for (const auto& [first, second, p] : table.comparisons) {
    const Interval attainable = attainableP(
        table.groups[first], sizes[first], table.groups[second], sizes[second], convention);
    check.comparisons.push_back(
        {.attainable = attainable,
         .isAttainable = doOverlap(attainable, p.bounds(convention.rounding))});
  }
  if (check.areAllAttainable()) check.row = momentsGivingAllP(table, sizes, convention);
  return check;
}

}  // namespace analysis

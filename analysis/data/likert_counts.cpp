#include "analysis/data/likert_counts.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "analysis/data/moments.h"

namespace analysis {
namespace {

std::size_t checkedPointCount(int lowest, std::int64_t points) {
  constexpr int kLargestPoint = 1'000'000;
  if (points < 2 || points > LikertCounts::kMostPoints) {
    throw std::invalid_argument(
        "a scale has 2 to " + std::to_string(LikertCounts::kMostPoints) + " points, not " +
        std::to_string(points));
  }
  if (lowest < -kLargestPoint || lowest > kLargestPoint) {
    throw std::invalid_argument("a scale cannot begin at " + std::to_string(lowest));
  }
  return static_cast<std::size_t>(points);
}

/// The uniform distribution over a run of points.
struct UniformRun {
  double mean = 0.0;
  double square = 0.0;  ///< mean of the squares
};

UniformRun uniformRunOf(int first, int last) {
  UniformRun run;
  for (int point = first; point <= last; ++point) {
    run.mean += point;
    run.square += static_cast<double>(point) * point;
  }
  const double points = last - first + 1;
  return {.mean = run.mean / points, .square = run.square / points};
}

std::vector<UniformRun> runsContaining(int peak, int lowest, int highest) {
  std::vector<UniformRun> runs;
  for (int first = lowest; first <= peak; ++first) {
    for (int last = peak; last <= highest; ++last) runs.push_back(uniformRunOf(first, last));
  }
  return runs;
}

/// The largest second moment of a mixture of two of @p runs with the mean @p mean.
double largestSquare(const std::vector<UniformRun>& runs, double mean) {
  double largest = 0.0;
  for (const auto& below : runs) {
    if (below.mean > mean) continue;
    for (const auto& above : runs) {
      if (above.mean < mean) continue;
      const double apart = above.mean - below.mean;
      const double share = apart > 0.0 ? (mean - below.mean) / apart : 0.0;
      largest = std::max(largest, below.square + share * (above.square - below.square));
    }
  }
  return largest;
}

}  // namespace

LikertCounts::LikertCounts(int lowest, int highest)
    : lowest_(lowest), counts_(checkedPointCount(lowest, std::int64_t{highest} - lowest + 1), 0) {}

LikertCounts::LikertCounts(int lowest, std::span<const std::uint64_t> counts)
    : lowest_(lowest), counts_(checkedPointCount(lowest, std::ssize(counts)), 0) {
  for (std::size_t i = 0; i < counts.size(); ++i) add(lowest + static_cast<int>(i), counts[i]);
}

void LikertCounts::add(int point, std::uint64_t times) {
  if (point < lowest() || point > highest()) {
    throw std::invalid_argument(
        "the answer " + std::to_string(point) + " is not on the scale " + std::to_string(lowest()) +
        " to " + std::to_string(highest()));
  }
  if (times > kMostAnswers - total_) throw std::invalid_argument("too many answers");
  counts_[static_cast<std::size_t>(point - lowest_)] += times;
  total_ += times;
}

std::optional<double> LikertCounts::mean() const {
  return total_ == 0 ? std::nullopt : std::optional(momentsOf(*this).mean.high);
}

std::optional<double> LikertCounts::variance() const {
  return total_ < 2 ? std::nullopt : std::optional(momentsOf(*this).variance.high);
}

double largestUnimodalVariance(int lowest, int highest, double mean) {
  if (highest <= lowest) throw std::invalid_argument("a scale has two points or more");
  if (!(mean >= lowest && mean <= highest)) {
    throw std::invalid_argument("the mean lies outside the scale");
  }
  // Counting points from the lowest keeps squares small, and the difference loses no digits.
  const int points = highest - lowest + 1;
  const double centred = mean - lowest;
  double largest = 0.0;
  for (int peak = 0; peak < points; ++peak) {
    const auto runs = runsContaining(peak, 0, points - 1);
    largest = std::max(largest, largestSquare(runs, centred) - centred * centred);
  }
  return largest;
}

std::optional<bool> exceedsUnimodalVariance(const LikertCounts& counts) {
  const auto variance = counts.variance();
  const auto mean = counts.mean();
  if (!variance || !mean) return std::nullopt;
  const auto n = static_cast<double>(counts.total());
  const double bound = largestUnimodalVariance(counts.lowest(), counts.highest(), *mean);
  constexpr double kRounding = 1e-12;  // the bound can be attained, as on a scale of two points
  return *variance * (n - 1.0) / n > bound * (1.0 + kRounding);
}

}  // namespace analysis

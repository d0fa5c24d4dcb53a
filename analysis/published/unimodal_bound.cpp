#include "analysis/published/unimodal_bound.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace analysis {
namespace {

/// The uniform distribution over a run of points.
struct Run {
  double mean = 0.0;
  double square = 0.0;  ///< mean of the squares
};

Run runOf(int first, int last) {
  Run run;
  for (int point = first; point <= last; ++point) {
    run.mean += point;
    run.square += static_cast<double>(point) * point;
  }
  const double points = last - first + 1;
  return {.mean = run.mean / points, .square = run.square / points};
}

std::vector<Run> runsAround(int peak, int lowest, int highest) {
  std::vector<Run> runs;
  for (int first = lowest; first <= peak; ++first) {
    for (int last = peak; last <= highest; ++last) runs.push_back(runOf(first, last));
  }
  return runs;
}

/// The largest mean square of a mixture of two of @p runs with the mean @p mean.
double largestSquare(const std::vector<Run>& runs, double mean) {
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

double largestUnimodalVariance(int lowest, int highest, double mean) {
  if (highest <= lowest) throw std::invalid_argument("a scale has two points or more");
  if (!(mean >= lowest && mean <= highest)) {
    throw std::invalid_argument("the mean lies outside the scale");
  }
  // About the mean of the scale, so that nothing cancels.
  const int points = highest - lowest + 1;
  const double centred = mean - lowest;
  double largest = 0.0;
  for (int peak = 0; peak < points; ++peak) {
    const auto runs = runsAround(peak, 0, points - 1);
    largest = std::max(largest, largestSquare(runs, centred) - centred * centred);
  }
  return largest;
}

std::optional<bool> isBeyondUnimodal(const LikertCounts& counts) {
  const auto variance = counts.variance();
  const auto mean = counts.mean();
  if (!variance || !mean) return std::nullopt;
  const auto n = static_cast<double>(counts.total());
  const double bound = largestUnimodalVariance(counts.lowest(), counts.highest(), *mean);
  constexpr double kRounding = 1e-12;
  return *variance * (n - 1.0) / n > bound * (1.0 + kRounding);
}

}  // namespace analysis

#include "analysis/effects/hodges_lehmann.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "analysis/numerics/subset_sums.h"

namespace analysis {
namespace {

constexpr std::size_t kMostDifferences = 4000;  // eight million averages

std::vector<double> walshAverages(std::span<const double> differences) {
  std::vector<double> averages;
  averages.reserve(differences.size() * (differences.size() + 1) / 2);
  for (std::size_t i = 0; i < differences.size(); ++i) {
    for (std::size_t j = i; j < differences.size(); ++j) {
      averages.push_back(std::midpoint(differences[i], differences[j]));
    }
  }
  std::ranges::sort(averages);
  return averages;
}

void addInterval(HodgesLehmannResult& result, const std::vector<double>& averages, double level) {
  std::vector<std::uint64_t> ranks(result.n);
  std::iota(ranks.begin(), ranks.end(), std::uint64_t{1});
  if (!SubsetSums::canHold(ranks)) {
    result.reason = reason("too_many_for_interval");
    return;
  }
  const SubsetSums law(ranks);
  const double tail = 0.5 * (1.0 - level);
  if (law.atMost(0) > tail) {
    result.reason = reason("no_such_confidence");
    return;
  }
  std::uint64_t low = 0;  // the largest sum of ranks that would be rejected
  for (std::uint64_t high = averages.size(); high - low > 1;) {
    const std::uint64_t middle = std::midpoint(low, high);
    (law.atMost(middle) > tail ? high : low) = middle;
  }
  result.confidence = 1.0 - 2.0 * law.atMost(low);
  result.interval = Interval{.low = averages[low], .high = averages[averages.size() - 1 - low]};
}

}  // namespace

HodgesLehmannResult hodgesLehmann(std::span<const double> differences, double level) {
  if (!(level > 0.0 && level < 1.0)) {
    throw std::invalid_argument("a confidence level lies between 0 and 1");
  }
  if (!std::ranges::all_of(differences, [](double number) { return std::isfinite(number); })) {
    throw std::invalid_argument("a difference is infinite or no number");
  }
  HodgesLehmannResult result;
  result.n = differences.size();
  if (differences.empty() || differences.size() > kMostDifferences) {
    result.reason = differences.empty() ? reason("no_differences") : reason("too_many_averages");
    return result;
  }
  const auto averages = walshAverages(differences);
  const std::size_t half = averages.size() / 2;
  result.estimate =
      averages.size() % 2 == 1 ? averages[half] : std::midpoint(averages[half - 1], averages[half]);
  addInterval(result, averages, level);
  return result;
}

}  // namespace analysis

#include "analysis/numerics/subset_sums.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <stdexcept>

namespace analysis {
namespace {

constexpr std::size_t kMostWeights = 500;  // 2^−500 is far within a double's range
constexpr std::uint64_t kMostSteps = 50'000'000;

std::uint64_t unitOf(std::span<const std::uint64_t> weights) {
  std::uint64_t unit = 0;
  for (const auto weight : weights) unit = std::gcd(unit, weight);
  return std::max<std::uint64_t>(unit, 1);
}

DoubleDouble halfOf(const DoubleDouble& number) {
  return {0.5 * number.high, 0.5 * number.low};
}

}  // namespace

bool SubsetSums::canHold(std::span<const std::uint64_t> weights) {
  if (weights.size() > kMostWeights) return false;
  const std::uint64_t unit = unitOf(weights);
  std::uint64_t reach = 0;
  for (const auto weight : weights) {
    if (weight / unit > kMostSteps - reach) return false;
    reach += weight / unit;
  }
  return reach * weights.size() <= kMostSteps;
}

SubsetSums::SubsetSums(std::span<const std::uint64_t> weights) : unit_(unitOf(weights)) {
  if (!canHold(weights)) throw std::invalid_argument("too many sums to compute their law");
  std::size_t reach = 0;
  for (const auto weight : weights) reach += weight / unit_;

  probabilities_.assign(reach + 1, 0.0);
  probabilities_[0] = 1.0;
  std::size_t reached = 0;
  for (const auto weight : weights) {
    const std::size_t step = weight / unit_;
    reached += step;
    for (std::size_t sum = reached; sum >= step; --sum) {
      probabilities_[sum] = halfOf(probabilities_[sum] + probabilities_[sum - step]);
      if (sum == 0) break;
    }
    for (std::size_t sum = 0; sum < step; ++sum) probabilities_[sum] = halfOf(probabilities_[sum]);
  }
}

double SubsetSums::atMost(std::uint64_t sum) const {
  const std::size_t last = std::min<std::size_t>(sum / unit_, probabilities_.size() - 1);
  DoubleDouble total;
  for (std::size_t i = 0; i <= last; ++i) total = total + probabilities_[i];
  return total.high;
}

double SubsetSums::atLeast(std::uint64_t sum) const {
  const std::uint64_t first = sum / unit_ + (sum % unit_ == 0 ? 0 : 1);
  DoubleDouble total;
  for (std::size_t i = probabilities_.size(); i > first; --i) total = total + probabilities_[i - 1];
  return total.high;
}

double SubsetSums::twoSided(std::uint64_t sum) const {
  return std::min(1.0, 2.0 * std::min(atMost(sum), atLeast(sum)));
}

}  // namespace analysis

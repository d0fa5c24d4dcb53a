#include "analysis/numerics/fair_coin.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "analysis/numerics/exact_arithmetic.h"

namespace analysis {
namespace {

/// number · 2^exponent
struct ScaledNumber {
  DoubleDouble number;
  int exponent = 0;
};

/// C(n, k), for k ≤ n/2. Every partial product is itself a binomial coefficient; powers of two are
/// factored out before a product overflows.
ScaledNumber binomial(double n, double k) {
  constexpr int kStep = 500;
  ScaledNumber result{.number = 1.0, .exponent = 0};
  for (double i = 1.0; i <= k; ++i) {
    result.number = result.number * (n - k + i) / i;
    if (result.number.high < 0x1p500) continue;
    result.number = scaled(result.number, -kStep);
    result.exponent += kStep;
  }
  return result;
}

SmallProbability probabilityOf(const ScaledNumber& scaledP) {
  return {
      .p = toDouble(scaledP.number, scaledP.exponent),
      .log10P = (std::log2(scaledP.number.high) + scaledP.exponent) /
                (std::numbers::ln10 / std::numbers::ln2)};
}

/// P(heads ≤ k) for k ≤ n/2, computed as the last term C(n, k) / 2ⁿ times the sum of all terms
/// divided by it.
ScaledNumber lowerTail(std::uint64_t heads, std::uint64_t tosses) {
  const auto n = static_cast<double>(tosses);
  const auto k = static_cast<double>(heads);
  DoubleDouble sum = 1.0;
  DoubleDouble term = 1.0;
  // Terms fall at least as fast as a geometric series; terms below 1e-40 do not change the sum.
  for (double i = k; i > 0.0 && term.high > 1e-40; --i) {
    term = term * i / (n - i + 1.0);
    sum = sum + term;
  }
  ScaledNumber result = binomial(n, k);
  result.number = result.number * sum;
  result.exponent -= static_cast<int>(tosses);
  return result;
}

void requireValidToss(std::uint64_t heads, std::uint64_t tosses) {
  if (heads > tosses) throw std::invalid_argument("there are more heads than tosses");
  if (tosses > kMostBinomialTrials)
    throw std::invalid_argument("there are too many tosses of a coin");
}

constexpr std::size_t kMostWeights = 500;  // the smallest probability, 2^−500, is still a double
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

SmallProbability symmetricBinomialCdf(std::uint64_t heads, std::uint64_t tosses) {
  requireValidToss(heads, tosses);
  if (2 * heads <= tosses) return probabilityOf(lowerTail(heads, tosses));
  if (heads == tosses) return {.p = 1.0, .log10P = 0.0};
  const double above = probabilityOf(lowerTail(tosses - heads - 1, tosses)).p.value_or(0.0);
  return {.p = 1.0 - above, .log10P = std::log1p(-above) / std::numbers::ln10};
}

SmallProbability symmetricBinomialP(std::uint64_t heads, std::uint64_t tosses) {
  requireValidToss(heads, tosses);
  if (2 * heads == tosses) return {.p = 1.0, .log10P = 0.0};
  ScaledNumber tail = lowerTail(std::min(heads, tosses - heads), tosses);
  ++tail.exponent;
  const SmallProbability both = probabilityOf(tail);
  return both.log10P < 0.0 ? both : SmallProbability{.p = 1.0, .log10P = 0.0};
}

bool WeightedBernoulliSum::isFeasible(std::span<const std::uint64_t> weights) {
  if (weights.size() > kMostWeights) return false;
  const std::uint64_t unit = unitOf(weights);
  std::uint64_t reach = 0;
  for (const auto weight : weights) {
    if (weight / unit > kMostSteps - reach) return false;
    reach += weight / unit;
  }
  return reach * weights.size() <= kMostSteps;
}

WeightedBernoulliSum::WeightedBernoulliSum(std::span<const std::uint64_t> weights)
    : unit_(unitOf(weights)) {
  if (!isFeasible(weights)) throw std::invalid_argument("too many sums to compute their law");
  std::size_t reach = 0;
  for (const auto weight : weights) reach += weight / unit_;

  probabilities_.assign(reach + 1, 0.0);
  probabilities_[0] = 1.0;
  std::size_t reached = 0;
  for (const auto weight : weights) {
    const std::size_t step = weight / unit_;
    reached += step;
    // Goes downwards, so that each weight is used once: the entry at sum − step does not contain
    // the present weight yet.
    for (std::size_t sum = reached; sum >= step; --sum) {
      probabilities_[sum] = halfOf(probabilities_[sum] + probabilities_[sum - step]);
      if (sum == 0) break;
    }
    for (std::size_t sum = 0; sum < step; ++sum) probabilities_[sum] = halfOf(probabilities_[sum]);
  }
}

double WeightedBernoulliSum::atMost(std::uint64_t sum) const {
  const std::size_t last = std::min<std::size_t>(sum / unit_, probabilities_.size() - 1);
  DoubleDouble total;
  for (std::size_t i = 0; i <= last; ++i) total = total + probabilities_[i];
  return total.high;
}

/// Adds from the far end of the tail, so that small probabilities come first.
double WeightedBernoulliSum::atLeast(std::uint64_t sum) const {
  const std::uint64_t first = sum / unit_ + (sum % unit_ == 0 ? 0 : 1);
  DoubleDouble total;
  for (std::size_t i = probabilities_.size(); i > first; --i) total = total + probabilities_[i - 1];
  return total.high;
}

double WeightedBernoulliSum::twoSided(std::uint64_t sum) const {
  return std::min(1.0, 2.0 * std::min(atMost(sum), atLeast(sum)));
}

}  // namespace analysis

#include "analysis/numerics/fair_coin.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "analysis/numerics/double_double.h"

namespace analysis {
namespace {

/// number · 2^exponent
struct Scaled {
  DoubleDouble number;
  int exponent = 0;
};

/// C(n, k), for k ≤ n/2.
Scaled binomial(double n, double k) {
  constexpr int kStep = 500;
  Scaled result{.number = 1.0, .exponent = 0};
  for (double i = 1.0; i <= k; ++i) {
    result.number = result.number * (n - k + i) / i;
    if (result.number.high < 0x1p500) continue;
    result.number = scaled(result.number, -kStep);
    result.exponent += kStep;
  }
  return result;
}

SmallProbability probabilityOf(const Scaled& scaledP) {
  return {
      .p = heldByDouble(scaledP.number, scaledP.exponent),
      .log10P = (std::log2(scaledP.number.high) + scaledP.exponent) /
                (std::numbers::ln10 / std::numbers::ln2)};
}

/// P(heads ≤ k), k ≤ n/2: the last term times the sum of all in units of it.
Scaled lowerTail(std::uint64_t heads, std::uint64_t tosses) {
  const auto n = static_cast<double>(tosses);
  const auto k = static_cast<double>(heads);
  DoubleDouble sum = 1.0;
  DoubleDouble term = 1.0;
  for (double i = k; i > 0.0 && term.high > 1e-40; --i) {
    term = term * i / (n - i + 1.0);
    sum = sum + term;
  }
  Scaled result = binomial(n, k);
  result.number = result.number * sum;
  result.exponent -= static_cast<int>(tosses);
  return result;
}

void require(std::uint64_t heads, std::uint64_t tosses) {
  if (heads > tosses) throw std::invalid_argument("there are more heads than tosses");
  if (tosses > kMostTosses) throw std::invalid_argument("there are too many tosses of a coin");
}

}  // namespace

SmallProbability headsAtMost(std::uint64_t heads, std::uint64_t tosses) {
  require(heads, tosses);
  if (2 * heads <= tosses) return probabilityOf(lowerTail(heads, tosses));
  if (heads == tosses) return {.p = 1.0, .log10P = 0.0};
  const double above = probabilityOf(lowerTail(tosses - heads - 1, tosses)).p.value_or(0.0);
  return {.p = 1.0 - above, .log10P = std::log1p(-above) / std::numbers::ln10};
}

SmallProbability fairCoinP(std::uint64_t heads, std::uint64_t tosses) {
  require(heads, tosses);
  if (2 * heads == tosses) return {.p = 1.0, .log10P = 0.0};
  Scaled tail = lowerTail(std::min(heads, tosses - heads), tosses);
  ++tail.exponent;
  const SmallProbability both = probabilityOf(tail);
  return both.log10P < 0.0 ? both : SmallProbability{.p = 1.0, .log10P = 0.0};
}

}  // namespace analysis

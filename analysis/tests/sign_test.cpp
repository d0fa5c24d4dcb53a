#include "analysis/tests/sign_test.h"

#include <cmath>
#include <stdexcept>

#include "analysis/numerics/fair_coin.h"

namespace analysis {

SignTestResult signTest(std::span<const double> differences) {
  std::uint64_t positive = 0;
  std::uint64_t negative = 0;
  for (const double difference : differences) {
    if (std::isnan(difference)) throw std::invalid_argument("a difference is no number");
    if (difference > 0.0) ++positive;
    if (difference < 0.0) ++negative;
  }
  return signTest(positive, negative, differences.size() - positive - negative);
}

SignTestResult signTest(std::uint64_t positive, std::uint64_t negative, std::uint64_t zeros) {
  SignTestResult result;
  result.positive = positive;
  result.negative = negative;
  result.zeros = zeros;
  if (positive == 0 && negative == 0) {
    result.reason = zeros == 0 ? reason("no_differences") : reason("no_sign_to_test");
    return result;
  }
  if (positive > kMostTosses || negative > kMostTosses - positive) {
    result.reason = reason("too_many_differences");
    return result;
  }
  const std::uint64_t tosses = positive + negative;
  const SmallProbability both = fairCoinP(positive, tosses);
  result.p = both.p;
  result.log10P = both.log10P;
  result.pLess = headsAtMost(positive, tosses).p;
  result.pGreater = headsAtMost(negative, tosses).p;
  if (!result.p || !result.pLess || !result.pGreater) {
    result.reason = reason("a_p_too_small");
  }
  return result;
}

}  // namespace analysis

#include "analysis/models/wald_estimate.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <boost/math/special_functions/erf.hpp>

namespace analysis {
namespace {

/// log₁₀ P(|Z| ≥ |z|), also where it is too small for a double (Abramowitz & Stegun 1964, 7.1.23).
double log10TwoSidedP(double z) {
  constexpr double kFar = 30.0;
  const double x = std::abs(z) / std::numbers::sqrt2;
  if (std::abs(z) < kFar) return std::log10(boost::math::erfc(x));
  const double r = 0.5 / (x * x);
  const double series = 1.0 - r * (1.0 - 3.0 * r * (1.0 - 5.0 * r * (1.0 - 7.0 * r)));
  const double logP = -x * x - std::log(x) - 0.5 * std::log(std::numbers::pi) + std::log(series);
  return logP / std::numbers::ln10;
}

}  // namespace

WaldEstimate waldEstimate(std::string name, double value, double variance) {
  WaldEstimate estimate{.name = std::move(name), .estimate = value};
  estimate.standardError = std::sqrt(std::max(variance, 0.0));
  estimate.z = estimate.standardError > 0.0 ? value / estimate.standardError : 0.0;
  estimate.p = boost::math::erfc(std::abs(estimate.z) / std::numbers::sqrt2);
  estimate.log10P = log10TwoSidedP(estimate.z);
  estimate.oddsRatio = std::exp(value);
  return estimate;
}

Interval confidenceInterval(const WaldEstimate& estimate, double level) {
  if (!(level > 0.0 && level < 1.0)) {
    throw std::invalid_argument("a confidence level lies between 0 and 1");
  }
  const double reach = std::numbers::sqrt2 * boost::math::erf_inv(level) * estimate.standardError;
  return {.low = estimate.estimate - reach, .high = estimate.estimate + reach};
}

Interval oddsRatioInterval(const WaldEstimate& estimate, double level) {
  const Interval interval = confidenceInterval(estimate, level);
  return {.low = std::exp(interval.low), .high = std::exp(interval.high)};
}

}  // namespace analysis

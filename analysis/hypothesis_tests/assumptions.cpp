#include "analysis/hypothesis_tests/assumptions.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <boost/math/special_functions/erf.hpp>

#include "analysis/hypothesis_tests/anova.h"
#include "analysis/numerics/exact_arithmetic.h"
#include "analysis/numerics/tail_probabilities.h"

namespace analysis {
namespace {

constexpr std::size_t kSmallestSample = 3;
constexpr std::size_t kLargestSample = 5000;

/// Horner's scheme; the constant comes first.
double polynomial(std::span<const double> coefficients, double x) {
  double sum = 0.0;
  for (std::size_t i = coefficients.size(); i-- > 0;) sum = sum * x + coefficients[i];
  return sum;
}

double normalQuantile(double p) {
  return -std::numbers::sqrt2 * boost::math::erfc_inv(2.0 * p);
}

/// The weights of the upper half, from the largest value inwards; the lower half has their
/// negatives.
std::vector<double> weightsOf(std::size_t count) {
  constexpr double kLargest[] = {0.0, 0.221157, -0.147981, -2.071190, 4.434685, -2.706056};
  constexpr double kSecond[] = {0.0, 0.042981, -0.293762, -1.752461, 5.682633, -3.582633};
  if (count == kSmallestSample) return {std::numbers::sqrt2 / 2.0};

  const auto n = static_cast<double>(count);
  std::vector<double> weights(count / 2);
  double squares = 0.0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    weights[i] = -normalQuantile((static_cast<double>(i + 1) - 0.375) / (n + 0.25));
    squares += 2.0 * weights[i] * weights[i];
  }

  const std::size_t correctedCount = count > 5 ? 2 : 1;
  const double u = 1.0 / std::sqrt(n);
  const double largest = polynomial(kLargest, u) + weights[0] / std::sqrt(squares);
  const double second = count > 5 ? polynomial(kSecond, u) + weights[1] / std::sqrt(squares) : 0.0;
  double rest = squares - 2.0 * weights[0] * weights[0];
  if (count > 5) rest -= 2.0 * weights[1] * weights[1];
  const double share = 1.0 - 2.0 * largest * largest - 2.0 * second * second;
  for (std::size_t i = correctedCount; i < weights.size(); ++i)
    weights[i] /= std::sqrt(rest / share);
  weights[0] = largest;
  if (count > 5) weights[1] = second;
  return weights;
}

/// W and 1 − W of sorted values that are not all equal.
struct Statistic {
  double w = 1.0;
  double rest = 0.0;  ///< 1 − W, to full precision
};

Statistic statisticOf(std::span<const double> sorted) {
  constexpr double kLarge = 1e300;
  const bool isLarge = -sorted.front() > kLarge || sorted.back() > kLarge;
  const double unit = isLarge ? 0.25 : 1.0;  // a power of two: the range does not overflow
  const double low = unit * sorted.front();
  const double range = unit * sorted.back() - low;
  DoubleDouble sum;
  DoubleDouble squares;
  for (const double value : sorted) {
    // W does not depend on offset and scale. Values scaled to 0 … 1 neither overflow nor lose
    // digits.
    const DoubleDouble scaledValue = DoubleDouble::difference(unit * value, low) / range;
    sum = sum + scaledValue;
    squares = squares + scaledValue * scaledValue;
  }

  const std::vector<double> weights = weightsOf(sorted.size());
  DoubleDouble weighted;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const double above = unit * sorted[sorted.size() - 1 - i];
    weighted = weighted + DoubleDouble::difference(above, unit * sorted[i]) / range * weights[i];
  }
  const DoubleDouble spread = squares - sum * sum / static_cast<double>(sorted.size());
  const DoubleDouble w = weighted * weighted / spread;
  return {.w = std::min(1.0, w.high), .rest = std::max(0.0, (DoubleDouble(1.0) - w).high)};
}

double pOf(const Statistic& statistic, std::size_t count) {
  constexpr double kSmallBound[] = {-2.273, 0.459};
  constexpr double kSmallMean[] = {0.5440, -0.39978, 0.025054, -6.714e-4};
  constexpr double kSmallDeviation[] = {1.3822, -0.77857, 0.062767, -0.0020322};
  constexpr double kMean[] = {-1.5861, -0.31082, -0.083751, 0.0038915};
  constexpr double kDeviation[] = {-0.4803, -0.082676, 0.0030302};
  constexpr std::size_t kLargestSmallSample = 11;

  if (count == kSmallestSample) {
    const double angle = std::asin(std::sqrt(statistic.w)) - std::asin(std::sqrt(0.75));
    return std::clamp(6.0 / std::numbers::pi * angle, 0.0, 1.0);
  }
  const auto n = static_cast<double>(count);
  const double y = std::log(statistic.rest);
  if (count > kLargestSmallSample) {
    const double x = std::log(n);
    return normalUpperP((y - polynomial(kMean, x)) / std::exp(polynomial(kDeviation, x)));
  }
  const double bound = polynomial(kSmallBound, n);
  if (y >= bound) return 0.0;
  const double transformed = -std::log(bound - y);
  return normalUpperP(
      (transformed - polynomial(kSmallMean, n)) / std::exp(polynomial(kSmallDeviation, n)));
}

}  // namespace

ShapiroWilkResult shapiroWilkTest(std::span<const double> values) {
  std::vector<double> sorted(values.begin(), values.end());
  if (!std::ranges::all_of(sorted, [](double value) { return std::isfinite(value); })) {
    throw std::invalid_argument("a value is infinite or no number: it has no place in an order");
  }
  std::ranges::sort(sorted);

  ShapiroWilkResult result;
  result.n = sorted.size();
  if (sorted.size() < kSmallestSample || sorted.size() > kLargestSample) {
    result.reason = reason("three_to_5000_values");
  } else if (sorted.front() == sorted.back()) {
    result.reason = reason("no_shape");
  } else {
    const Statistic statistic = statisticOf(sorted);
    result.w = statistic.w;
    result.p = pOf(statistic, sorted.size());
  }
  return result;
}

namespace {

/// @param values  must not be empty.
double medianOf(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t half = values.size() / 2;
  if (values.size() % 2 == 1) return values[half];
  return 0.5 * values[half - 1] + 0.5 * values[half];
}

/// Makes values that differ only by rounding errors equal, across all groups.
void removeRoundingNoise(std::vector<std::vector<double>>& groups) {
  std::vector<double> all;
  for (const auto& group : groups) all.insert(all.end(), group.begin(), group.end());
  const auto clean = withoutRoundingNoise(all);
  auto next = clean.begin();
  for (auto& group : groups) {
    for (double& value : group) value = *next++;
  }
}

std::vector<double> deviationsOf(const std::vector<double>& values) {
  constexpr double kQuarter = 0.25;  // so that no deviation overflows; F is the same for any scale
  const double median = kQuarter * medianOf(values);
  std::vector<double> deviations;
  deviations.reserve(values.size());
  for (const double value : values) deviations.push_back(std::abs(kQuarter * value - median));
  return deviations;
}

bool isFinite(double value) {
  return std::isfinite(value);
}

}  // namespace

BrownForsytheResult brownForsytheTest(std::span<const std::vector<double>> groups) {
  std::vector<std::vector<double>> deviations;
  for (const auto& values : groups) {
    if (!std::ranges::all_of(values, isFinite)) {
      throw std::invalid_argument("a value is infinite or no number: it has no place in a median");
    }
    deviations.push_back(values.empty() ? values : deviationsOf(values));
  }

  removeRoundingNoise(deviations);
  const OneWayAnovaResult anova = oneWayAnova(deviations);
  BrownForsytheResult result;
  result.degreesOfFreedom1 = anova.degreesOfFreedom1;
  result.degreesOfFreedom2 = anova.degreesOfFreedom2;
  result.f = anova.f;
  result.p = anova.p;
  result.log10P = anova.log10P;
  if (result.p) return result;

  result.reason = anova.degreesOfFreedom1 ? reason("equally_far_from_median") : anova.reason;
  return result;
}

}  // namespace analysis

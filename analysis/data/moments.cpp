#include "analysis/data/moments.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "analysis/numerics/exact_arithmetic.h"

namespace analysis {
namespace {

/// The exponent of the power of two just above the largest magnitude, so that scaled values stay
/// below one. It is bounded below, so that the inverse does not overflow.
int exponentOf(std::span<const double> values) {
  double largest = 0.0;
  for (const double value : values) {
    if (!std::isfinite(value)) {
      throw std::invalid_argument("a value is infinite or no number: it has no place in a mean");
    }
    largest = std::max(largest, std::abs(value));
  }
  if (largest == 0.0) return 0;

  constexpr int kSmallest = -1000;
  int exponent = 0;
  std::frexp(largest, &exponent);
  return std::max(exponent, kSmallest);
}

/// The exponent of the group with the larger variance. A constant group is ignored: its mean,
/// however large, must not set the unit, or the other variance might underflow.
int spreadExponentOf(const Moments& a, const Moments& b) {
  if (a.isConstant()) return b.exponent;
  if (b.isConstant()) return a.exponent;
  return std::max(a.exponent, b.exponent);
}

}  // namespace

Moments momentsOf(std::span<const double> values) {
  Moments moments{.n = values.size(), .exponent = exponentOf(values), .mean = {}, .variance = {}};
  if (values.empty()) return moments;

  const double unit = std::ldexp(1.0, -moments.exponent);
  const double pivot = values.front() * unit;
  const auto n = static_cast<double>(values.size());

  DoubleDouble sum;
  for (const double value : values) sum = sum + DoubleDouble::difference(value * unit, pivot);
  const DoubleDouble shift = sum / n;
  moments.mean = shift + pivot;
  if (values.size() < 2) return moments;

  // Without rounding the residuals add up to zero; their actual sum corrects the squares.
  DoubleDouble residualSum;
  DoubleDouble squares;
  for (const double value : values) {
    const DoubleDouble rest = DoubleDouble::difference(value * unit, pivot) - shift;
    residualSum = residualSum + rest;
    squares = squares + rest * rest;
  }
  moments.variance = (squares - residualSum * residualSum / n) / (n - 1.0);
  return moments;
}

Moments momentsOf(const LikertCounts& counts) {
  const auto n = static_cast<Int128>(counts.total());
  Int128 sum = 0;  // of answer − lowest point, which leaves the variance unchanged
  Int128 squares = 0;
  Int128 step = 0;
  for (const std::uint64_t times : counts.counts()) {
    sum += step * static_cast<Int128>(times);
    squares += step * step * static_cast<Int128>(times);
    ++step;
  }

  Moments moments{.n = counts.total(), .exponent = 0, .mean = {}, .variance = {}};
  if (n > 0) moments.mean = exactQuotient(n * counts.lowest() + sum, n);
  if (n > 1) moments.variance = exactQuotient(n * squares - sum * sum, n * (n - 1));
  return moments;
}

Summary summarise(std::span<const double> values) {
  return summarise(momentsOf(values));
}

Summary summarise(const Moments& moments) {
  Summary summary{.n = moments.n, .mean = {}, .variance = {}, .standardDeviation = {}};
  if (moments.n > 0) summary.mean = std::ldexp(moments.mean.high, moments.exponent);
  if (moments.n > 1) {
    summary.variance = toDouble(moments.variance, 2 * moments.exponent);
    summary.standardDeviation = toDouble(squareRoot(moments.variance), moments.exponent);
  }
  return summary;
}

Contrast contrastOf(const Moments& group1, const Moments& group2) {
  const int size = std::max(group1.exponent, group2.exponent);
  const int spread = spreadExponentOf(group1, group2);
  return {
      .meanExponent = size,
      .difference =
          scaled(group1.mean, group1.exponent - size) - scaled(group2.mean, group2.exponent - size),
      .spreadExponent = spread,
      .variance1 = scaled(group1.variance, 2 * (group1.exponent - spread)),
      .variance2 = scaled(group2.variance, 2 * (group2.exponent - spread))};
}

double tOf(const Contrast& contrast, const DoubleDouble& standardError) {
  if (contrast.difference.isZero()) return 0.0;
  if (standardError.isZero()) {
    return std::copysign(std::numeric_limits<double>::infinity(), contrast.difference.high);
  }
  const DoubleDouble t = contrast.difference / standardError;
  return std::ldexp(t.high, contrast.meanExponent - contrast.spreadExponent);
}

}  // namespace analysis

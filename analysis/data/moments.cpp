#include "analysis/data/moments.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "analysis/numerics/exact_quotient.h"

namespace analysis {
namespace {

/// The power of two just above the largest value, so that scaled values stay below one; not so
/// small that its inverse would overflow.
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

  DoubleDouble rests;
  DoubleDouble squares;
  for (const double value : values) {
    const DoubleDouble rest = DoubleDouble::difference(value * unit, pivot) - shift;
    rests = rests + rest;
    squares = squares + rest * rest;
  }
  moments.variance = (squares - rests * rests / n) / (n - 1.0);
  return moments;
}

Moments momentsOf(const LikertCounts& counts) {
  const auto n = static_cast<Wide>(counts.total());
  Wide sum = 0;  // of the answers counted from the lowest point: the variance does not mind
  Wide squares = 0;
  Wide step = 0;
  for (const std::uint64_t times : counts.counts()) {
    sum += step * static_cast<Wide>(times);
    squares += step * step * static_cast<Wide>(times);
    ++step;
  }

  Moments moments{.n = counts.total(), .exponent = 0, .mean = {}, .variance = {}};
  if (n > 0) moments.mean = exactQuotient(n * counts.lowest() + sum, n);
  if (n > 1) moments.variance = exactQuotient(n * squares - sum * sum, n * (n - 1));
  return moments;
}

}  // namespace analysis

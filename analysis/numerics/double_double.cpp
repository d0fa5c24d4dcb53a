#include "analysis/numerics/double_double.h"

#include <cmath>

namespace analysis {
namespace {

/// a + b, exactly, where |a| ≥ |b|.
DoubleDouble orderedSum(double a, double b) noexcept {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

}  // namespace

DoubleDouble DoubleDouble::sum(double a, double b) noexcept {
  const double sum = a + b;
  const double ofB = sum - a;
  return {sum, (a - (sum - ofB)) + (b - ofB)};
}

DoubleDouble DoubleDouble::product(double a, double b) noexcept {
  const double product = a * b;
  return {product, std::fma(a, b, -product)};
}

DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) noexcept {
  const DoubleDouble highs = DoubleDouble::sum(a.high, b.high);
  const DoubleDouble lows = DoubleDouble::sum(a.low, b.low);
  const DoubleDouble most = orderedSum(highs.high, highs.low + lows.high);
  return orderedSum(most.high, most.low + lows.low);
}

DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) noexcept {
  return a + -b;
}

DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) noexcept {
  const DoubleDouble highs = DoubleDouble::product(a.high, b.high);
  return orderedSum(highs.high, highs.low + (a.high * b.low + a.low * b.high));
}

DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) noexcept {
  const double first = a.high / b.high;
  DoubleDouble rest = a - b * first;
  const double second = rest.high / b.high;
  rest = rest - b * second;
  const double third = rest.high / b.high;
  return orderedSum(first, second) + third;
}

DoubleDouble squareRoot(const DoubleDouble& number) noexcept {
  if (number.isZero()) return 0.0;
  const double root = std::sqrt(number.high);
  const DoubleDouble rest = number - DoubleDouble::product(root, root);
  return orderedSum(root, rest.high / (2.0 * root));
}

DoubleDouble scaled(const DoubleDouble& number, int exponent) noexcept {
  return {std::ldexp(number.high, exponent), std::ldexp(number.low, exponent)};
}

std::optional<double> heldByDouble(const DoubleDouble& number, int exponent) noexcept {
  const double nearest = std::ldexp(number.high, exponent);
  const bool isHeld = number.isZero() || std::isnormal(nearest);
  return isHeld ? std::optional(nearest) : std::nullopt;
}

}  // namespace analysis

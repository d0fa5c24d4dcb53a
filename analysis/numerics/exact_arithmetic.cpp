#include "analysis/numerics/exact_arithmetic.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace analysis {
namespace {

/// a + b, exactly, where |a| ≥ |b|.
DoubleDouble orderedSum(double a, double b) noexcept {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

constexpr Wide kOne = 1;
constexpr int kDigits = 120;  // binary; a double-double has 106 or a few more

constexpr std::int64_t kMostParts = 1000;
constexpr double kNoise = 1e-12;        // of the largest number
constexpr double kMostMultiples = 1e6;  // beyond, chance alone would find a unit

double largestOf(std::span<const double> numbers) {
  double largest = 0.0;
  for (const double number : numbers) {
    if (!std::isfinite(number)) {
      throw std::invalid_argument(
          "a value is infinite or no number: it is no multiple of anything");
    }
    largest = std::max(largest, std::abs(number));
  }
  return largest;
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

DoubleDouble exactQuotient(Wide numerator, Wide denominator) {
  if (numerator < 0) return -exactQuotient(-numerator, denominator);
  if (numerator == 0) return 0.0;

  Wide quotient = numerator / denominator;
  Wide rest = numerator % denominator;
  int exponent = 0;
  for (; quotient < (kOne << (kDigits - 1)); --exponent) {
    rest <<= 1;
    quotient = (quotient << 1) | (rest >= denominator ? 1 : 0);
    if (rest >= denominator) rest -= denominator;
  }
  if (rest != 0) quotient |= 1;  // just above the digits that are written: enough to round rightly

  const auto high = static_cast<double>(quotient);
  const auto low = static_cast<double>(quotient - static_cast<Wide>(high));
  return scaled({high, low}, exponent);
}

std::optional<Multiples> commonUnitOf(std::span<const double> numbers) {
  const double largest = largestOf(numbers);
  for (std::int64_t parts = 1; parts <= kMostParts; ++parts) {
    const auto q = static_cast<double>(parts);
    if (largest * q > kMostMultiples) return std::nullopt;
    const double noise = kNoise * largest * q;
    const bool fits = std::ranges::all_of(numbers, [&](double number) {
      return std::abs(number * q - std::round(number * q)) <= noise;
    });
    if (!fits || (largest > 0.0 && largest * q < 0.5)) continue;

    Multiples result{.multiples = {}, .denominator = parts};
    for (const double number : numbers) {
      result.multiples.push_back(static_cast<std::int64_t>(std::round(number * q)));
    }
    return result;
  }
  return std::nullopt;
}

std::vector<double> withoutRoundingNoise(std::span<const double> numbers) {
  const auto common = commonUnitOf(numbers);
  std::vector<double> cleaned(numbers.begin(), numbers.end());
  if (!common) return cleaned;
  std::ranges::transform(common->multiples, cleaned.begin(), [&](std::int64_t multiple) {
    return static_cast<double>(multiple) / static_cast<double>(common->denominator);
  });
  return cleaned;
}

}  // namespace analysis

#include "analysis/numerics/exact_arithmetic.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace analysis {
namespace {

/// a + b, exactly, where |a| ≥ |b| (Dekker 1971).
DoubleDouble orderedSum(double a, double b) noexcept {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

constexpr Int128 kOne = 1;
constexpr int kDigits = 120;  // binary digits; a double-double has at least 106

constexpr std::int64_t kMostParts = 1000;
constexpr double kRoundingNoise = 1e-12;  // relative to the largest number
// For larger multiples, any numbers would have a common unit by chance.
constexpr double kMostMultiples = 1e6;

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

/// Knuth's two-sum: the rounding error of a + b is itself a double, computed without comparing a
/// and b. The order of operations matters, and -ffast-math would destroy it.
DoubleDouble DoubleDouble::sum(double a, double b) noexcept {
  const double sum = a + b;
  const double ofB = sum - a;
  return {sum, (a - (sum - ofB)) + (b - ofB)};
}

DoubleDouble DoubleDouble::product(double a, double b) noexcept {
  const double product = a * b;
  // fma rounds once: what it returns is the exact error of the rounded product.
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

/// Long division in base 2^53: each step divides the remainder of the step before.
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
  // One step of Newton's method from the double nearest to the root doubles its digits.
  const double root = std::sqrt(number.high);
  const DoubleDouble rest = number - DoubleDouble::product(root, root);
  return orderedSum(root, rest.high / (2.0 * root));
}

DoubleDouble scaled(const DoubleDouble& number, int exponent) noexcept {
  return {std::ldexp(number.high, exponent), std::ldexp(number.low, exponent)};
}

std::optional<double> toDouble(const DoubleDouble& number, int exponent) noexcept {
  const double nearest = std::ldexp(number.high, exponent);
  const bool isHeld = number.isZero() || std::isnormal(nearest);
  return isHeld ? std::optional(nearest) : std::nullopt;
}

DoubleDouble exactQuotient(Int128 numerator, Int128 denominator) {
  if (numerator < 0) return -exactQuotient(-numerator, denominator);
  if (numerator == 0) return 0.0;

  Int128 quotient = numerator / denominator;
  Int128 rest = numerator % denominator;
  int exponent = 0;
  // Long division in base 2, until the quotient has enough digits.
  for (; quotient < (kOne << (kDigits - 1)); --exponent) {
    rest <<= 1;
    quotient = (quotient << 1) | (rest >= denominator ? 1 : 0);
    if (rest >= denominator) rest -= denominator;
  }
  // A sticky bit: the true quotient lies just above, so that a tie is not rounded to even.
  if (rest != 0) quotient |= 1;

  const auto high = static_cast<double>(quotient);
  const auto low = static_cast<double>(quotient - static_cast<Int128>(high));
  return scaled({high, low}, exponent);
}

bool isRoundingError(double number, double size) noexcept {
  return std::abs(number) <= 8.0 * std::numeric_limits<double>::epsilon() * size;
}

std::optional<ScaledIntegers> commonUnitOf(std::span<const double> numbers) {
  const double largest = largestOf(numbers);
  for (std::int64_t parts = 1; parts <= kMostParts; ++parts) {
    const auto q = static_cast<double>(parts);
    if (largest * q > kMostMultiples) return std::nullopt;
    const double noise = kRoundingNoise * largest * q;
    const bool fits = std::ranges::all_of(numbers, [&](double number) {
      return std::abs(number * q - std::round(number * q)) <= noise;
    });
    if (!fits || (largest > 0.0 && largest * q < 0.5)) continue;  // all would round to zero

    ScaledIntegers result{.multiples = {}, .denominator = parts};
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

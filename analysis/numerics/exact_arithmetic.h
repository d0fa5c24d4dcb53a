#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace analysis {

/// A number of about 31 digits, as the unevaluated sum of two doubles: high is the double nearest
/// to it, low is what is left.
///
/// Sums and products keep the digits that a double would lose (Dekker 1971; Hida, Li & Bailey
/// 2001). The range is that of a double: scale numbers first that may overflow.
struct DoubleDouble {
  double high = 0.0;
  double low = 0.0;

  constexpr DoubleDouble() = default;
  constexpr DoubleDouble(double number) : high(number) {}  // NOLINT: implicit, without loss
  constexpr DoubleDouble(double h, double l) : high(h), low(l) {}

  /// a + b, exactly.
  static DoubleDouble sum(double a, double b) noexcept;
  /// a − b, exactly.
  static DoubleDouble difference(double a, double b) noexcept { return sum(a, -b); }
  /// a · b, exactly.
  static DoubleDouble product(double a, double b) noexcept;

  constexpr DoubleDouble operator-() const noexcept { return {-high, -low}; }
  constexpr bool isZero() const noexcept { return high == 0.0; }
};

DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) noexcept;
DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) noexcept;
DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) noexcept;
DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) noexcept;

/// @param number  not negative.
DoubleDouble squareRoot(const DoubleDouble& number) noexcept;

/// number · 2^exponent.
DoubleDouble scaled(const DoubleDouble& number, int exponent) noexcept;

/// The double nearest to number · 2^exponent; std::nullopt if a double would overflow or, below
/// 2.2e-308, lose digits.
std::optional<double> toDouble(const DoubleDouble& number, int exponent) noexcept;

/// A whole number of 128 bits: what sums of squares of very many answers need.
__extension__ using Wide = __int128;

/// The quotient of two whole numbers. Its high part is the correctly rounded double, and both parts
/// together have all the digits of a DoubleDouble.
///
/// @param numerator    of less than 2^127
/// @param denominator  between 1 and 2^126
DoubleDouble exactQuotient(Wide numerator, Wide denominator);

/// Numbers as whole multiples of 1/denominator.
struct ScaledIntegers {
  std::vector<std::int64_t> multiples;
  std::int64_t denominator = 1;
};

/// The smallest q ≤ 1000 such that all numbers are whole multiples of 1/q, but for the rounding of
/// their last digits (1e-12 of the largest). std::nullopt if there is no such q, as for measured
/// values.
///
/// The means of a few answers are such multiples: three answers give thirds. Computed as doubles,
/// two means that should be equal often differ in the last digit, and are then not seen as ties.
///
/// @throws std::invalid_argument  if a value is infinite or NaN.
std::optional<ScaledIntegers> commonUnitOf(std::span<const double> numbers);

/// The numbers as the doubles nearest to their multiples of a common unit, so that what should be
/// equal is equal; as they are if there is no such unit.
/// @throws std::invalid_argument  as above.
std::vector<double> withoutRoundingNoise(std::span<const double> numbers);

}  // namespace analysis

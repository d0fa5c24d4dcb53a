#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace analysis {

/// A number of about 31 digits, as the unevaluated sum of two doubles: high is the double nearest
/// to it, low is the remainder.
///
/// Sums and products keep the digits that a double would lose (Dekker 1971; Hida, Li & Bailey
/// 2001). The range is that of a double: scale numbers that may overflow.
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

/// A 128-bit integer, for sums of squares of very many answers.
__extension__ using Int128 = __int128;

/// The quotient of two whole numbers, to the precision of a DoubleDouble; `high` is the correctly
/// rounded double.
///
/// @param numerator    less than 2^127 in magnitude
/// @param denominator  between 1 and 2^126
DoubleDouble exactQuotient(Int128 numerator, Int128 denominator);

/// Pascal's triangle: element [n][k] is the number of ways to choose k of n, for n up to @p last.
template <typename Number>
std::vector<std::vector<Number>> binomialCoefficients(std::size_t last) {
  std::vector<std::vector<Number>> rows;
  for (std::size_t n = 0; n <= last; ++n) {
    rows.emplace_back(n + 1, Number(1));
    for (std::size_t k = 1; k < n; ++k) rows[n][k] = rows[n - 1][k - 1] + rows[n - 1][k];
  }
  return rows;
}

/// Numbers represented as multiples / denominator.
struct ScaledIntegers {
  std::vector<std::int64_t> multiples;
  std::int64_t denominator = 1;
};

/// Finds the smallest q ≤ 1000 such that all numbers are whole multiples of 1/q, up to rounding
/// errors (1e-12 of the largest). std::nullopt if there is no such q, as for measured values.
///
/// For instance, the means of three answers are multiples of 1/3. Two means that should be equal
/// often differ in the last digit of a double; rank tests would then miss the tie.
///
/// @throws std::invalid_argument  if a value is infinite or NaN.
std::optional<ScaledIntegers> commonUnitOf(std::span<const double> numbers);

/// Whether a number that was computed from values of at most this size may be nothing but their
/// rounding errors: up to eight units in the last place of the size. Differences and residuals that
/// are no farther apart count as equal.
bool isRoundingError(double number, double size) noexcept;

/// The numbers rounded to multiples of their common unit (see commonUnitOf()), so that values that
/// should be equal are equal; unchanged if there is no common unit.
/// @throws std::invalid_argument  if a value is infinite or NaN.
std::vector<double> withoutRoundingNoise(std::span<const double> numbers);

}  // namespace analysis

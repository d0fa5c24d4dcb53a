#pragma once

#include <optional>

namespace analysis {

/// A number of about 31 digits, as the unevaluated sum of two doubles: high is the double nearest
/// to it, low is what is left.
///
/// Sums of doubles keep here what a double would lose (Dekker 1971; Hida, Li & Bailey 2001). It
/// widens the precision and not the range: who uses it scales first.
struct DoubleDouble {
  double high = 0.0;
  double low = 0.0;

  constexpr DoubleDouble() = default;
  constexpr DoubleDouble(double number) : high(number) {}  // NOLINT: every double is one
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

/// The double nearest to number · 2^exponent; nothing where a double would overflow or, below
/// 2.2e-308, lose digits.
std::optional<double> heldByDouble(const DoubleDouble& number, int exponent) noexcept;

}  // namespace analysis

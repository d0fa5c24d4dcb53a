#include "analysis/published/reported_number.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "analysis/numerics/exact_arithmetic.h"

namespace analysis {
namespace {

std::int64_t powerOfTen(int exponent) {
  std::int64_t power = 1;
  for (int i = 0; i < exponent; ++i) power *= 10;
  return power;
}

bool isDigit(char character) {
  return character >= '0' && character <= '9';
}

bool isMark(char character, DecimalMark mark) {
  return character == '.' || (character == ',' && mark == DecimalMark::PointOrComma);
}

}  // namespace

double ReportedNumber::value() const {
  return static_cast<double>(digits) / static_cast<double>(powerOfTen(decimals));
}

std::string ReportedNumber::text() const {
  std::string figures = std::to_string(std::abs(digits));
  const auto places = static_cast<std::size_t>(decimals);
  if (figures.size() <= places) figures.insert(0, places + 1 - figures.size(), '0');
  if (places > 0) figures.insert(figures.size() - places, ".");
  return (digits < 0 ? "-" : "") + figures;
}

Interval ReportedNumber::bounds(Reading reading) const {
  const auto unit = static_cast<double>(powerOfTen(decimals));
  const auto number = static_cast<double>(digits);
  if (reading == Reading::Rounded) {
    return {.low = (number - 0.5) / unit, .high = (number + 0.5) / unit};
  }
  return {
      .low = digits > 0 ? number / unit : (number - 1.0) / unit,
      .high = digits < 0 ? number / unit : (number + 1.0) / unit};
}

bool ReportedNumber::prints(
    std::int64_t numerator, std::int64_t denominator, Reading reading) const {
  // Both sides times denominator · 10^decimals: whole numbers, which are compared without rounding.
  const Wide given = Wide(powerOfTen(decimals)) * numerator;
  const Wide printed = Wide(digits) * denominator;
  if (reading == Reading::Rounded) {
    const Wide gap = 2 * (given - printed);
    return -Wide(denominator) <= gap && gap <= Wide(denominator);
  }
  const Wide gap = digits < 0 || (digits == 0 && given < 0) ? printed - given : given - printed;
  return gap >= 0 && gap < denominator;
}

bool ReportedNumber::printsRootOf(
    std::int64_t numerator, std::int64_t denominator, Reading reading) const {
  if (digits < 0) return false;
  const Wide given = Wide(powerOfTen(2 * decimals)) * numerator;
  if (reading == Reading::Rounded) {
    const Wide low = std::max<std::int64_t>(2 * digits - 1, 0);
    const Wide high = 2 * digits + 1;
    return low * low * denominator <= 4 * given && 4 * given <= high * high * denominator;
  }
  const Wide low = digits;
  const Wide high = digits + 1;
  return low * low * denominator <= given && given < high * high * denominator;
}

std::optional<ReportedNumber> reportedNumber(std::string_view text, DecimalMark mark) {
  const bool isNegative = text.starts_with('-');
  if (isNegative || text.starts_with('+')) text.remove_prefix(1);

  ReportedNumber number;
  int figures = 0;
  bool hasMark = false;
  for (const char character : text) {
    if (isMark(character, mark) && !hasMark) {
      hasMark = true;
    } else if (isDigit(character) && figures < ReportedNumber::kMostDigits) {
      number.digits = 10 * number.digits + (character - '0');
      number.decimals += hasMark ? 1 : 0;
      ++figures;
    } else {
      return std::nullopt;
    }
  }
  if (figures == 0) return std::nullopt;
  if (isNegative) number.digits = -number.digits;
  return number;
}

}  // namespace analysis

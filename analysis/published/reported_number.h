#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "analysis/data/csv_table.h"
#include "analysis/numerics/interval.h"

namespace analysis {

/// How a number lost the digits that are not printed.
enum class Reading {
  Rounded,    ///< to the nearest; a half may have gone either way
  Truncated,  ///< cut off, towards zero
};

/// A number as it is printed: its digits, and how many of them are decimals. "4.10" says more than
/// "4.1".
struct ReportedNumber {
  static constexpr int kMostDigits = 9;

  std::int64_t digits = 0;  ///< 4.10 has 410
  int decimals = 0;         ///< and 2

  double value() const;
  /// With as many decimals as were printed.
  std::string text() const;

  /// Everything that would be printed like this: x ± half a unit of the last digit where it was
  /// rounded; from x to one unit further from zero where it was truncated.
  Interval bounds(Reading reading) const;

  /// Whether numerator / denominator would be printed like this, in whole numbers and without any
  /// error.
  /// @param denominator  positive.
  bool prints(std::int64_t numerator, std::int64_t denominator, Reading reading) const;

  /// Whether √(numerator / denominator) would be printed like this.
  /// @param numerator  not negative.  @param denominator  positive.
  bool printsRootOf(std::int64_t numerator, std::int64_t denominator, Reading reading) const;
};

/// Reads "4.1", ".021", "-3" or, where the mark allows it, "4,1"; std::nullopt for other text and
/// for more than kMostDigits digits.
std::optional<ReportedNumber> reportedNumber(
    std::string_view text, DecimalMark mark = DecimalMark::Point);

}  // namespace analysis

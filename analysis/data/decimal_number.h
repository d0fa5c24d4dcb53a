#pragma once

#include <optional>
#include <string_view>

namespace analysis {

/// How a table writes the point of a decimal number.
enum class DecimalMark {
  Point,         ///< 4.5
  PointOrComma,  ///< 4.5 or 4,5; never both in one number
};

/// The double nearest to a decimal number, whatever the locale; nothing for other text, for
/// infinities and for numbers that a double cannot hold.
std::optional<double> decimalNumber(std::string_view text, DecimalMark mark = DecimalMark::Point);

}  // namespace analysis

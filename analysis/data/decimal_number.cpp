#include "analysis/data/decimal_number.h"

#include <charconv>
#include <cmath>
#include <string>
#include <system_error>

namespace analysis {

std::optional<double> decimalNumber(std::string_view text, DecimalMark mark) {
  std::string digits(text);
  const auto comma = digits.find(',');
  const bool isCommaMark = mark == DecimalMark::PointOrComma && comma != std::string::npos &&
                           digits.find('.') == std::string::npos;
  if (isCommaMark) digits[comma] = '.';
  if (digits.starts_with('+') && !digits.starts_with("+-")) digits.erase(0, 1);

  double number = 0.0;
  const char* const end = digits.data() + digits.size();
  const auto [stopped, problem] = std::from_chars(digits.data(), end, number);
  const bool isNumber = problem == std::errc{} && stopped == end && std::isfinite(number);
  return isNumber ? std::optional(number) : std::nullopt;
}

}  // namespace analysis

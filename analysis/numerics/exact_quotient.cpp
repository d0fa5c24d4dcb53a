#include "analysis/numerics/exact_quotient.h"

#include <cmath>

namespace analysis {
namespace {
constexpr Wide kOne = 1;
constexpr int kDigits = 120;  // binary; a double-double has 106 or a few more
}  // namespace

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

}  // namespace analysis

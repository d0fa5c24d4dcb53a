#include "analysis/data/contrast.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace analysis {
namespace {

/// A constant group has a size but no spread, and has no say in the units of spread.
int spreadExponentOf(const Moments& a, const Moments& b) {
  if (a.isConstant()) return b.exponent;
  if (b.isConstant()) return a.exponent;
  return std::max(a.exponent, b.exponent);
}

}  // namespace

Contrast contrastOf(const Moments& group1, const Moments& group2) {
  const int size = std::max(group1.exponent, group2.exponent);
  const int spread = spreadExponentOf(group1, group2);
  return {
      .meanExponent = size,
      .difference =
          scaled(group1.mean, group1.exponent - size) - scaled(group2.mean, group2.exponent - size),
      .spreadExponent = spread,
      .variance1 = scaled(group1.variance, 2 * (group1.exponent - spread)),
      .variance2 = scaled(group2.variance, 2 * (group2.exponent - spread))};
}

double tOf(const Contrast& contrast, const DoubleDouble& standardError) {
  if (contrast.difference.isZero()) return 0.0;
  if (standardError.isZero()) {
    return std::copysign(std::numeric_limits<double>::infinity(), contrast.difference.high);
  }
  const DoubleDouble t = contrast.difference / standardError;
  return std::ldexp(t.high, contrast.meanExponent - contrast.spreadExponent);
}

}  // namespace analysis

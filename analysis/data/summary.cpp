#include "analysis/data/summary.h"

#include <cmath>

namespace analysis {

Summary summarise(std::span<const double> values) {
  return summarise(momentsOf(values));
}

Summary summarise(const LikertCounts& counts) {
  return summarise(momentsOf(counts));
}

Summary summarise(const Moments& moments) {
  Summary summary{.n = moments.n, .mean = {}, .variance = {}, .standardDeviation = {}};
  if (moments.n > 0) summary.mean = std::ldexp(moments.mean.high, moments.exponent);
  if (moments.n > 1) {
    summary.variance = heldByDouble(moments.variance, 2 * moments.exponent);
    summary.standardDeviation = heldByDouble(squareRoot(moments.variance), moments.exponent);
  }
  return summary;
}

}  // namespace analysis

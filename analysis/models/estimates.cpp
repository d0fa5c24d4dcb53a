#include "analysis/models/estimates.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/numerics/distributions.h"
#include "analysis/numerics/tail_probabilities.h"

namespace analysis {

WaldEstimate waldEstimate(std::string name, double value, double variance) {
  WaldEstimate estimate{.name = std::move(name), .estimate = value};
  estimate.standardError = std::sqrt(std::max(variance, 0.0));
  estimate.z = estimate.standardError > 0.0 ? value / estimate.standardError : 0.0;
  estimate.p = normalTwoSidedP(estimate.z);
  estimate.log10P = log10NormalTwoSidedP(estimate.z);
  estimate.oddsRatio = std::exp(value);
  return estimate;
}

std::optional<Interval> confidenceInterval(const TEstimate& estimate, double level) {
  return studentInterval(
      estimate.estimate,
      estimate.standardError,
      estimate.p ? estimate.degreesOfFreedom : std::nullopt,
      level);
}

Interval confidenceInterval(const WaldEstimate& estimate, double level) {
  const double reach = normalTwoSidedQuantile(level) * estimate.standardError;
  return {.low = estimate.estimate - reach, .high = estimate.estimate + reach};
}

Interval oddsRatioInterval(const WaldEstimate& estimate, double level) {
  const Interval interval = confidenceInterval(estimate, level);
  return {.low = std::exp(interval.low), .high = std::exp(interval.high)};
}

}  // namespace analysis

#pragma once

#include <optional>
#include <string>

#include "analysis/data/reason.h"
#include "analysis/numerics/interval.h"

namespace analysis {

/// A coefficient or a contrast, tested against zero by t with Satterthwaite's degrees of freedom.
struct TEstimate {
  std::string name;
  double estimate = 0.0;
  double standardError = 0.0;
  std::optional<double> degreesOfFreedom;  ///< rarely a whole number
  std::optional<double> t;                 ///< estimate / standard error
  std::optional<double> p;                 ///< two-sided, not yet adjusted
  std::optional<double> log10P;            ///< defined even if p is too small for a double
  Reason reason;                           ///< why something above is missing
};

/// A coefficient or a contrast on the logit scale, tested against zero by Wald's z.
struct WaldEstimate {
  std::string name;
  double estimate = 0.0;
  double standardError = 0.0;
  double z = 0.0;
  double p = 1.0;          ///< two-sided, not yet adjusted
  double log10P = 0.0;     ///< defined even if p is too small for a double
  double oddsRatio = 1.0;  ///< exp(estimate): ratio of the odds of a higher answer
};

/// z = estimate / √variance, 0 where the variance is 0.
/// @param variance  of the estimate, not negative.
WaldEstimate waldEstimate(std::string name, double estimate, double variance);

/// The confidence interval at @p level, for instance 0.95: estimate ± quantile of t × standard
/// error. std::nullopt if p is not defined, or a limit is beyond a double.
/// @throws std::invalid_argument  for a level that is not between 0 and 1.
std::optional<Interval> confidenceInterval(const TEstimate& estimate, double level);

/// The confidence interval at @p level: estimate ± normal quantile × standard error.
/// @throws std::invalid_argument  for a level that is not between 0 and 1.
Interval confidenceInterval(const WaldEstimate& estimate, double level);
/// The confidence interval of the odds ratio: the exponential of the interval of the estimate.
Interval oddsRatioInterval(const WaldEstimate& estimate, double level);

}  // namespace analysis

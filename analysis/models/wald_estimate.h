#pragma once

#include <string>

#include "analysis/numerics/interval.h"

namespace analysis {

/// A coefficient or contrast on the logit scale, held against zero by Wald's z.
struct WaldEstimate {
  std::string name;
  double estimate = 0.0;
  double standardError = 0.0;
  double z = 0.0;
  double p = 1.0;          ///< two-sided, not yet corrected
  double log10P = 0.0;     ///< holds also where p is too small for a double
  double oddsRatio = 1.0;  ///< exp(estimate): of the odds of a higher answer
};

/// @param variance  of the estimate, not negative.
WaldEstimate waldEstimate(std::string name, double estimate, double variance);

/// Wald's interval of the estimate, with a confidence of @p level, for instance 0.95.
/// @throws std::invalid_argument  for a level that is not between 0 and 1.
Interval confidenceInterval(const WaldEstimate& estimate, double level);
/// The same of the odds ratio.
Interval oddsRatioInterval(const WaldEstimate& estimate, double level);

}  // namespace analysis

#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "analysis/data/reason.h"
#include "analysis/numerics/interval.h"

namespace analysis {

/// One intraclass correlation with its test against 0 and its confidence interval.
struct IntraclassCorrelation {
  std::optional<double> value;       ///< at most 1; below 0 if raters agree less than by chance
  std::optional<Interval> interval;  ///< std::nullopt if F is 0 or not finite
  std::optional<double> f;           ///< +infinity if raters agree completely
  double degreesOfFreedom1 = 0.0;
  double degreesOfFreedom2 = 0.0;
  std::optional<double> p;  ///< of F, one-sided
};

/// The six intraclass correlations of Shrout & Fleiss 1979. "Single" is the reliability of one
/// rating, "average" that of the mean of all k ratings of a subject.
struct IntraclassCorrelations {
  std::size_t subjects = 0;
  std::size_t raters = 0;
  double level = 0.95;  ///< of the intervals

  IntraclassCorrelation oneWaySingle;         ///< ICC(1,1): each subject has raters of its own
  IntraclassCorrelation oneWayAverage;        ///< ICC(1,k)
  IntraclassCorrelation twoWayRandomSingle;   ///< ICC(2,1): raters drawn at random; agreement
  IntraclassCorrelation twoWayRandomAverage;  ///< ICC(2,k)
  IntraclassCorrelation twoWayMixedSingle;    ///< ICC(3,1): these raters only; consistency
  IntraclassCorrelation twoWayMixedAverage;   ///< ICC(3,k); Cronbach's α

  Reason reason;  ///< why something above is missing; empty if nothing is
};

/// With B, J, E the mean squares of n subjects, k raters and residuals, and W that within subjects:
///
///     ICC(1,1) = (B − W) / (B + (k − 1) W)                       ICC(1,k) = (B − W) / B
///     ICC(2,1) = (B − E) / (B + (k − 1) E + k (J − E) / n)
///     ICC(2,k) = (B − E) / (B + (J − E) / n)
///     ICC(3,1) = (B − E) / (B + (k − 1) E)                       ICC(3,k) = (B − E) / B
///
/// The intervals are also those of Shrout & Fleiss. With participants as subjects and their
/// repeated answers as raters, ICC(1,1) is the correlation of answers of one person.
///
/// @param table  one subject a row, one rater a column.
/// @throws std::invalid_argument  if a row has fewer or more values than the first, a value is
///     infinite or NaN, or for a level that is not between 0 and 1.
IntraclassCorrelations intraclassCorrelations(
    std::span<const std::vector<double>> table, double level = 0.95);

}  // namespace analysis

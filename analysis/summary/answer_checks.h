#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "analysis/data/answer_table.h"
#include "analysis/hypothesis_tests/assumptions.h"
#include "analysis/hypothesis_tests/t_tests.h"
#include "analysis/numerics/interval.h"
#include "analysis/reliability/reliability.h"

namespace analysis {

/// The correlation of answers of one person, which pooled tests ignore.
struct AnswerDependence {
  std::size_t answers = 0;
  std::size_t participants = 0;
  /// ICC(1) of answers within participant and method (Shrout & Fleiss 1979, case 1), pooled over
  /// methods, with Searle's n₀ for unequal numbers; may be negative. std::nullopt if there is only
  /// one participant, only one answer each, or no variance.
  std::optional<double> intraclassCorrelation;
  std::optional<double> designEffect;  ///< 1 + (n₀ − 1) ICC (Kish 1965)
};

AnswerDependence dependenceOf(const AnswerTable& table);

/// The mean score of methods at one position of the order.
struct PositionMean {
  int position = 1;
  std::size_t participants = 0;  ///< number who judged a method at this position
  double mean = 0.0;  ///< of their scores, corrected for differences between methods [points]
  std::optional<Interval> interval;
};

/// The effect of the position of a method in the order on its scores.
struct PositionEffect {
  std::vector<PositionMean> positions;  ///< ascending
  PairedTResult slope;  ///< test of participants' slopes against zero [points/position]
  std::optional<Interval> slopeInterval;
};

/// Estimates the effect of the position within a round. Subtracts from every score the mean of its
/// method, averages the residuals by participant and position, and fits a straight line to each
/// participant's averages. If orders are not balanced, the methods' means absorb a part of the
/// effect, and the estimate is too small. If every method came at one position only, slope is
/// undefined, and its reason says so.
///
/// @param level  of the intervals, between 0 and 1.
PositionEffect positionEffect(const AnswerTable& table, double level = 0.95);

/// Distribution and reliability of the scores of one method.
struct MethodChecks {
  std::string method;
  ShapiroWilkResult normality;  ///< of the participants' means
  CronbachAlpha alpha;          ///< of the statements about the method, averaged over rounds
  OmegaTotal omega;             ///< of the statements of alpha
};

/// Checks of assumptions. They are reported; no test is chosen by them.
struct ScaleChecks {
  std::vector<MethodChecks> methods;
  BrownForsytheResult spread;  ///< of participants' means, between methods
};

/// Distribution and reliability of one cohort's answers. The reliability of a method uses only
/// participants who answered all statements about it.
ScaleChecks scaleChecks(const AnswerTable& table);

}  // namespace analysis

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

/// How far answers of one person go together: what pooling them as if they were independent
/// ignores.
struct AnswerDependence {
  std::size_t answers = 0;
  std::size_t participants = 0;
  /// ICC(1) of answers within participant and method (Shrout & Fleiss 1979, case 1), pooled over
  /// methods, with Searle's n₀ for unequal numbers; may be negative. std::nullopt if there is one
  /// participant, one answer each, or no scatter.
  std::optional<double> intraclassCorrelation;
  std::optional<double> designEffect;  ///< 1 + (n₀ − 1) ICC (Kish 1965)
};

AnswerDependence dependenceOf(const AnswerTable& table);

/// How methods were judged that came at one place of the order.
struct PositionMean {
  int position = 1;
  std::size_t participants = 0;  ///< who judged a method there
  double mean = 0.0;             ///< of their scores, as if all methods were alike [points]
  std::optional<Interval> interval;
};

/// Whether methods are judged otherwise for coming early or late.
struct PositionEffect {
  std::vector<PositionMean> positions;  ///< ascending
  PairedTResult slope;                  ///< of participants' slopes against none [points/position]
  std::optional<Interval> slopeInterval;
};

/// The effect of the position within a round. From every score the mean of its method is taken, so
/// that methods do not pose as positions; what is left is averaged by participant and position, and
/// a straight line is laid through each participant's averages. Where orders are not balanced, part
/// of an effect of the position is in the methods' means, and what is found here is too small;
/// where every method came at one position only, nothing is found, and the slope's reason says so.
///
/// @param level  of the intervals, between 0 and 1.
PositionEffect positionEffect(const AnswerTable& table, double level = 0.95);

/// What a reader may ask about the scores of one method before believing their mean.
struct MethodChecks {
  std::string method;
  ShapiroWilkResult normality;  ///< of the participants' means
  CronbachAlpha alpha;          ///< of the statements about it, averaged over rounds
  OmegaTotal omega;             ///< of the same
};

/// Information, never a switch between tests.
struct ScaleChecks {
  std::vector<MethodChecks> methods;
  BrownForsytheResult spread;  ///< of participants' means, between methods
};

/// Distribution and reliability of one cohort's answers. A participant who left out a statement
/// about a method does not count for that method's reliability.
ScaleChecks scaleChecks(const AnswerTable& table);

}  // namespace analysis

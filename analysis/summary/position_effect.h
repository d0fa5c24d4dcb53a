#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "analysis/data/answer_table.h"
#include "analysis/numerics/interval.h"
#include "analysis/tests/paired_t.h"

namespace analysis {

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

}  // namespace analysis

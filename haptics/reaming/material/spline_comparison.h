#pragma once

#include <cstddef>
#include <vector>

#include "haptics/reaming/material/node_choice.h"
#include "haptics/reaming/material/piecewise.h"

namespace haptics::reaming {

/// One of the splines of a comparison.
struct ComparedSpline {
  SplineKind kind = SplineKind::NaturalCubic;
  Spline spline;
  ApproximationError error;
  /// |e_a| where the first spline of the comparison is worst, as published and with the floor: the
  /// paper's "at the same reamer displacement".
  double publishedThere = 0.0;
  double flooredThere = 0.0;
};

/// Splines through the same nodes of a curve.
struct SplineComparison {
  std::vector<std::size_t> nodes;  ///< indices into the curve
  std::vector<ComparedSpline> splines;
};

/// Fig. 7 of the reaming paper for any curve: the natural cubic and the cubic Hermite spline
/// through the same nodes.
///
/// @param nodes  indices into the curve, rising, two or more. @param floor  ApproximationError.
SplineComparison compareSplines(
    const SampledCurve& curve, std::vector<std::size_t> nodes, double floor);

}  // namespace haptics::reaming

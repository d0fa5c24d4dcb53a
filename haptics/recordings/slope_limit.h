#pragma once

#include "haptics/recordings/force_curve.h"

namespace haptics::recordings {

/// A curve that nowhere rises or falls faster than allowed, and what that changed.
struct SlopeLimited {
  ForceCurve curve;
  double largestChange = 0.0;    ///< of a node's force [N]
  double largestChangeAt = 0.0;  ///< its travel [travel units]
};

/// Limits the slope of a curve to K, changing it as little as it can on both sides.
///
/// Between the largest curve of slope K that lies nowhere above f and the smallest that lies
/// nowhere below it (the envelopes of McShane and Whitney) it takes the middle:
///
///     g(x) = ½ [ min_y (f(y) + K |x − y|) + max_y (f(y) − K |x − y|) ]
///
/// No node-to-node slope of g is larger than K (to rounding), no such curve has a smaller largest
/// change, and a curve that was gentle enough stays what it is. Two passes per envelope, O(n).
///
/// @param maxSlope  K [N/travel unit].
/// @throws std::invalid_argument  if K is not positive and finite.
SlopeLimited limitSlope(const ForceCurve& curve, double maxSlope);

}  // namespace haptics::recordings

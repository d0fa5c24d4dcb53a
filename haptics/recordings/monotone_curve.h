#pragma once

#include <cstddef>
#include <span>

#include "haptics/recordings/force_curve.h"

namespace haptics::recordings {

/// A curve made of samples whose travel did not only rise.
struct MonotoneCurve {
  ForceCurve curve;
  std::size_t samples = 0;  ///< that went in
  std::size_t merged = 0;   ///< fewer nodes than samples: all that a mean took the place of
};

/// Makes the travel of a closing hand rise strictly, and leaves alone what already does.
///
/// Wherever the travel falls or stays, neighbouring samples are merged into their mean – of
/// travel and of force – and go on being merged with what lies before them until the means rise:
/// pooling adjacent violators, which yields that rising sequence which is nearest to the travel in
/// least squares. No sample is thrown away; a hand that trembles about one place becomes one node
/// there. Travels nearer than 1e-6 units count as the same. O(n).
///
/// @param samples  in the order of time.
/// @throws std::invalid_argument  if fewer than two nodes remain, or a number is not finite.
MonotoneCurve monotoneCurve(std::span<const CurvePoint> samples);

}  // namespace haptics::recordings

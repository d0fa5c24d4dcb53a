#pragma once

#include "haptics/recordings/cut.h"
#include "haptics/recordings/force_curve.h"

namespace haptics::recordings {

/// What a cut of our own making is built from. The defaults are the landmarks of the reference
/// cut, rounded, with a bottom-out half a newton lower so that the cutting through can be felt: the
/// recorded force falls by 0.69 N, hardly more than its sensor errs (0.56 N).
struct CutShape {
  double start = 2.0;  ///< no force from here to the interception [travel units]
  CurvePoint interception{3.8, 0.0};
  CurvePoint yield{7.2, 4.4};
  CurvePoint through{8.4, 3.5};  ///< the fall after the yield is over
  CurvePoint bottomOut{10.3, 3.2};
  CurvePoint end{11.0, 5.0};
  double spacing = 0.1;       ///< between nodes, at most [travel units]
  double openingShare = 0.2;  ///< of the closing force that is left while opening, 0 to 1
  double maxSlope = 4.39;     ///< as in ImportOptions [N/travel unit]
};

/// A cut that nobody recorded: smooth pieces between landmarks, monotone in each.
///
/// Each piece is a cubic Hermite polynomial over s = (x − x₀)/h with h = x₁ − x₀, Δ = (f₁ − f₀)/h,
///
///     f = f₀ + h [ m₀ s(1 − s)² + Δ s²(3 − 2s) − m₁ s²(1 − s) ],   0 ≤ m/Δ ≤ 3 at both ends,
///
/// the bound of Fritsch and Carlson that keeps it monotone. The slope is zero at the interception
/// (the load rises slowly at first, then stiffens), at the yield and at the bottom-out; the Δ of
/// the slow fall where the fast one passes into it; and 1.5 Δ at the end, which is as steep as the
/// last piece gets. Then the slope is limited as everywhere.
///
/// Opening meets the same curve at a share of its force: what is cut does not push back as it did.
///
/// @throws std::invalid_argument  if the travels do not rise from landmark to landmark, the forces
///     do not rise, fall, fall more slowly and rise, a number is not finite or a force negative,
///     or the spacing is not between a ten-thousandth and a tenth of the whole.
Cut parametricCut(const CutShape& shape = {});

}  // namespace haptics::recordings

#pragma once

#include <optional>
#include <vector>

#include "haptics/recordings/force_calibration.h"
#include "haptics/recordings/monotone_curve.h"
#include "haptics/recordings/recording.h"
#include "haptics/recordings/row_range.h"
#include "haptics/recordings/travel_filter.h"

namespace haptics::recordings {

/// A recording as force over travel: calibrated and filtered, row for row.
struct Trace {
  std::vector<double> travel;  ///< filtered [travel units]
  std::vector<double> force;   ///< from the reading [N]
};

/// The filter runs over the whole recording, as the authors' did, and not over one cut.
Trace traceOf(const Recording& recording, ForceCalibration calibration, TravelFilter filter);

/// Some rows of a trace as a curve; see monotoneCurve().
///
/// @param rows  within the trace.
/// @throws Error  if they give fewer than two different travels.
MonotoneCurve curveOf(const Trace& trace, const RowRange& rows);

/// The same of an opening hand, whose travel falls: read backwards. Nothing where it does not fall.
std::optional<MonotoneCurve> openingCurveOf(const Trace& trace, const RowRange& rows);

}  // namespace haptics::recordings

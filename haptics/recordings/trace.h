#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "haptics/recordings/force_calibration.h"
#include "haptics/recordings/force_curve.h"
#include "haptics/recordings/recording.h"
#include "haptics/recordings/travel_filter.h"

namespace haptics::recordings {

/// Travel and force of a recording, calibrated and filtered; one value per row.
struct Trace {
  std::vector<double> travel;  ///< filtered [travel units]
  std::vector<double> force;   ///< from the readings [N]
  ForceCalibration calibration{};
};

/// The calibration of a recording, unless the user chooses another.
///
/// @throws UserError  if the recording has no calibration.
ForceCalibration calibrationFor(const Recording& recording);

/// Calibrates and filters a recording. The filter runs over the whole recording, as the authors'
/// did, not over one cut; it is designed for the rate of samplingOf().
///
/// @throws UserError  if the calibration's unit differs from that of the readings, or as
///     filtered().
Trace traceOf(
    const Recording& recording, const ForceCalibration& calibration, const TravelFilter& filter);

/// Some rows of a trace as a curve; see monotoneCurve().
///
/// @param rows  within the trace.
/// @throws UserError  if the travel of the rows does not rise.
MonotoneCurve curveOf(const Trace& trace, const RowRange& rows);

/// Rows of an opening hand, whose travel decreases, as a curve: read backwards. std::nullopt if the
/// travel does not decrease.
std::optional<MonotoneCurve> openingCurveOf(const Trace& trace, const RowRange& rows);

/// Variances of force and stiffness over recorded cuts: Q of eq. (22) of the punch paper, for other
/// recordings. Variances are divided by n − 1.
struct ProcessNoise {
  double force = 0.0;       ///< σ²_f [N²]
  double covariance = 0.0;  ///< of force and stiffness [N²/travel unit]
  double stiffness = 0.0;   ///< σ²_ζ [N²/travel unit²]
  std::size_t samples = 0;  ///< number of rows used
  std::size_t resting = 0;  ///< number of rows left out, because the travel hardly changed
};

/// Least change of travel for a difference quotient, since smaller ones give only noise: a tenth of
/// a count of the potentiometer [travel units]. The published numbers include all rows; with this
/// limit the ten cuts give 5.94, 0.002 and 2.62 with `authors-fir-333`, and 5.92, 0.015 and 2.65
/// with `authors-fir`.
inline constexpr double kLeastStep = 0.0256;

/// The process noise of the recorded cuts in @p rows. The rows of all ranges are put in one list;
/// the stiffness of a row is the difference quotient to the row before it, 0 for the first. A least
/// step of 0 reproduces the published numbers (6.1024, 0.2772 and 7.0275 from ten ranges of one
/// recording).
///
/// @param rows       one or more ranges within the trace.
/// @param leastStep  rows whose travel changes by less, or not at all, are left out [travel units].
/// @throws UserError  if fewer than three rows remain.
ProcessNoise processNoiseOf(
    const Trace& trace, std::span<const RowRange> rows, double leastStep = kLeastStep);

}  // namespace haptics::recordings

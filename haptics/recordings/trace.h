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

/// A recording as force over travel: calibrated and filtered, row for row.
struct Trace {
  std::vector<double> travel;  ///< filtered [travel units]
  std::vector<double> force;   ///< from the reading [N]
  ForceCalibration calibration{};
};

/// What a recording's readings become newtons with, unless another calibration is chosen.
///
/// @throws UserError  if it does not say.
ForceCalibration calibrationFor(const Recording& recording);

/// The filter runs over the whole recording, as the authors' did, and not over one cut; it is
/// designed for samplingOf() the recording.
///
/// @throws UserError  if the calibration is for another unit than the recording's readings have, or
///     filtered() cannot be done.
Trace traceOf(
    const Recording& recording, const ForceCalibration& calibration, const TravelFilter& filter);

/// Some rows of a trace as a curve; see monotoneCurve().
///
/// @param rows  within the trace.
/// @throws UserError  if they give fewer than two different travels.
MonotoneCurve curveOf(const Trace& trace, const RowRange& rows);

/// The same of an opening hand, whose travel falls: read backwards. Nothing where it does not fall.
std::optional<MonotoneCurve> openingCurveOf(const Trace& trace, const RowRange& rows);

/// How force and stiffness vary over recorded cuts: Q of eq. (22) of the punch paper, for cuts of
/// one's own. Variances with n − 1.
struct ProcessNoise {
  double force = 0.0;       ///< σ²_f [N²]
  double covariance = 0.0;  ///< of force and stiffness [N²/travel unit]
  double stiffness = 0.0;   ///< σ²_ζ [N²/travel unit²]
  std::size_t samples = 0;  ///< that went in
  std::size_t resting = 0;  ///< left out: the travel hardly changed, and there is no quotient
};

/// A tenth of a count of the potentiometer [travel units]: with smaller steps a difference quotient
/// is only noise. The published numbers include all rows: with this step the ten cuts give 5.94,
/// 0.002 and 2.62 under `authors-fir-333`, and 5.92, 0.015 and 2.65 under `authors-fir`.
inline constexpr double kLeastStep = 0.0256;

/// Puts the rows of all ranges one after another; the stiffness of a row is the difference quotient
/// from the row before it in that list, and 0 for the first. With a least step of 0 that reproduces
/// the published numbers (6.1024, 0.2772 and 7.0275 from ten ranges of one recording).
///
/// @param rows       within the trace, one range or more.
/// @param leastStep  a row that has moved on by less than this, or not at all, is left out [travel
///                   units].
/// @throws UserError  if fewer than three rows remain.
ProcessNoise processNoiseOf(
    const Trace& trace, std::span<const RowRange> rows, double leastStep = kLeastStep);

}  // namespace haptics::recordings

#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace haptics::reaming {

/// Force (or torque) over displacement.
struct SampledCurve {
  std::vector<double> x;  ///< strictly increasing
  std::vector<double> y;

  std::size_t size() const noexcept { return x.size(); }
};

/// @p values over the displacement from the beginning of the series [m]. Samples at which the
/// reamer has not advanced are averaged, so that displacements are strictly increasing.
SampledCurve curveOver(std::span<const double> displacement, std::span<const double> values);

/// @p curve resampled at @p count evenly spaced x from 0 to its largest x, with all x divided by
/// that largest x: the paper's normalisation. Each point is the mean of the samples that are
/// nearest to it, or is interpolated linearly if there are none; the ends are those of the curve.
SampledCurve normalised(const SampledCurve& curve, std::size_t count);

/// @p curve at those of @p count evenly spaced x from 0 to @p largestX that it reaches. Each point
/// is computed as in normalised(); the first is that of the curve.
///
/// @param largestX  at least the largest x of the curve.
SampledCurve resampled(const SampledCurve& curve, double largestX, std::size_t count);

/// The mean of the samples in the last @p width of x.
double endValueOf(const SampledCurve& curve, double width);

}  // namespace haptics::reaming

#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace haptics::reaming {

/// Force (or torque) over displacement, at rising displacements.
struct SampledCurve {
  std::vector<double> x;  ///< rising strictly
  std::vector<double> y;

  std::size_t size() const noexcept { return x.size(); }
};

/// A series' force, or its torque, over its displacement from the beginning [m], each displacement
/// once: of samples at which the reamer has not gone on the mean.
SampledCurve curveOver(std::span<const double> displacement, std::span<const double> values);

/// @p curve resampled at @p count evenly spaced x from 0 to its largest, which becomes 1: the
/// paper's normalisation. Each point is the mean of the samples that are nearest to it, or is
/// interpolated linearly if there are none; the ends are those of the curve.
SampledCurve normalised(const SampledCurve& curve, std::size_t count);

/// @p curve at those of @p count places, even from 0 to @p whole, that it reaches: each as
/// normalised() has it, the first is that of the curve.
///
/// @param whole  at least the largest x of the curve.
SampledCurve resampled(const SampledCurve& curve, double whole, std::size_t count);

/// The mean of the last samples of @p curve, over @p width of x.
double endOf(const SampledCurve& curve, double width);

}  // namespace haptics::reaming

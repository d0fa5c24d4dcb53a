#pragma once

#include <span>
#include <vector>

#include "haptics/reaming/material/series.h"

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

/// @p curve at @p count places, even from 0 to its largest x, as shares of it: the paper's
/// normalisation. Each place has the mean of the samples that are nearest to it, or lies straight
/// between two where there are none; the ends are those of the curve.
SampledCurve normalised(const SampledCurve& curve, std::size_t count);

/// The largest, the mean and the smallest of several curves on the same places.
struct Envelope {
  SampledCurve minimum;
  SampledCurve average;
  SampledCurve maximum;
};

/// How an envelope is made of samples.
enum class EnvelopeRule {
  Pointwise,     ///< at each place of all samples, as in the paper: no specimen has such a curve
  SingleSample,  ///< the softest, the middle and the hardest sample, by their mean force
};

/// @param curves  one or more, on the same places.
Envelope envelopeOf(std::span<const SampledCurve> curves, EnvelopeRule rule);

}  // namespace haptics::reaming

#pragma once

#include <span>
#include <vector>

namespace haptics::filters {

/// How a series' cut-off is found in its spectrum.
enum class CutoffRule {
  Floor,  ///< end-to-end detrended, Hann window: where the spectrum reaches the noise floor
  Plain,  ///< the same on the spectrum as it is; the ramp leaks, and the cut-off is far too high
};

/// A spectrum, one-sided.
struct Spectrum {
  double step = 0.0;              ///< between two frequencies [Hz]
  std::vector<double> amplitude;  ///< of each, from 0 on [unit of the samples]
};

/// Amplitudes of @p samples at @p rate [Hz]; for Floor detrended and windowed. Padded with zeros to
/// a length of factors 2, 3 and 5: a prime one would take minutes.
Spectrum spectrumOf(std::span<const double> samples, double rate, CutoffRule rule);

/// Where a low-pass cuts off [Hz]: the first frequency from below at which the spectrum, averaged
/// over its neighbours, has come down to twice the noise floor, the median of its upper half. Never
/// below four periods of the whole series, never above 0.45 of the rate.
double cutoffOf(std::span<const double> samples, double rate, CutoffRule rule);

}  // namespace haptics::filters

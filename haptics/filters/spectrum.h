#pragma once

#include <span>
#include <vector>

namespace haptics::filters {

/// How the cut-off frequency of a series is determined from its spectrum.
enum class CutoffRule {
  Floor,  ///< where the spectrum reaches the noise floor, after end-to-end detrending and a Hann
          ///< window
  Plain,  ///< as Floor, but without detrending and window; the ramp leaks into the spectrum, and
          ///< the cut-off is far too high
};

/// A one-sided amplitude spectrum.
struct Spectrum {
  double step = 0.0;              ///< distance of two frequencies [Hz]
  std::vector<double> amplitude;  ///< at frequencies 0, step, 2 step, … [unit of the samples]
};

/// Spectrum of @p samples, sampled at @p rate [Hz]; for Floor they are detrended and windowed
/// first. Zero-padded to a length with the factors 2, 3 and 5 only, since a prime length would take
/// minutes.
Spectrum spectrumOf(std::span<const double> samples, double rate, CutoffRule rule);

/// A cut-off frequency for a low-pass [Hz]: the lowest frequency at which the spectrum, averaged
/// over neighbours, has fallen to twice the noise floor (the median of the upper half of the
/// spectrum). At least four periods per length of the series, and at most 0.45 of the rate.
double cutoffOf(std::span<const double> samples, double rate, CutoffRule rule);

}  // namespace haptics::filters

#pragma once

#include <span>
#include <vector>

namespace haptics::filters {

/// A zero-phase low-pass: a symmetric FIR filter, centred on each sample.
///
/// The n = 2m + 1 taps are an ideal low-pass under a Kaiser window, scaled to a gain of one at 0
/// Hz:
///
///     h(j) ∝ sin(2π f j / Fs) / (π j) · I₀(β √(1 − (j/m)²)) / I₀(β),   j = −m … m,   Σ h = 1
///
///     y(i) = Σ h(j) x(i + j)
///
/// At the cut-off f the gain is one half (−6 dB). Beyond its ends the signal is continued with its
/// first and last value. So the ends are not pulled towards zero, and a constant passes unchanged.
class KaiserLowPass {
 public:
  struct Design {
    int taps = 49;        ///< odd
    double beta = 5.653;  ///< shape of the window; 5.653 gives a stop-band attenuation of 60 dB
    double cutoff = 17.69075;          ///< f, where the gain is −6 dB [Hz]
    double sampleRate = 1000.0 / 3.0;  ///< Fs [Hz]
  };

  /// @throws std::invalid_argument  if taps is even, less than 3 or more than 9,999, beta negative
  ///     or more than 100, or the cut-off not between 0 and half the sample rate.
  explicit KaiserLowPass(const Design& design);

  std::span<const double> taps() const noexcept { return taps_; }

  /// Returns the filtered signal, of the same length as @p signal.
  std::vector<double> filtered(std::span<const double> signal) const;

 private:
  std::vector<double> taps_;
};

/// Zero-phase low-pass: a Butterworth filter of order 4, run forwards and backwards, with the gain
/// 1/(1 + (f/fc)⁸) (after the bilinear transform). To avoid ringing at the ends, the signal is
/// continued by point reflection at its end points; these come from least-squares lines through an
/// eighth of a period.
///
/// @param cutoff  frequency at which the amplitude is halved [Hz], above 0 and below half of @p
///                rate [Hz].
/// @throws std::invalid_argument  if @p cutoff is out of range.
std::vector<double> zeroPhaseLowPass(std::span<const double> samples, double rate, double cutoff);

}  // namespace haptics::filters

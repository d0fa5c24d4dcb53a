#pragma once

#include <span>
#include <vector>

namespace haptics::filters {

/// A zero-phase low-pass: a symmetric FIR filter, centred on each sample.
///
/// The n = 2m + 1 taps are an ideal low-pass under a Kaiser window, scaled to a gain of one at
/// rest:
///
///     h(j) ∝ sin(2π f j / Fs) / (π j) · I₀(β √(1 − (j/m)²)) / I₀(β),   j = −m … m,   Σ h = 1
///
///     y(i) = Σ h(j) x(i + j)
///
/// At the cut-off f the gain is one half (−6 dB). Before the first sample and after the last one
/// the signal is taken to go on as it began or ended; so a signal that rests at its ends is not
/// pulled to zero there, and any constant stays what it is.
class KaiserLowPass {
 public:
  struct Design {
    int taps = 49;                     ///< odd
    double beta = 5.653;               ///< shape of the window; 5.653 is a stop-band of 60 dB
    double cutoff = 17.69075;          ///< f, where the gain is −6 dB [Hz]
    double sampleRate = 1000.0 / 3.0;  ///< Fs [Hz]
  };

  /// @throws std::invalid_argument  if taps is even, less than 3 or more than 9,999, beta negative
  ///     or more than 100, or the cut-off not between 0 and half the sample rate.
  explicit KaiserLowPass(const Design& design);

  std::span<const double> taps() const noexcept { return taps_; }

  /// As many samples as went in.
  std::vector<double> filtered(std::span<const double> signal) const;

 private:
  std::vector<double> taps_;
};

/// Zero-phase low-pass: a Butterworth filter of order 4 forwards and backwards, so that a frequency
/// f is weighed by 1/(1 + (f/fc)⁸) (after the bilinear transform), and no edge rings: the ends are
/// continued by their own mirror images through the end points, where straight lines through an
/// eighth of a period put them.
///
/// @param cutoff  where the amplitude is halved [Hz], above 0 and below half of @p rate.
/// @throws std::invalid_argument  if it is not.
std::vector<double> zeroPhaseLowPass(std::span<const double> samples, double rate, double cutoff);

}  // namespace haptics::filters

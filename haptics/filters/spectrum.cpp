#include "haptics/filters/spectrum.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>

#include "haptics/filters/averages.h"

namespace haptics::filters {
namespace {

/// The smallest number >= @p n whose prime factors are all 2, 3 or 5.
std::size_t smoothLength(std::size_t n) {
  std::size_t best = 1;
  while (best < n) best *= 2;
  for (std::size_t fives = 1; fives < 2 * n; fives *= 5) {
    for (std::size_t threes = fives; threes < 2 * n; threes *= 3) {
      std::size_t length = threes;
      while (length < n) length *= 2;
      best = std::min(best, length);
    }
  }
  return best;
}

std::vector<double> preparedSamples(std::span<const double> samples, CutoffRule rule) {
  std::vector<double> result(samples.begin(), samples.end());
  if (rule == CutoffRule::Plain || samples.size() < 3) return result;
  const auto last = static_cast<double>(samples.size() - 1);
  // Subtract the line from the first sample to the last, since the jump between the ends would
  // leak.
  const double rise = (samples.back() - samples.front()) / last;
  for (std::size_t i = 0; i < result.size(); ++i) {
    const auto at = static_cast<double>(i);
    const double window = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * at / last);
    result[i] = (samples[i] - (samples.front() + rise * at)) * window;
  }
  return result;
}

}  // namespace

Spectrum spectrumOf(std::span<const double> samples, double rate, CutoffRule rule) {
  auto signal = preparedSamples(samples, rule);
  const auto count = static_cast<double>(signal.size());
  signal.resize(smoothLength(signal.size()), 0.0);
  Eigen::FFT<double> fft;
  fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  std::vector<std::complex<double>> transformed;
  fft.fwd(transformed, signal);
  // The window halves amplitudes.
  const double gain = (rule == CutoffRule::Plain ? 2.0 : 4.0) / count;
  Spectrum spectrum{.step = rate / static_cast<double>(signal.size())};
  for (const auto& value : transformed) spectrum.amplitude.push_back(gain * std::abs(value));
  return spectrum;
}

double cutoffOf(std::span<const double> samples, double rate, CutoffRule rule) {
  const Spectrum spectrum = spectrumOf(samples, rate, rule);
  const auto& amplitude = spectrum.amplitude;
  const double floor = upperMedian(
      {amplitude.begin() + static_cast<std::ptrdiff_t>(amplitude.size() / 2), amplitude.end()});

  constexpr std::size_t kNeighbours = 3;
  constexpr double kAboveFloor = 2.0;
  const double least = 4.0 * rate / static_cast<double>(samples.size());
  const double most = 0.45 * rate;
  for (std::size_t bin = 1; bin + kNeighbours < amplitude.size(); ++bin) {
    double sum = 0.0;
    for (std::size_t k = 0; k < kNeighbours; ++k) sum += amplitude[bin + k];
    if (sum / kNeighbours <= kAboveFloor * floor) {
      const double found = spectrum.step * static_cast<double>(bin);
      return std::clamp(found, std::min(least, most), most);
    }
  }
  return most;
}

}  // namespace haptics::filters

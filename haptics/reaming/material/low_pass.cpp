#include "haptics/reaming/material/low_pass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>
#include <unsupported/Eigen/FFT>

namespace haptics::reaming {
namespace {

/// The least length of factors 2, 3 and 5 that is not below @p n.
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

/// From the first sample straight to the last.
class Line {
 public:
  explicit Line(std::span<const double> samples)
      : start_(samples.front()),
        rise_((samples.back() - samples.front()) / static_cast<double>(samples.size() - 1)) {}
  /// Between where the first and the last @p window samples begin and end by their least-squares
  /// lines: the noise of two samples moves no end.
  Line(std::span<const double> samples, std::size_t window)
      : start_(fittedEnd(samples.first(window), true)),
        rise_(
            (fittedEnd(samples.last(window), false) - start_) /
            static_cast<double>(samples.size() - 1)) {}
  double at(std::size_t i) const { return start_ + rise_ * static_cast<double>(i); }

 private:
  static double fittedEnd(std::span<const double> part, bool isFirst) {
    const double middle = 0.5 * static_cast<double>(part.size() - 1);
    double mean = 0.0;
    double moment = 0.0;
    double spread = 0.0;
    for (std::size_t i = 0; i < part.size(); ++i) {
      const double off = static_cast<double>(i) - middle;
      mean += part[i] / static_cast<double>(part.size());
      moment += off * part[i];
      spread += off * off;
    }
    const double slope = spread > 0.0 ? moment / spread : 0.0;
    return mean + (isFirst ? -middle : middle) * slope;
  }

  double start_;
  double rise_;
};

std::vector<double> prepared(std::span<const double> samples, CutoffRule rule) {
  std::vector<double> result(samples.begin(), samples.end());
  if (rule == CutoffRule::Plain || samples.size() < 3) return result;
  const auto last = static_cast<double>(samples.size() - 1);
  const Line line(samples);
  for (std::size_t i = 0; i < result.size(); ++i) {
    const auto at = static_cast<double>(i);
    const double window = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * at / last);
    result[i] = (samples[i] - line.at(i)) * window;
  }
  return result;
}

/// Two poles and two zeros, transposed direct form II.
struct Section {
  double b0 = 0.0, b1 = 0.0, b2 = 0.0, a1 = 0.0, a2 = 0.0;

  /// Of a Butterworth filter with quality q, by the bilinear transform: K = tan(π fc / rate).
  static Section lowPass(double k, double q) {
    const double norm = 1.0 / (1.0 + k / q + k * k);
    return {
        k * k * norm,
        2.0 * k * k * norm,
        k * k * norm,
        2.0 * (k * k - 1.0) * norm,
        (1.0 - k / q + k * k) * norm};
  }

  /// Filters @p samples as if the first value had been constant before.
  void run(std::vector<double>& samples) const {
    double z1 = samples.front() * (1.0 - b0);
    double z2 = samples.front() * (b2 - a2);
    for (double& sample : samples) {
      const double in = sample;
      const double out = b0 * in + z1;
      z1 = b1 * in - a1 * out + z2;
      z2 = b2 * in - a2 * out;
      sample = out;
    }
  }
};

/// Order 4: poles at 22.5 and 67.5 degrees.
std::array<Section, 2> butterworth(double rate, double cutoff) {
  const double k = std::tan(std::numbers::pi * cutoff / rate);
  return {
      Section::lowPass(k, 1.0 / (2.0 * std::cos(std::numbers::pi / 8.0))),
      Section::lowPass(k, 1.0 / (2.0 * std::cos(3.0 * std::numbers::pi / 8.0)))};
}

}  // namespace

Spectrum spectrumOf(std::span<const double> samples, double rate, CutoffRule rule) {
  auto signal = prepared(samples, rule);
  const auto count = static_cast<double>(signal.size());
  signal.resize(smoothLength(signal.size()), 0.0);
  Eigen::FFT<double> fft;
  fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  std::vector<std::complex<double>> transformed;
  fft.fwd(transformed, signal);
  const double gain = (rule == CutoffRule::Plain ? 2.0 : 4.0) / count;  // the window halves
  Spectrum spectrum{.step = rate / static_cast<double>(signal.size())};
  for (const auto& value : transformed) spectrum.amplitude.push_back(gain * std::abs(value));
  return spectrum;
}

double cutoffOf(std::span<const double> samples, double rate, CutoffRule rule) {
  const Spectrum spectrum = spectrumOf(samples, rate, rule);
  const auto& amplitude = spectrum.amplitude;
  auto upper = std::vector<double>(
      amplitude.begin() + static_cast<std::ptrdiff_t>(amplitude.size() / 2), amplitude.end());
  const auto middle = upper.begin() + static_cast<std::ptrdiff_t>(upper.size() / 2);
  std::nth_element(upper.begin(), middle, upper.end());
  const double floor = *middle;

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

std::vector<double> zeroPhaseLowPass(std::span<const double> samples, double rate, double cutoff) {
  if (!(cutoff > 0.0 && cutoff < 0.5 * rate)) {
    throw std::invalid_argument("a cut-off lies above 0 and below half of the sampling rate");
  }
  if (samples.size() < 2) return {samples.begin(), samples.end()};
  // A straight line passes any such filter as it is: it is taken away, and put back afterwards.
  const auto eighth = static_cast<std::size_t>(rate / (8.0 * cutoff));  // of a period
  const Line line(samples, std::clamp<std::size_t>(eighth, 1, samples.size() / 2));
  // Two periods of the cut-off settle the filter; no longer than there is something to mirror.
  const std::size_t most = samples.size() - 1;
  const auto wanted = static_cast<std::size_t>(std::ceil(2.0 * rate / cutoff));
  const std::size_t pad = std::min(wanted, most);
  std::vector<double> extended;
  extended.reserve(samples.size() + 2 * pad);
  for (std::size_t i = pad; i > 0; --i) extended.push_back(line.at(i) - samples[i]);
  for (std::size_t i = 0; i < samples.size(); ++i) extended.push_back(samples[i] - line.at(i));
  for (std::size_t i = most; i > most - pad; --i) {
    extended.push_back(line.at(i - 1) - samples[i - 1]);
  }
  const auto sections = butterworth(rate, cutoff);
  for (int direction = 0; direction < 2; ++direction) {
    for (const auto& section : sections) section.run(extended);
    std::reverse(extended.begin(), extended.end());
  }
  std::vector<double> result;
  result.reserve(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    result.push_back(extended[pad + i] + line.at(i));
  }
  return result;
}

}  // namespace haptics::reaming

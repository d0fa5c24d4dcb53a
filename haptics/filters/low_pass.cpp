#include "haptics/filters/low_pass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

namespace haptics::filters {
namespace {

void requireValid(const KaiserLowPass::Design& design) {
  if (design.taps % 2 == 0 || design.taps < 3 || design.taps > 9999) {
    throw std::invalid_argument("a zero-phase filter has an odd number of taps, 3 to 9999");
  }
  if (!(design.beta >= 0.0 && design.beta <= 100.0)) {
    throw std::invalid_argument("the beta of a Kaiser window is 0 to 100");
  }
  const double nyquist = design.sampleRate / 2.0;
  if (!std::isfinite(nyquist) || !(design.cutoff > 0.0 && design.cutoff < nyquist)) {
    throw std::invalid_argument("a cut-off lies between 0 and half the sample rate");
  }
}

double tap(const KaiserLowPass::Design& design, int j) {
  const double cycles = 2.0 * design.cutoff / design.sampleRate;
  const double x = std::numbers::pi * j;
  const double ideal = j == 0 ? cycles : std::sin(cycles * x) / x;
  const double fraction = 2.0 * j / (design.taps - 1);
  const double inside = std::max(0.0, 1.0 - fraction * fraction);
  return ideal * std::cyl_bessel_i(0.0, design.beta * std::sqrt(inside));
}

}  // namespace

KaiserLowPass::KaiserLowPass(const Design& design) {
  requireValid(design);
  const int reach = design.taps / 2;
  for (int j = -reach; j <= reach; ++j) taps_.push_back(tap(design, j));
  const double gain = std::accumulate(taps_.begin(), taps_.end(), 0.0);
  for (double& value : taps_) value /= gain;
}

std::vector<double> KaiserLowPass::filtered(std::span<const double> signal) const {
  std::vector<double> result;
  if (signal.empty()) return result;
  const std::size_t reach = taps_.size() / 2;
  std::vector<double> held(reach, signal.front());
  held.insert(held.end(), signal.begin(), signal.end());
  held.insert(held.end(), reach, signal.back());
  result.reserve(signal.size());
  for (auto at = held.begin(); result.size() < signal.size(); ++at) {
    result.push_back(std::inner_product(taps_.begin(), taps_.end(), at, 0.0));
  }
  return result;
}

namespace {

/// The line between two end points. Each end point lies on a least-squares line through the first
/// or the last @p window samples, so that the noise of single samples hardly moves it.
class Line {
 public:
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

/// A second-order section (biquad) in transposed direct form II.
struct Section {
  double b0 = 0.0, b1 = 0.0, b2 = 0.0, a1 = 0.0, a2 = 0.0;

  /// A section of a Butterworth filter with quality @p q, by the bilinear transform; @p k = tan(π
  /// fc / rate).
  static Section lowPass(double k, double q) {
    const double norm = 1.0 / (1.0 + k / q + k * k);
    return {
        k * k * norm,
        2.0 * k * k * norm,
        k * k * norm,
        2.0 * (k * k - 1.0) * norm,
        (1.0 - k / q + k * k) * norm};
  }

  /// Filters @p samples in place, as if the first value had been constant before.
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

/// A Butterworth filter of order 4: poles at 22.5 and 67.5 degrees.
std::array<Section, 2> butterworth(double rate, double cutoff) {
  const double k = std::tan(std::numbers::pi * cutoff / rate);
  return {
      Section::lowPass(k, 1.0 / (2.0 * std::cos(std::numbers::pi / 8.0))),
      Section::lowPass(k, 1.0 / (2.0 * std::cos(3.0 * std::numbers::pi / 8.0)))};
}

}  // namespace

std::vector<double> zeroPhaseLowPass(std::span<const double> samples, double rate, double cutoff) {
  if (!(cutoff > 0.0 && cutoff < 0.5 * rate)) {
    throw std::invalid_argument("a cut-off lies above 0 and below half of the sampling rate");
  }
  if (samples.size() < 2) return {samples.begin(), samples.end()};
  // A straight line passes the filter unchanged, so it is subtracted before and added afterwards.
  // An eighth of a period [samples].
  const auto eighth = static_cast<std::size_t>(rate / (8.0 * cutoff));
  const Line line(samples, std::clamp<std::size_t>(eighth, 1, samples.size() / 2));
  // The filter settles over two periods of the cut-off; the reflection is at most as long as the
  // signal.
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
    std::ranges::reverse(extended);
  }
  std::vector<double> result;
  result.reserve(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    result.push_back(extended[pad + i] + line.at(i));
  }
  return result;
}

}  // namespace haptics::filters

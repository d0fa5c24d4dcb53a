#include "haptics/recordings/kaiser_low_pass.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <stdexcept>

namespace haptics::recordings {
namespace {

void requireSound(const KaiserLowPass::Design& design) {
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
  requireSound(design);
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

}  // namespace haptics::recordings

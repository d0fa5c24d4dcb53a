#include "haptics/engine/kalman_weight.h"

namespace haptics::engine {
namespace {

/// Settles a filter between a force of nothing and one of 1 N, there and back, so that no slope
/// builds up.
template <typename Filter>
double settled(Filter filter) noexcept {
  constexpr double kStep = 0.02;  // [travel units]: 20 a second at 1 kHz
  constexpr int kSteps = 20'000;
  double last = 0.0;
  double force = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    last = force;
    force = filter.step(i / 100 % 2 == 0 ? kStep : -kStep, 0.0, 1.0);
  }
  return 0.5 * (last + force);
}

}  // namespace

double interpolationWeight(const KalmanSpec& spec) noexcept {
  using Printed = models::KalmanFilter<double, models::TextbookCovariance>;
  if (spec.isProcessAsPrinted) return settled(Printed(spec.noise.asPrinted(), spec.scheme));
  return settled(models::KalmanFilter<double>(spec.noise.factored(), spec.scheme));
}

}  // namespace haptics::engine

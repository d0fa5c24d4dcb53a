#include "haptics/engine/force_limiter.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace haptics::engine {

ForceLimiter::ForceLimiter(const SafetyLimits& limits) : limits_(limits) {
  const auto isSound = [](double value) { return std::isfinite(value) && value > 0.0; };
  if (!isSound(limits.maxForce) || !isSound(limits.maxRate)) {
    throw std::invalid_argument("a force limit must be a positive number");
  }
}

ForceLimiter::Limited ForceLimiter::limit(double desired, double dt) noexcept {
  Limited result;
  if (!std::isfinite(desired) || !(dt > 0.0)) {
    last_ = 0.0;
    result.interventions = NotFinite;
    return result;
  }
  double force = std::clamp(desired, -limits_.maxForce, limits_.maxForce);
  if (force != desired) result.interventions |= Saturated;

  const double step = limits_.maxRate * dt;
  const double slewed = std::clamp(force, last_ - step, last_ + step);
  if (slewed != force) result.interventions |= Slewed;

  last_ = std::isfinite(slewed) ? slewed : 0.0;
  result.force = last_;
  return result;
}

}  // namespace haptics::engine

#include "haptics/engine/passivity.h"

#include <algorithm>
#include <cmath>

namespace haptics::engine {

void EnergyObserver::observe(double held, double moved, double velocity, double dt) noexcept {
  const double taken = held * moved + settings_.deviceDamping * velocity * velocity * dt;
  if (!std::isfinite(taken)) return;  // a non-finite sample must not make the sum non-finite
  if (std::abs(held) < settings_.noForce) {
    energy_ = 0.0;
    return;
  }
  energy_ += taken;
  leastEnergy_ = std::min(leastEnergy_, energy_);
}

double EnergyObserver::damped(double desired, double velocity, double dt) const noexcept {
  if (!isActive() || !(settings_.mostDamping > 0.0)) return desired;
  if (!(std::abs(velocity) > settings_.leastVelocity) || !(dt > 0.0)) return desired;
  // Damping b dissipates b v² dt in the coming step; choose b so that this equals −E.
  const double wanted = -energy_ / (velocity * velocity * dt);
  return desired + std::min(wanted, settings_.mostDamping) * velocity;
}

}  // namespace haptics::engine

#include "haptics/devices/pointer_hand.h"

#include <algorithm>

namespace haptics::devices {

double PointerHand::push(double travel, double velocity, double dt) noexcept {
  const double wanted = wanted_.load(std::memory_order_relaxed);
  const double step = std::clamp(wanted - position_, -grip_.speed * dt, grip_.speed * dt);
  position_ += step;
  return grip_.stiffness * (position_ - travel) + grip_.damping * (step / dt - velocity);
}

}  // namespace haptics::devices

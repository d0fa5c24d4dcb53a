#include "haptics/devices/iiwa/iiwa_guard.h"

#include <algorithm>
#include <cmath>

namespace haptics::devices {
DeviceFault IiwaGuard::reasonNotToCommand(
    const JointVector& joints,
    const JointVector& velocity,
    const JointVector& torque) const noexcept {
  for (std::size_t i = 0; i < 7; ++i) {
    const auto j = static_cast<Eigen::Index>(i);
    const int joint = static_cast<int>(i) + 1;
    if (!(std::abs(joints[j]) <= properties_.maxPosition[i] - margins_.position))
      return {"fault.joint_near_end", joint};
    if (!(std::abs(velocity[j]) <= properties_.maxVelocity[i] * margins_.velocity)) {
      return {"fault.joint_too_fast", joint};
    }
    if (!(std::abs(torque[j]) <= properties_.maxTorque[i]))
      return {"fault.joint_overloaded", joint};
  }
  return {};
}

double IiwaGuard::allowedFactor(const JointVector& torque) const noexcept {
  double share = 1.0;
  for (std::size_t i = 0; i < 7; ++i) {
    const double asked = std::abs(torque[static_cast<Eigen::Index>(i)]);
    if (!std::isfinite(asked)) return 0.0;
    const double most = properties_.maxTorque[i] * margins_.torque;
    if (asked > most) share = std::min(share, most / asked);
  }
  return share;
}

}  // namespace haptics::devices

#include "haptics/devices/iiwa/iiwa_guard.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace haptics::devices {
namespace {

constexpr std::array kNearEndReasons{
    "joint A1 is near its end",
    "joint A2 is near its end",
    "joint A3 is near its end",
    "joint A4 is near its end",
    "joint A5 is near its end",
    "joint A6 is near its end",
    "joint A7 is near its end"};
constexpr std::array kTooFastReasons{
    "joint A1 is too fast",
    "joint A2 is too fast",
    "joint A3 is too fast",
    "joint A4 is too fast",
    "joint A5 is too fast",
    "joint A6 is too fast",
    "joint A7 is too fast"};
constexpr std::array kOverloadReasons{
    "joint A1 is overloaded",
    "joint A2 is overloaded",
    "joint A3 is overloaded",
    "joint A4 is overloaded",
    "joint A5 is overloaded",
    "joint A6 is overloaded",
    "joint A7 is overloaded"};

}  // namespace

const char* IiwaGuard::reasonNotToCommand(
    const JointVector& joints,
    const JointVector& velocity,
    const JointVector& torque) const noexcept {
  for (std::size_t i = 0; i < 7; ++i) {
    const auto j = static_cast<Eigen::Index>(i);
    if (!(std::abs(joints[j]) <= properties_.maxPosition[i] - margins_.position))
      return kNearEndReasons[i];
    if (!(std::abs(velocity[j]) <= properties_.maxVelocity[i] * margins_.velocity)) {
      return kTooFastReasons[i];
    }
    if (!(std::abs(torque[j]) <= properties_.maxTorque[i])) return kOverloadReasons[i];
  }
  return nullptr;
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

#include "haptics/emulators/surgeon_hand.h"

#include <stdexcept>

namespace haptics::emulators {
namespace {

bool isSound(const SurgeonHand::Grip& grip) {
  const auto isWithin = [](double value, double most) { return value >= 0.0 && value <= most; };
  return grip.axis.allFinite() && grip.axis.norm() > 0.0 && grip.start.position.allFinite() &&
         grip.start.rotation.allFinite() && isWithin(grip.lateralStiffness, 1e5) &&
         isWithin(grip.lateralDamping, 1000.0) && isWithin(grip.turnStiffness, 1000.0) &&
         isWithin(grip.turnDamping, 20.0);
}

}  // namespace

SurgeonHand::SurgeonHand(const Grip& grip, devices::Hand& hand) : grip_(grip), hand_(hand) {
  if (!isSound(grip)) throw std::invalid_argument("a surgeon's grip needs an axis and springs");
  grip_.axis = grip.axis.stableNormalized();
}

devices::Wrench SurgeonHand::wrench(
    const devices::Pose& tool, const devices::Twist& twist, double dt) noexcept {
  const Eigen::Vector3d& axis = grip_.axis;
  const Eigen::Vector3d away = tool.position - grip_.start.position;
  const Eigen::Vector3d speed = twist.head<3>();
  const double travelled = axis.dot(away);
  const double advance = axis.dot(speed);
  const double push = hand_.push(travelled, advance, dt);

  devices::Wrench wrench;
  wrench.head<3>() = push * axis - grip_.lateralStiffness * (away - travelled * axis) -
                     grip_.lateralDamping * (speed - advance * axis);
  wrench.tail<3>() =
      grip_.turnStiffness * devices::turnBetween(tool.rotation, grip_.start.rotation) -
      grip_.turnDamping * twist.tail<3>();
  return wrench;
}

}  // namespace haptics::emulators

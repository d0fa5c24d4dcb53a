#pragma once

#include "haptics/devices/hand.h"
#include "haptics/devices/iiwa/iiwa_kinematics.h"

namespace haptics::emulators {

/// A simulated surgeon who holds the tool of an arm: pushes it along an axis as a Hand does, and
/// keeps it on the axis and upright by springs and dampers,
///
///     f = F_hand a − (I − a aᵀ)(k (p − p₀) + b ṗ),    m = k_r θ − b_r ω,
///
/// with θ the turn from the tool's present orientation back to where it started. Everything is in
/// the axes of the arm's base; the wrench is at the tool's point.
class SurgeonHand {
 public:
  struct Grip {
    Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< a: positive is advancing; any length > 0
    devices::Pose start;              ///< p₀ and the orientation that is kept; travel is 0 here
    double lateralStiffness = 500.0;  ///< k [N/m], >= 0
    double lateralDamping = 20.0;     ///< b [N·s/m], in [0, 1000]
    double turnStiffness = 10.0;      ///< k_r [N·m/rad], >= 0
    double turnDamping = 0.3;         ///< b_r [N·m·s/rad], in [0, 20]
  };

  /// @param hand  must outlive it; its travel is in metres.
  /// @throws std::invalid_argument  if the grip is not finite or out of range.
  SurgeonHand(const Grip& grip, devices::Hand& hand);

  /// The wrench of the hand on a tool at pose @p tool that moves with @p twist, @p dt [s] after the
  /// last call. Does not allocate.
  devices::Wrench wrench(
      const devices::Pose& tool, const devices::Twist& twist, double dt) noexcept;

  /// How far the tool is along the axis from where the grip began [m].
  double travel(const devices::Pose& tool) const noexcept {
    return devices::displacementAlong(grip_.axis, grip_.start, tool);
  }

  /// The length of its axis is 1.
  const Grip& grip() const noexcept { return grip_; }

 private:
  Grip grip_;
  devices::Hand& hand_;
};

}  // namespace haptics::emulators

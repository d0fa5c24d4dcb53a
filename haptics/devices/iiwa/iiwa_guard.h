#pragma once

#include "haptics/devices/iiwa/iiwa_kinematics.h"

namespace haptics::devices {

/// Keeps the movement and the commands of an arm within its data sheet less a margin.
class IiwaGuard {
 public:
  /// How much of a limit may be used.
  struct Margins {
    double position = 0.08726646259971647;  ///< kept away from the end of every joint [rad]: 5°
    double velocity = 0.8;                  ///< share of the joints' speed, (0, 1]
    double torque = 0.6;  ///< share of the joints' torque that an overlay may take, (0, 1]
  };

  IiwaGuard(IiwaModel model, const Margins& margins) noexcept
      : properties_(propertiesOf(model)), margins_(margins) {}

  /// Why an arm at @p joints [rad], moving with @p velocity [rad/s] and measuring @p torque [N·m],
  /// is not to be driven; nullptr where it is.
  const char* whatIsWrong(
      const JointVector& joints,
      const JointVector& velocity,
      const JointVector& torque) const noexcept;

  /// The share of @p torque [N·m] that keeps all joints within their margin, in [0, 1]; 0 where
  /// something is not finite.
  double allowedShare(const JointVector& torque) const noexcept;

 private:
  const IiwaProperties& properties_;
  Margins margins_;
};

}  // namespace haptics::devices

#pragma once

#include "haptics/devices/iiwa/iiwa_kinematics.h"
#include "haptics/devices/messages.h"

namespace haptics::devices {

/// Keeps the motion of an arm and its commands within the limits of the data sheet, reduced by a
/// margin.
class IiwaGuard {
 public:
  /// How much of a limit may be used.
  struct Margins {
    /// Distance to keep from the end of every joint's range [rad]: 5°.
    double position = 0.08726646259971647;
    double velocity = 0.8;  ///< allowed fraction of the joints' maximum speed, (0, 1]
    /// Fraction of the joints' maximum torque that an overlay may use, (0, 1].
    double torque = 0.6;
  };

  IiwaGuard(IiwaModel model, const Margins& margins) noexcept
      : properties_(propertiesOf(model)), margins_(margins) {}

  /// Returns why an arm at @p joints [rad], moving with @p velocity [rad/s] and measuring @p torque
  /// [N·m], must not be commanded; none if it may be.
  DeviceFault reasonNotToCommand(
      const JointVector& joints,
      const JointVector& velocity,
      const JointVector& torque) const noexcept;

  /// The largest factor in [0, 1] by which @p torque [N·m] keeps all joints within their margin; 0
  /// if a value is not finite.
  double allowedFactor(const JointVector& torque) const noexcept;

 private:
  const IiwaProperties& properties_;
  Margins margins_;
};

}  // namespace haptics::devices

#pragma once

#include "haptics/devices/iiwa/iiwa_kinematics.h"
#include "haptics/emulators/fri_session.h"
#include "haptics/wire/fri_message.h"

namespace haptics::emulators {

/// What a command may ask for besides what the arm's data sheet says. Force and moment as lengths
/// of vectors; the arm's are Cartesian, and KUKA publishes none.
struct FriLimits {
  double maxForce = 140.0;      ///< [N]
  double maxMoment = 40.0;      ///< [N·m]
  double mirrorReach = 0.0001;  ///< how far from the joints a mirror of them may be [rad]
};

/// What is wrong with a command, and with which joint of it.
struct FriVerdict {
  FriEnd end = FriEnd::None;
  int joint = 0;  ///< 1 to 7; 0: none in particular
};

/// Says whether a command may be followed: it has what its mode needs, and all of that within the
/// limits of position, velocity (from command to command), torque and wrench.
class FriJudge {
 public:
  using Mode = wire::fri::ClientCommandMode;

  FriJudge(devices::IiwaModel model, const FriLimits& limits, Mode mode) noexcept
      : arm_(devices::propertiesOf(model)), limits_(limits), mode_(mode) {}

  /// @param before   the joint position of the last command [rad]
  /// @param seconds  since then, > 0
  FriVerdict judge(
      const wire::fri::CommandData& command,
      const wire::fri::Joints& before,
      double seconds) const noexcept;

  /// In CommandingWait: it mirrors @p joints and has what its mode needs, whatever the value.
  bool isMirror(
      const wire::fri::CommandData& command, const wire::fri::Joints& joints) const noexcept;

 private:
  FriEnd missing(const wire::fri::CommandData& command) const noexcept;
  FriVerdict judgePosition(
      const wire::fri::Joints& position,
      const wire::fri::Joints& before,
      double seconds) const noexcept;
  FriVerdict judgeTorque(const wire::fri::Joints& torque) const noexcept;
  FriVerdict judgeWrench(const wire::fri::Vector6& wrench) const noexcept;

  const devices::IiwaProperties& arm_;
  FriLimits limits_;
  Mode mode_;
};

}  // namespace haptics::emulators

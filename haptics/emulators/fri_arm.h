#pragma once

#include "haptics/devices/hand.h"
#include "haptics/devices/iiwa/iiwa_kinematics.h"
#include "haptics/emulators/iiwa_arm.h"
#include "haptics/wire/fri_message.h"

namespace haptics::emulators {

/// The simulated arm in an FRI session, with a surgeon who holds its tool.
///
/// The arm is either held stiffly at its position, as by brakes, or it runs a motion: the impedance
/// of its control mode about the commanded joints, plus the overlay that the client commands. In
/// wrench mode the overlay acts at the tool's origin in the tool's axes, which is this emulator's
/// interpretation of "the frame of the motion centre"; τA τB τC are about z, y and x, like KUKA's
/// angles A B C.
class FriArm {
 public:
  struct Options {
    devices::IiwaModel model = devices::IiwaModel::Iiwa14;
    /// A1 to A7 [rad]; by default the tool points down, with the elbow bent by 90°.
    wire::fri::Joints start{
        0.0, 0.523598775598299, 0.0, -1.570796326794897, 0.0, 1.047197551196598, 0.0};
    double toolLength = 0.2;                                 ///< along the flange's z [m]
    Eigen::Vector3d reamingAxis = Eigen::Vector3d::UnitZ();  ///< in the tool's axes
    wire::fri::ControlMode control = wire::fri::ControlMode::CartesianImpedance;
    wire::fri::ClientCommandMode command = wire::fri::ClientCommandMode::Wrench;
    /// The task frame's z is the reaming axis. There is no spring along and about that axis, so
    /// that the hand feels only the overlay there.
    CartesianImpedance cartesian{
        .stiffness{2000.0, 2000.0, 0.0, 200.0, 200.0, 0.0}, .damping{0.0, 0.0, 0.0, 0.0, 0.0, 1.0}};
    /// No spring and little damping, so that the hand feels only the overlay.
    JointImpedance joint{
        .stiffness = devices::JointVector::Zero(), .damping = devices::JointVector::Constant(1.0)};
    bool hasHand = true;
    /// Travel along the reaming axis [m].
    devices::SimulatedHand::Person person{
        .open = 0.0, .closed = 0.03, .closeTime = 1.5, .stiffness = 2000.0, .damping = 60.0};
    SurgeonHand::Grip grip;  ///< its axis and start are replaced by the arm's
  };

  /// @throws std::invalid_argument  if an option is not valid, or the control mode does not fit the
  /// command mode: a wrench needs Cartesian impedance, a torque joint impedance.
  explicit FriArm(const Options& options);
  FriArm(const FriArm&) = delete;
  FriArm& operator=(const FriArm&) = delete;

  /// Removes the overlay, and holds the arm stiffly at its present position.
  void hold() noexcept;
  /// Begins the program's motion: impedance about the position at which the arm was held.
  void beginMotion() noexcept;
  /// Lets the surgeon grip the tool.
  void attachHand() noexcept;
  void detachHand() noexcept { arm_.setHand(nullptr); }

  /// Executes a command that FriCommandCheck has accepted.
  void apply(const wire::fri::CommandData& command) noexcept;

  /// Advances by @p dt [s], in (0, 0.1].
  void step(double dt) noexcept;

  /// The joints about which the program's motion holds the arm [rad].
  const wire::fri::Joints& heldPosition() const noexcept { return heldPosition_; }
  wire::fri::Joints commandedPosition() const noexcept;
  /// Whether the client commands a wrench or torque other than 0, or joints other than
  /// heldPosition().
  bool hasOverlay() const noexcept { return hasOverlay_; }
  double overlayForce() const noexcept;   ///< along the reaming axis, positive forward [N]
  double overlayTorque() const noexcept;  ///< about the reaming axis, right-handed [N·m]
  double turn() const noexcept;    ///< about the reaming axis from the start, right-handed [rad]
  double travel() const noexcept;  ///< along the reaming axis from the start [m]
  double tracking()
      const noexcept;  ///< from 1 (no deviation) to 0 (a joint deviates by 0.1 rad or more)
  wire::fri::MonitorData measured() const noexcept;

  const Options& options() const noexcept { return options_; }

 private:
  void setOverlay(const wire::fri::CommandData& command) noexcept;
  devices::Wrench overlayInTool() const noexcept;
  devices::Wrench wrenchOf(const devices::JointVector& torque) const noexcept;

  Options options_;
  IiwaArm arm_;
  JointImpedance holdingImpedance_;
  devices::Pose start_;
  devices::SimulatedHand hand_;
  SurgeonHand surgeon_;
  wire::fri::Joints heldPosition_;
  wire::fri::Joints overlayTorque_{};
  devices::Wrench overlay_ = devices::Wrench::Zero();  ///< in the tool's axes
  bool hasOverlay_ = false;
};

}  // namespace haptics::emulators

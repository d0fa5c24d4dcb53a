#pragma once

#include "haptics/devices/hand.h"
#include "haptics/devices/iiwa/iiwa_kinematics.h"
#include "haptics/emulators/iiwa_arm.h"
#include "haptics/wire/fri_message.h"

namespace haptics::emulators {

/// The simulated arm as a session over FRI moves it, and the surgeon who holds its tool.
///
/// It is either held, stiff about the joints where it was, as by brakes; or it runs a motion: the
/// impedance of its control mode about the commanded joints, and the overlay that the client
/// commands. In wrench mode the overlay acts at the tool's point in the tool's axes, which is our
/// reading of "the frame of the motion centre"; τA τB τC are about z, y and x, as KUKA's angles A B
/// C are.
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
    /// The task frame's z is turned to the reaming axis. There is no spring along and about that
    /// axis, so the hand feels only the overlay there.
    CartesianImpedance cartesian{
        .stiffness{2000.0, 2000.0, 0.0, 200.0, 200.0, 0.0}, .damping{0.0, 0.0, 0.0, 0.0, 0.0, 1.0}};
    /// No spring and hardly any damping, so the hand feels only the overlay.
    JointImpedance joint{
        .stiffness = devices::JointVector::Zero(), .damping = devices::JointVector::Constant(1.0)};
    bool hasHand = true;
    /// Travel along the reaming axis [m].
    devices::SimulatedHand::Person person{
        .open = 0.0, .closed = 0.03, .closeTime = 1.5, .stiffness = 2000.0, .damping = 60.0};
    SurgeonHand::Grip grip;  ///< axis and start are set by the arm's own
  };

  /// @throws std::invalid_argument  if an option is not valid, or a command mode lacks the
  /// control mode that it needs: a wrench Cartesian impedance, a torque joint impedance.
  explicit FriArm(const Options& options);
  FriArm(const FriArm&) = delete;
  FriArm& operator=(const FriArm&) = delete;

  /// No overlay, and stiff about the present position.
  void hold() noexcept;
  /// The program's motion: its impedance about where the arm was held.
  void beginMotion() noexcept;
  /// The surgeon takes the tool.
  void attachHand() noexcept;
  void detachHand() noexcept { arm_.setHand(nullptr); }

  /// Follows a command that FriCommandCheck has accepted.
  void apply(const wire::fri::CommandData& command) noexcept;

  /// @p dt [s], in (0, 0.1].
  void step(double dt) noexcept;

  /// The joints about which the program's motion holds the arm [rad].
  const wire::fri::Joints& heldPosition() const noexcept { return held_; }
  wire::fri::Joints commandedPosition() const noexcept;
  /// What the client adds: a wrench or torque that is not zero, or joints that are not the held
  /// ones.
  bool hasOverlay() const noexcept { return hasOverlay_; }
  double overlayForce() const noexcept;   ///< along the reaming axis, positive forward [N]
  double overlayTorque() const noexcept;  ///< about the reaming axis, right-handed [N·m]
  double turn() const noexcept;           ///< about it from the start, right-handed [rad]
  double travel() const noexcept;         ///< along the reaming axis from the start [m]
  double tracking() const noexcept;       ///< 1: follows; 0: 0.1 rad away in a joint, or more
  wire::fri::MonitorData measured() const noexcept;

  const Options& options() const noexcept { return options_; }

 private:
  void setOverlay(const wire::fri::CommandData& command) noexcept;
  devices::Wrench overlayInTool() const noexcept;
  devices::Wrench wrenchOf(const devices::JointVector& torque) const noexcept;

  Options options_;
  IiwaArm arm_;
  JointImpedance stiff_;
  devices::Pose start_;
  devices::SimulatedHand hand_;
  SurgeonHand surgeon_;
  wire::fri::Joints held_;
  wire::fri::Joints overlayTorque_{};
  devices::Wrench overlay_ = devices::Wrench::Zero();  ///< in the tool's axes
  bool hasOverlay_ = false;
};

}  // namespace haptics::emulators

#pragma once

#include <variant>

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

class SurgeonHand;

/// Three components along the axes of a frame, then three about them.
using Vector6 = Eigen::Matrix<double, 6, 1>;

/// What moves in a simulated arm.
struct IiwaMechanics {
  /// M, with the motors behind their gears [kg·m²], >= 0.05. Our own guess.
  devices::JointVector inertia{2.0, 2.0, 1.0, 1.0, 0.4, 0.2, 0.1};
  /// D [N·m·s/rad], >= 0.
  devices::JointVector damping = devices::JointVector::Constant(0.5);
};

/// Springs and dampers at the tool, about the pose of the commanded joints. Their axes are those
/// of a task frame, which is fixed to that commanded pose; z is meant to be the axis of reaming,
/// and by default springs hold across it and leave it free.
///
/// A ratio of damping ζ is 2ζ√(k m), with m the arm's own inertia along that axis at present.
struct CartesianImpedance {
  /// Orientation of the task frame in the frame of the commanded tool.
  Eigen::Matrix3d frame = Eigen::Matrix3d::Identity();
  /// Along x y z [N/m], in [0, 5000]; about x y z [N·m/rad], in [0, 300]: the range
  /// that an example for iiwa_msgs states [unverified].
  Vector6 stiffness{2000.0, 2000.0, 0.0, 200.0, 200.0, 200.0};
  /// ζ, in [0, 1].
  Vector6 dampingRatio = Vector6::Constant(0.7);
  /// Additional damping, also without a spring: along [N·s/m], in [0, 1000]; about [N·m·s/rad], in
  /// [0, 50].
  Vector6 damping = Vector6::Zero();
};

/// Springs and dampers in the joints, about the commanded joints. With zero in both there is only
/// the overlay.
struct JointImpedance {
  devices::JointVector stiffness = devices::JointVector::Constant(1000.0);  ///< [0, 5000] [N·m/rad]
  /// [N·m·s/rad], from 0 to a joint's inertia over 0.25 ms: 400 for A7 by default.
  devices::JointVector damping = devices::JointVector::Constant(20.0);
};

/// Emulates an LBR iiwa and its controller, for tests and demonstrations without an arm:
///
///     M q̈ = τ + Jᵀ F_ext − D q̇,    τ = law(q, q̇) + overlay, each within the arm's torque limit.
///
/// Ours, and simpler than an arm: gravity is compensated and does not appear; M is diagonal and the
/// same everywhere, so nothing is coupled by inertia; joints are stiff, without friction but D;
/// nothing keeps the elbow of a Cartesian law in its place but D, so it settles in about M/D. A
/// joint that meets its limit of position stops there and is free to come back. Limits of velocity
/// are not watched here. A law that is limited by a torque limit is not a spring any more, and its
/// energy() may grow.
///
/// Wrenches are in the axes of the arm's base, at the tool's point. Its only clock is step(). After
/// construction only setControl() throws, and nothing allocates.
class IiwaArm {
 public:
  /// At rest at @p start [rad], and commanded to be there; by default it stands on a joint
  /// impedance.
  /// @throws std::invalid_argument  if the start is out of limits or the mechanics are not valid.
  IiwaArm(
      const devices::IiwaKinematics& kinematics,
      const devices::JointVector& start,
      const IiwaMechanics& mechanics = {});

  /// Sets the control law. Overlays stay.
  /// @throws std::invalid_argument  if a value is out of its range; the law is not changed.
  void setControl(const CartesianImpedance& law);
  void setControl(const JointImpedance& law);

  /// The centre of the law in joint space [rad]. Returns false without a change if one is NaN.
  bool commandPosition(const devices::JointVector& position) noexcept;

  /// Added to the torques of the control law until the next call. NaN sets it to zero and returns
  /// false.
  bool setOverlayWrench(const devices::Wrench& wrench) noexcept;
  bool setOverlayTorque(const devices::JointVector& torque) noexcept;  ///< [N·m]

  /// External force and moment on the tool in addition to the hand's, held until the next call. NaN
  /// sets them to zero and returns false.
  bool setExternalWrench(const devices::Wrench& wrench) noexcept;

  /// The hand on the tool; nullptr: none. It must outlive the arm or be removed with
  /// setHand(nullptr).
  void setHand(SurgeonHand* hand) noexcept { hand_ = hand; }

  /// Advances by @p dt [s], in (0, 0.1], in internal steps of at most 0.25 ms; the hand gives its
  /// force in each. False, and it stays where it is with no velocity, if dt is out of range or a
  /// force is NaN.
  bool step(double dt) noexcept;

  const devices::JointVector& position() const noexcept { return position_; }  ///< [rad]
  const devices::JointVector& velocity() const noexcept { return velocity_; }  ///< [rad/s]
  const devices::JointVector& commandedPosition() const noexcept { return commanded_; }
  /// What the joints gave in the last step of its own: law and overlay, as limited [N·m].
  const devices::JointVector& measuredTorque() const noexcept { return torque_; }
  /// What hand and world did then, Jᵀ F_ext [N·m]; positive turns the joint forward.
  const devices::JointVector& externalTorque() const noexcept { return externalTorque_; }
  /// The torque that was asked for then was more than the arm has.
  bool isSaturated() const noexcept { return isSaturated_; }

  const devices::Pose& tool() const noexcept { return state_.tool; }
  devices::Twist toolTwist() const noexcept { return state_.jacobian * velocity_; }

  /// Kinetic energy of the arm and potential energy of the control law's springs [J].
  double energy() const noexcept;

  const devices::IiwaKinematics& kinematics() const noexcept { return kinematics_; }

 private:
  bool advance(double dt) noexcept;
  void stopAtLimits() noexcept;
  devices::JointVector law() const noexcept;
  devices::JointVector jointTorque(const JointImpedance& law) const noexcept;
  devices::Wrench cartesianWrench(const CartesianImpedance& law) const noexcept;
  Vector6 deflection(const CartesianImpedance& law) const noexcept;
  devices::JointVector limited(const devices::JointVector& torque) noexcept;

  devices::IiwaKinematics kinematics_;
  IiwaMechanics mechanics_;
  devices::JointVector maxPosition_;
  devices::JointVector maxTorque_;
  std::variant<JointImpedance, CartesianImpedance> law_;
  SurgeonHand* hand_ = nullptr;

  devices::JointVector position_;
  devices::JointVector velocity_ = devices::JointVector::Zero();
  devices::IiwaKinematics::State state_;  ///< at position_
  devices::JointVector commanded_;
  devices::Pose commandedTool_;
  devices::Wrench overlayWrench_ = devices::Wrench::Zero();
  devices::JointVector overlayTorque_ = devices::JointVector::Zero();
  devices::Wrench externalWrench_ = devices::Wrench::Zero();
  devices::JointVector torque_ = devices::JointVector::Zero();
  devices::JointVector externalTorque_ = devices::JointVector::Zero();
  bool isSaturated_ = false;
};

}  // namespace haptics::emulators

#pragma once

#include <variant>

#include "haptics/devices/hand.h"
#include "haptics/devices/iiwa/iiwa_kinematics.h"

namespace haptics::emulators {

/// A simulated surgeon who holds the tool of an arm: a Hand pushes it along an axis, and springs
/// and dampers keep it on the axis and in its orientation,
///
///     f = F_hand a − (I − a aᵀ)(k (p − p₀) + b ṗ),    m = k_r θ − b_r ω,
///
/// with θ the rotation vector from the tool's present orientation to its initial one. All
/// quantities are in the axes of the arm's base; the wrench acts at the tool's origin.
class SurgeonHand {
 public:
  struct Grip {
    Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< a: direction of advance; any length > 0
    devices::Pose start;                ///< p₀ and the orientation to keep; travel is 0 here
    double lateralStiffness = 500.0;    ///< k [N/m], >= 0
    double lateralDamping = 20.0;       ///< b [N·s/m], in [0, 1000]
    double rotationalStiffness = 10.0;  ///< k_r [N·m/rad], >= 0
    double rotationalDamping = 0.3;     ///< b_r [N·m·s/rad], in [0, 20]
  };

  /// @param hand  its travel is in metres; must outlive this object.
  /// @throws std::invalid_argument  if the grip is not finite or out of range.
  SurgeonHand(const Grip& grip, devices::Hand& hand);

  /// Returns the wrench of the hand on a tool at pose @p tool that moves with @p twist, @p dt [s]
  /// after the last call. Does not allocate.
  devices::Wrench wrench(
      const devices::Pose& tool, const devices::Twist& twist, double dt) noexcept;

  /// Displacement of the tool along the axis from Grip::start [m].
  double travel(const devices::Pose& tool) const noexcept {
    return devices::displacementAlong(grip_.axis, grip_.start, tool);
  }

  /// The grip; its axis is normalised.
  const Grip& grip() const noexcept { return grip_; }

 private:
  Grip grip_;
  devices::Hand& hand_;
};

/// Translational components along x y z of a frame, then rotational ones about x y z.
using Vector6 = Eigen::Matrix<double, 6, 1>;

/// Rotates the translational and the rotational half of @p values.
Vector6 rotated(const Eigen::Matrix3d& rotation, const Vector6& values) noexcept;

/// Inertia and damping of a simulated arm's joints.
struct IiwaMechanics {
  /// M, including the motors behind their gears [kg·m²], >= 0.05. Palpate's own estimate.
  devices::JointVector inertia{2.0, 2.0, 1.0, 1.0, 0.4, 0.2, 0.1};
  /// D [N·m·s/rad], >= 0.
  devices::JointVector damping = devices::JointVector::Constant(0.5);
};

/// Springs and dampers between the tool and its pose at the commanded joints, in the axes of a task
/// frame that is fixed to the commanded pose. z is meant to be the reaming axis: by default there
/// are springs across it, but none along it.
///
/// A damping ratio ζ gives the damping 2ζ√(k m), with m the arm's present inertia along the axis.
struct CartesianImpedance {
  /// Orientation of the task frame in the frame of the commanded tool.
  Eigen::Matrix3d frame = Eigen::Matrix3d::Identity();
  /// Along x y z [N/m], in [0, 5000]; about x y z [N·m/rad], in [0, 300]: the ranges in an example
  /// for iiwa_msgs [unverified].
  Vector6 stiffness{2000.0, 2000.0, 0.0, 200.0, 200.0, 200.0};
  /// ζ, in [0, 1].
  Vector6 dampingRatio = Vector6::Constant(0.7);
  /// Additional damping, also without a spring: along x y z [N·s/m], in [0, 1000]; about x y z
  /// [N·m·s/rad], in [0, 50].
  Vector6 damping = Vector6::Zero();
};

/// Springs and dampers in the joints, about the commanded joints. If both are 0, only the overlay
/// acts.
struct JointImpedance {
  devices::JointVector stiffness = devices::JointVector::Constant(1000.0);  ///< [0, 5000] [N·m/rad]
  /// [N·m·s/rad], from 0 to a joint's inertia divided by 0.25 ms: with the default inertia 400 for
  /// A7.
  devices::JointVector damping = devices::JointVector::Constant(20.0);
};

/// Emulates an LBR iiwa and its controller, for tests and demonstrations without an arm:
///
///     M q̈ = τ + Jᵀ F_ext − D q̇,    τ = law(q, q̇) + overlay, each within the arm's torque limit.
///
/// A simplified model: gravity is compensated and omitted; M is diagonal and constant, so joints
/// are not coupled by inertia; joints are rigid, with no friction except D; under a Cartesian law
/// only D keeps the elbow in its place, so it settles in about M/D. A joint stops at its position
/// limit and can move back. Velocity limits are not checked. A law whose torque is saturated is no
/// longer a spring, so energy() may grow.
///
/// Wrenches are in the axes of the arm's base, at the tool's origin. Time advances in step() only.
/// After construction only setControl() throws, and no function allocates.
class IiwaArm {
 public:
  /// The arm rests at @p start [rad], which is also the commanded position, under the default
  /// JointImpedance.
  /// @throws std::invalid_argument  if the start is out of limits or the mechanics are not valid.
  IiwaArm(
      const devices::IiwaKinematics& kinematics,
      const devices::JointVector& start,
      const IiwaMechanics& mechanics = {});

  /// Sets the control law. Overlays are kept.
  /// @throws std::invalid_argument  if a value is out of its range; the law is not changed.
  void setControl(const CartesianImpedance& law);
  void setControl(const JointImpedance& law);

  /// Sets the joint position about which the law acts [rad]. Returns false, without a change, if a
  /// value is not finite.
  bool commandPosition(const devices::JointVector& position) noexcept;

  /// Sets a wrench that is added to the control law until the next call. Values that are not finite
  /// set it to zero and return false.
  bool setOverlayWrench(const devices::Wrench& wrench) noexcept;
  bool setOverlayTorque(const devices::JointVector& torque) noexcept;  ///< [N·m]

  /// Sets an external wrench on the tool, in addition to the hand's, until the next call. Values
  /// that are not finite set it to zero and return false.
  bool setExternalWrench(const devices::Wrench& wrench) noexcept;

  /// Sets the hand on the tool; nullptr: none. It must outlive the arm or be removed with
  /// setHand(nullptr).
  void setHand(SurgeonHand* hand) noexcept { hand_ = hand; }

  /// Advances by @p dt [s], in (0, 0.1], in internal steps of at most 0.25 ms, in each of which the
  /// hand computes its force. Returns false, and stops the arm, if dt is out of range or a force is
  /// not finite.
  bool step(double dt) noexcept;

  const devices::JointVector& position() const noexcept { return position_; }  ///< [rad]
  const devices::JointVector& velocity() const noexcept { return velocity_; }  ///< [rad/s]
  const devices::JointVector& commandedPosition() const noexcept { return commanded_; }
  /// Torques of the joints in the last internal step: law plus overlay, saturated [N·m].
  const devices::JointVector& measuredTorque() const noexcept { return torque_; }
  /// Torques of hand and external wrench in that step, Jᵀ F_ext [N·m]; positive turns the joint
  /// forward.
  const devices::JointVector& externalTorque() const noexcept { return externalTorque_; }
  /// Whether a joint torque was saturated in that step.
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

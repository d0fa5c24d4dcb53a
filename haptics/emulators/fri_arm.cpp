#include "haptics/emulators/fri_arm.h"

#include <algorithm>
#include <stdexcept>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

namespace haptics::emulators {
namespace {

using devices::asJoints;
using devices::asVector;
using devices::JointVector;
using devices::Wrench;
using wire::fri::ClientCommandMode;
using wire::fri::ControlMode;
using wire::fri::Joints;

/// Converts from the wire's order Fx Fy Fz τA τB τC.
Wrench fromWire(const wire::fri::Vector6& values) noexcept {
  Wrench wrench;
  wrench << values[0], values[1], values[2], values[5], values[4], values[3];
  return wrench;
}

wire::fri::Vector6 toWire(const Wrench& wrench) noexcept {
  return {wrench[0], wrench[1], wrench[2], wrench[5], wrench[4], wrench[3]};
}

/// The shortest rotation of the z axis to the unit vector @p axis (Rodrigues' formula, with sin θ
/// and cos θ from the vectors). For the opposite axis it is half a turn about x; Eigen's
/// FromTwoVectors would need a singular value decomposition there.
Eigen::Matrix3d rotationFromZ(const Eigen::Vector3d& axis) {
  const double cosine = axis.z();
  if (cosine < -1.0 + 1e-12) return Eigen::Vector3d(1.0, -1.0, -1.0).asDiagonal();
  const Eigen::Vector3d normal = Eigen::Vector3d::UnitZ().cross(axis);
  Eigen::Matrix3d cross;
  cross << 0.0, -normal.z(), normal.y(), normal.z(), 0.0, -normal.x(), -normal.y(), normal.x(), 0.0;
  return Eigen::Matrix3d::Identity() + cross + cross * cross / (1.0 + cosine);
}

FriArm::Options validated(const FriArm::Options& options) {
  const bool hasAxis = options.reamingAxis.allFinite() && options.reamingAxis.norm() > 1e-6;
  if (!hasAxis || !(options.toolLength >= 0.0 && options.toolLength <= 2.0)) {
    throw std::invalid_argument("a tool needs a length of 0 to 2 m and an axis");
  }
  const bool isWrong = (options.command == ClientCommandMode::Wrench &&
                        options.control != ControlMode::CartesianImpedance) ||
                       (options.command == ClientCommandMode::Torque &&
                        options.control != ControlMode::JointImpedance) ||
                       options.control == ControlMode::NoControl ||
                       options.command == ClientCommandMode::NoCommand ||
                       options.command == ClientCommandMode::CartesianPose;
  if (isWrong) {
    throw std::invalid_argument(
        "commanding a wrench needs Cartesian impedance, a torque joint impedance, a position any "
        "control; there is nothing else");
  }
  FriArm::Options made = options;
  made.reamingAxis.normalize();
  made.cartesian.frame = rotationFromZ(made.reamingAxis);
  return made;
}

devices::IiwaKinematics kinematicsOf(const FriArm::Options& options) {
  devices::Pose tool;
  tool.position.z() = options.toolLength;
  return devices::IiwaKinematics(options.model, tool);
}

/// The largest stiffness that the controller allows, with a damping ratio of 0.7.
JointImpedance stiffestImpedance() {
  JointImpedance law;
  law.stiffness.setConstant(5000.0);
  law.damping = 1.4 * (5000.0 * IiwaMechanics{}.inertia).cwiseSqrt();
  return law;
}

SurgeonHand::Grip gripOf(
    SurgeonHand::Grip grip, const Eigen::Vector3d& axis, const devices::Pose& start) {
  grip.axis = axis;
  grip.start = start;
  return grip;
}

}  // namespace

FriArm::FriArm(const Options& options)
    : options_(validated(options)),
      arm_(kinematicsOf(options_), asVector(options_.start)),
      holdingImpedance_(stiffestImpedance()),
      start_(arm_.tool()),
      hand_(options_.person),
      surgeon_(gripOf(options_.grip, start_.rotation * options_.reamingAxis, start_), hand_),
      heldPosition_(options_.start) {
  // Refuse invalid options now, and not during a motion.
  arm_.setControl(options_.joint);
  arm_.setControl(options_.cartesian);
  hold();
}

void FriArm::hold() noexcept {
  arm_.setControl(holdingImpedance_);
  heldPosition_ = asJoints(arm_.position());
  apply({});
}

void FriArm::beginMotion() noexcept {
  if (options_.control == ControlMode::CartesianImpedance) arm_.setControl(options_.cartesian);
  if (options_.control == ControlMode::JointImpedance) arm_.setControl(options_.joint);
}

void FriArm::attachHand() noexcept {
  if (options_.hasHand) arm_.setHand(&surgeon_);
}

void FriArm::apply(const wire::fri::CommandData& command) noexcept {
  arm_.commandPosition(asVector(command.jointPosition.value_or(heldPosition_)));
  setOverlay(command);
  arm_.setOverlayTorque(asVector(overlayTorque_));
}

void FriArm::step(double dt) noexcept {
  arm_.setOverlayWrench(rotated(arm_.tool().rotation, overlay_));
  arm_.step(dt);
}

void FriArm::setOverlay(const wire::fri::CommandData& command) noexcept {
  const bool isWrench = options_.command == ClientCommandMode::Wrench;
  const bool isTorque = options_.command == ClientCommandMode::Torque;
  overlay_ = isWrench ? fromWire(command.wrench.value_or(wire::fri::Vector6{})) : Wrench::Zero();
  overlayTorque_ = isTorque ? command.jointTorque.value_or(Joints{}) : Joints{};
  constexpr double kPositionTolerance = 1e-6;  // [rad]
  const JointVector away = arm_.commandedPosition() - asVector(heldPosition_);
  const bool isElsewhere = options_.command == ClientCommandMode::JointPosition &&
                           away.cwiseAbs().maxCoeff() > kPositionTolerance;
  hasOverlay_ = isElsewhere || !overlay_.isZero(0.0) || !asVector(overlayTorque_).isZero(0.0);
}

Joints FriArm::commandedPosition() const noexcept {
  return asJoints(arm_.commandedPosition());
}

/// The smallest wrench at the tool, in the base's axes, that causes the joint torques @p torque; it
/// stays finite near a singular pose.
Wrench FriArm::wrenchOf(const JointVector& torque) const noexcept {
  const devices::IiwaJacobian jacobian = arm_.kinematics().at(arm_.position()).jacobian;
  Eigen::Matrix<double, 6, 6> square = jacobian * jacobian.transpose();
  square.diagonal().array() += 1e-9;  // keeps the matrix invertible in a singular pose
  return square.ldlt().solve(jacobian * torque);
}

Wrench FriArm::overlayInTool() const noexcept {
  if (options_.command != ClientCommandMode::Torque) return overlay_;
  return rotated(arm_.tool().rotation.transpose(), wrenchOf(asVector(overlayTorque_)));
}

double FriArm::overlayForce() const noexcept {
  return overlayInTool().head<3>().dot(options_.reamingAxis);
}

double FriArm::overlayTorque() const noexcept {
  return overlayInTool().tail<3>().dot(options_.reamingAxis);
}

double FriArm::turn() const noexcept {
  return surgeon_.grip().axis.dot(
      devices::rotationVectorBetween(start_.rotation, arm_.tool().rotation));
}

double FriArm::travel() const noexcept {
  return devices::displacementAlong(surgeon_.grip().axis, start_, arm_.tool());
}

double FriArm::tracking() const noexcept {
  constexpr double kLostTrackingAngle = 0.1;  // [rad]
  const JointVector away = arm_.commandedPosition() - arm_.position();
  return std::clamp(1.0 - away.cwiseAbs().maxCoeff() / kLostTrackingAngle, 0.0, 1.0);
}

wire::fri::MonitorData FriArm::measured() const noexcept {
  wire::fri::MonitorData data;
  data.measuredPosition = asJoints(arm_.position());
  data.measuredTorque = asJoints(arm_.measuredTorque());
  data.commandedPosition = commandedPosition();
  data.commandedTorque = overlayTorque_;
  data.externalTorque = asJoints(arm_.externalTorque());
  data.externalForce =
      toWire(rotated(arm_.tool().rotation.transpose(), wrenchOf(arm_.externalTorque())));
  data.redundancy = {.value = arm_.position()[2]};  // E1 is the angle of A3
  Eigen::Quaterniond turn(arm_.tool().rotation);
  if (turn.w() < 0.0) turn.coeffs() = -turn.coeffs();
  const Eigen::Vector3d toolPosition = 1000.0 * arm_.tool().position;  // [mm]
  data.pose.emplace().name = wire::fri::Name("tool");
  for (const double value :
       {toolPosition.x(),
        toolPosition.y(),
        toolPosition.z(),
        turn.w(),
        turn.x(),
        turn.y(),
        turn.z()}) {
    *data.pose->elements.add() = value;
  }
  return data;
}

}  // namespace haptics::emulators

#include "haptics/emulators/iiwa_arm.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <Eigen/Geometry>

namespace haptics::emulators {
namespace {

bool isSound(const SurgeonHand::Grip& grip) {
  const auto isWithin = [](double value, double most) { return value >= 0.0 && value <= most; };
  return grip.axis.allFinite() && grip.axis.norm() > 0.0 && grip.start.position.allFinite() &&
         grip.start.rotation.allFinite() && isWithin(grip.lateralStiffness, 1e5) &&
         isWithin(grip.lateralDamping, 1000.0) && isWithin(grip.rotationalStiffness, 1000.0) &&
         isWithin(grip.rotationalDamping, 20.0);
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
  wrench.tail<3>() = grip_.rotationalStiffness *
                         devices::rotationVectorBetween(tool.rotation, grip_.start.rotation) -
                     grip_.rotationalDamping * twist.tail<3>();
  return wrench;
}

using devices::JointVector;
using devices::Twist;
using devices::Wrench;

namespace {

constexpr double kLongestSubstep = 0.00025;  // [s]
constexpr double kLongestStep = 0.1;         // [s]

void require(bool isSound, const char* what) {
  if (!isSound) throw std::invalid_argument(what);
}

/// Whether every value is in [0, @p most]; false for NaN.
template <typename Values, typename Bounds>
bool isWithin(const Values& values, const Bounds& most) {
  return (values.array() >= 0.0).all() && (values.array() <= most.array()).all();
}

Vector6 axisValues(double along, double about) {
  return {along, along, along, about, about, about};
}

/// Sets @p target to @p value, or to 0 if that is not finite. Returns whether it is finite.
template <typename Values>
bool setOrZero(Values& target, const Values& value) noexcept {
  const bool isFinite = value.allFinite();
  if (isFinite) {
    target = value;
  } else {
    target.setZero();
  }
  return isFinite;
}

/// The moment of rotational springs whose stiffness differs from axis to axis: J_r⁻ᵀ pull, with the
/// right Jacobian J_r of SO(3) at the rotation vector @p turn. Its work is the springs' energy.
Eigen::Vector3d momentOf(const Eigen::Vector3d& turn, const Eigen::Vector3d& pull) noexcept {
  const double angle = turn.norm();
  // For small angles use the limit, since the difference of two large numbers would lose its
  // digits.
  const double share =
      angle < 1e-3 ? 1.0 / 12.0 : 1.0 / (angle * angle) - 0.5 / (angle * std::tan(0.5 * angle));
  const Eigen::Vector3d across = turn.cross(pull);
  return pull - 0.5 * across + share * turn.cross(across);
}

}  // namespace

Vector6 rotated(const Eigen::Matrix3d& rotation, const Vector6& values) noexcept {
  Vector6 result;
  result.head<3>() = rotation * values.head<3>();
  result.tail<3>() = rotation * values.tail<3>();
  return result;
}

IiwaArm::IiwaArm(
    const devices::IiwaKinematics& kinematics,
    const JointVector& start,
    const IiwaMechanics& mechanics)
    : kinematics_(kinematics),
      mechanics_(mechanics),
      maxPosition_(kinematics.properties().maxPosition.data()),
      maxTorque_(kinematics.properties().maxTorque.data()),
      position_(start) {
  require(isWithin(start.cwiseAbs(), maxPosition_), "an arm starts within its limits");
  require(
      mechanics.inertia.allFinite() && (mechanics.inertia.array() >= 0.05).all() &&
          isWithin(mechanics.damping, JointVector::Constant(1e4)),
      "an arm's joints need inertia, and damping that is not negative");
  state_ = kinematics_.at(position_);
  commandPosition(start);
}

void IiwaArm::setControl(const CartesianImpedance& law) {
  require(
      law.frame.allFinite() && (law.frame * law.frame.transpose()).isIdentity(1e-6) &&
          law.frame.determinant() > 0.0,
      "a task frame is a rotation");
  require(
      isWithin(law.stiffness, axisValues(5000.0, 300.0)) &&
          isWithin(law.dampingRatio, axisValues(1.0, 1.0)) &&
          isWithin(law.damping, axisValues(1000.0, 50.0)),
      "a Cartesian impedance is out of its range");
  law_ = law;
}

void IiwaArm::setControl(const JointImpedance& law) {
  require(
      isWithin(law.stiffness, JointVector::Constant(5000.0)) &&
          isWithin(law.damping, mechanics_.inertia / kLongestSubstep),
      "a joint impedance is out of its range");
  law_ = law;
}

bool IiwaArm::commandPosition(const JointVector& position) noexcept {
  if (!position.allFinite()) return false;
  commanded_ = position;
  commandedTool_ = kinematics_.at(position).tool;
  return true;
}

bool IiwaArm::setOverlayWrench(const Wrench& wrench) noexcept {
  return setOrZero(overlayWrench_, wrench);
}

bool IiwaArm::setOverlayTorque(const JointVector& torque) noexcept {
  return setOrZero(overlayTorque_, torque);
}

bool IiwaArm::setExternalWrench(const Wrench& wrench) noexcept {
  return setOrZero(externalWrench_, wrench);
}

bool IiwaArm::step(double dt) noexcept {
  bool isSound = dt > 0.0 && dt <= kLongestStep;
  if (isSound) {
    // The subtraction prevents an additional step by rounding.
    const int count = std::max(1, static_cast<int>(std::ceil(dt / kLongestSubstep - 1e-9)));
    for (int i = 0; i < count && isSound; ++i) isSound = advance(dt / count);
  }
  if (!isSound) velocity_.setZero();
  return isSound;
}

bool IiwaArm::advance(double dt) noexcept {
  Wrench external = externalWrench_;
  if (hand_ != nullptr) external += hand_->wrench(state_.tool, toolTwist(), dt);
  const auto transposed = state_.jacobian.transpose();
  const JointVector push = transposed * external;
  const JointVector drive = law() + overlayTorque_ + transposed * overlayWrench_;
  if (!push.allFinite() || !drive.allFinite()) return false;

  externalTorque_ = push;
  torque_ = limited(drive);
  // The joints' own damping is integrated implicitly, so any amount is stable.
  const JointVector momentum =
      mechanics_.inertia.cwiseProduct(velocity_) + dt * (torque_ + externalTorque_);
  const JointVector velocity = momentum.cwiseQuotient(mechanics_.inertia + dt * mechanics_.damping);
  if (!velocity.allFinite()) return false;
  velocity_ = velocity;
  position_ += dt * velocity_;
  stopAtLimits();
  state_ = kinematics_.at(position_);
  return true;
}

void IiwaArm::stopAtLimits() noexcept {
  for (Eigen::Index i = 0; i < position_.size(); ++i) {
    if (std::abs(position_[i]) <= maxPosition_[i]) continue;
    position_[i] = std::copysign(maxPosition_[i], position_[i]);
    velocity_[i] = 0.0;
  }
}

JointVector IiwaArm::law() const noexcept {
  if (const auto* joint = std::get_if<JointImpedance>(&law_)) return jointTorque(*joint);
  return state_.jacobian.transpose() * cartesianWrench(*std::get_if<CartesianImpedance>(&law_));
}

JointVector IiwaArm::jointTorque(const JointImpedance& law) const noexcept {
  return law.stiffness.cwiseProduct(commanded_ - position_) - law.damping.cwiseProduct(velocity_);
}

Vector6 IiwaArm::deflection(const CartesianImpedance& law) const noexcept {
  Vector6 inBase;
  inBase.head<3>() = commandedTool_.position - state_.tool.position;
  inBase.tail<3>() = devices::rotationVectorBetween(state_.tool.rotation, commandedTool_.rotation);
  return rotated((commandedTool_.rotation * law.frame).transpose(), inBase);
}

Wrench IiwaArm::cartesianWrench(const CartesianImpedance& law) const noexcept {
  const Eigen::Matrix3d task = commandedTool_.rotation * law.frame;
  const Vector6 away = deflection(law);
  Wrench wrench = law.stiffness.cwiseProduct(away);
  wrench.tail<3>() = momentOf(away.tail<3>(), wrench.tail<3>());

  devices::IiwaJacobian jacobian;
  jacobian.topRows<3>() = task.transpose() * state_.jacobian.topRows<3>();
  jacobian.bottomRows<3>() = task.transpose() * state_.jacobian.bottomRows<3>();
  const Twist twist = jacobian * velocity_;
  for (Eigen::Index i = 0; i < 6; ++i) {
    // Near a singular pose the inertia along an axis tends to infinity, so it is bounded.
    const auto row = jacobian.row(i).transpose();
    const double mobility = std::max(1e-3, row.cwiseAbs2().cwiseQuotient(mechanics_.inertia).sum());
    const double ratio = 2.0 * law.dampingRatio[i] * std::sqrt(law.stiffness[i] / mobility);
    wrench[i] -= (ratio + law.damping[i]) * twist[i];
  }
  return rotated(task, wrench);
}

JointVector IiwaArm::limited(const JointVector& torque) noexcept {
  isSaturated_ = (torque.array().abs() > maxTorque_.array()).any();
  return torque.cwiseMin(maxTorque_).cwiseMax(-maxTorque_);
}

double IiwaArm::energy() const noexcept {
  const double motion = 0.5 * mechanics_.inertia.dot(velocity_.cwiseAbs2());
  if (const auto* joint = std::get_if<JointImpedance>(&law_)) {
    return motion + 0.5 * joint->stiffness.dot((commanded_ - position_).cwiseAbs2());
  }
  const auto& law = *std::get_if<CartesianImpedance>(&law_);
  return motion + 0.5 * law.stiffness.dot(deflection(law).cwiseAbs2());
}

}  // namespace haptics::emulators

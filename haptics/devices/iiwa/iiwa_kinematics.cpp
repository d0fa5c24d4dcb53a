#include "haptics/devices/iiwa/iiwa_kinematics.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <Eigen/Geometry>

namespace haptics::devices {
namespace {

/// sin α of each link. cos α is 1 where this is 0, else 0.
constexpr std::array<double, 7> kSinAlpha{0.0, -1.0, 1.0, 1.0, -1.0, -1.0, 1.0};

Pose link(std::size_t index, double angle, double length) noexcept {
  const double sa = kSinAlpha[index];
  const double ca = sa == 0.0 ? 1.0 : 0.0;
  const double s = std::sin(angle);
  const double c = std::cos(angle);
  Pose pose;
  pose.position << 0.0, -length * sa, length * ca;
  pose.rotation << c, -s, 0.0,  //
      s * ca, c * ca, -sa,      //
      s * sa, c * sa, ca;
  return pose;
}

bool isRotation(const Eigen::Matrix3d& matrix) {
  // The tolerance allows for matrices that were written with seven decimals.
  return matrix.allFinite() && (matrix * matrix.transpose()).isIdentity(1e-6) &&
         matrix.determinant() > 0.0;
}

}  // namespace

Pose operator*(const Pose& a, const Pose& b) noexcept {
  return {.position = a.position + a.rotation * b.position, .rotation = a.rotation * b.rotation};
}

Eigen::Vector3d rotationVectorBetween(
    const Eigen::Matrix3d& from, const Eigen::Matrix3d& to) noexcept {
  const Eigen::Matrix3d between = to * from.transpose();
  Eigen::Quaterniond turn(between);
  if (turn.w() < 0.0) turn.coeffs() = -turn.coeffs();
  const double sine = turn.vec().norm();  // sine of half the angle
  const double scale = sine < 1e-9 ? 2.0 : 2.0 * std::atan2(sine, turn.w()) / sine;
  return scale * turn.vec();
}

double displacementAlong(const Eigen::Vector3d& axis, const Pose& start, const Pose& now) noexcept {
  return axis.dot(now.position - start.position);
}

JointVector asVector(const std::array<double, 7>& joints) noexcept {
  return JointVector(joints.data());
}

std::array<double, 7> asJoints(const JointVector& vector) noexcept {
  std::array<double, 7> joints{};
  std::copy_n(vector.data(), joints.size(), joints.begin());
  return joints;
}

IiwaKinematics::IiwaKinematics(IiwaModel model, const Pose& tool)
    : model_(model), tool_(tool), lengths_{} {
  if (!tool.position.allFinite() || !isRotation(tool.rotation)) {
    throw std::invalid_argument("the tool of an arm needs a finite place and a rotation");
  }
  tool_.rotation = Eigen::Quaterniond(tool.rotation).normalized().toRotationMatrix();
  const IiwaProperties& arm = properties();
  lengths_ = {
      arm.baseToShoulder, 0.0, arm.shoulderToElbow, 0.0, arm.elbowToWrist, 0.0, arm.wristToFlange};
}

IiwaKinematics::State IiwaKinematics::at(const JointVector& q) const noexcept {
  State state;
  Eigen::Matrix<double, 3, 7> origins;
  Pose pose;
  for (Eigen::Index i = 0; i < 7; ++i) {
    const auto index = static_cast<std::size_t>(i);
    pose = pose * link(index, q[i], lengths_[index]);
    origins.col(i) = pose.position;
    state.jacobian.col(i).tail<3>() = pose.rotation.col(2);
  }
  state.tool = pose * tool_;
  for (Eigen::Index i = 0; i < 7; ++i) {
    const Eigen::Vector3d axis = state.jacobian.col(i).tail<3>();
    const Eigen::Vector3d arm = state.tool.position - origins.col(i);
    state.jacobian.col(i).head<3>() = axis.cross(arm);
  }
  return state;
}

}  // namespace haptics::devices

#pragma once

#include <array>
#include <cstdint>

#include <Eigen/Core>

namespace haptics::devices {

/// Which KUKA LBR iiwa: 7 kg and 800 mm of reach, or 14 kg and 820 mm.
enum class IiwaModel : std::uint8_t { Iiwa7, Iiwa14 };

/// The data sheet of an arm. Arrays hold the values of joints A1 to A7.
struct IiwaProperties {
  double baseToShoulder = 0.0;   ///< from the floor of the base to A2, along z [m]
  double shoulderToElbow = 0.0;  ///< from A2 to A4 [m]
  double elbowToWrist = 0.0;     ///< from A4 to A6 [m]
  /// From A6 to the bare flange [m]; a media flange counts as part of the tool.
  double wristToFlange = 0.0;
  std::array<double, 7> maxPosition{};  ///< range is [−maxPosition, maxPosition] [rad]
  std::array<double, 7> maxVelocity{};  ///< [rad/s]
  std::array<double, 7> maxTorque{};    ///< [N·m]
};

namespace detail {
constexpr std::array<double, 7> radians(std::array<double, 7> degrees) noexcept {
  for (double& value : degrees) value *= 3.14159265358979323846 / 180.0;
  return degrees;
}

inline constexpr std::array<double, 7> kIiwaMaxPosition =
    radians({170.0, 120.0, 170.0, 120.0, 170.0, 120.0, 175.0});

inline constexpr IiwaProperties kIiwa7{
    .baseToShoulder = 0.34,
    .shoulderToElbow = 0.40,
    .elbowToWrist = 0.40,
    .wristToFlange = 0.126,
    .maxPosition = kIiwaMaxPosition,
    .maxVelocity = radians({98.0, 98.0, 100.0, 130.0, 140.0, 180.0, 180.0}),
    .maxTorque = {176.0, 176.0, 110.0, 110.0, 110.0, 40.0, 40.0}};

inline constexpr IiwaProperties kIiwa14{
    .baseToShoulder = 0.36,
    .shoulderToElbow = 0.42,
    .elbowToWrist = 0.40,
    .wristToFlange = 0.126,
    .maxPosition = kIiwaMaxPosition,
    .maxVelocity = radians({85.0, 85.0, 100.0, 75.0, 130.0, 135.0, 135.0}),
    .maxTorque = {320.0, 320.0, 176.0, 176.0, 110.0, 40.0, 40.0}};
}  // namespace detail

/// The data sheet of @p model.
///
/// Two public descriptions agree on the lengths: the URDF of IFL-CAMP/iiwa_stack and the DH table
/// of Modi1987/KST-Kuka-Sunrise-Toolbox. Limits of position and velocity are those of
/// lbr-stack/lbr_fri_ros2_stack. The torques were not confirmed by a second source [unverified].
constexpr const IiwaProperties& propertiesOf(IiwaModel model) noexcept {
  return model == IiwaModel::Iiwa7 ? detail::kIiwa7 : detail::kIiwa14;
}

using JointVector = Eigen::Matrix<double, 7, 1>;   ///< A1 to A7
using Twist = Eigen::Matrix<double, 6, 1>;         ///< linear [m/s], then angular [rad/s]
using Wrench = Eigen::Matrix<double, 6, 1>;        ///< force [N], then moment [N·m]
using IiwaJacobian = Eigen::Matrix<double, 6, 7>;  ///< linear [m/rad], then angular [1]

/// Position and orientation of a frame relative to another.
struct Pose {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();      ///< [m]
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  ///< its columns are the frame's axes
};

/// Composition: with a the pose of frame B in A, and b the pose of C in B, returns the pose of C in
/// A.
Pose operator*(const Pose& a, const Pose& b) noexcept;

/// The rotation from @p from to @p to as a rotation vector (axis times angle) in their common
/// reference frame; its length is in [0, π] [rad].
Eigen::Vector3d rotationVectorBetween(
    const Eigen::Matrix3d& from, const Eigen::Matrix3d& to) noexcept;

/// Displacement of a tool along @p axis since @p start, s = a·(p − p₀) [m]. @p axis has length 1.
double displacementAlong(const Eigen::Vector3d& axis, const Pose& start, const Pose& now) noexcept;

/// The values of joints A1 to A7 as a vector, and as an array.
JointVector asVector(const std::array<double, 7>& joints) noexcept;
std::array<double, 7> asJoints(const JointVector& vector) noexcept;

/// Kinematics of an LBR iiwa with a tool: its pose and its Jacobian J. The twist of the tool is
/// J q̇; the joint torques with which it exerts a wrench w on its environment are Jᵀ w.
///
/// The origin of the base frame is on the bottom of the base, z up; with all joints at zero the arm
/// points straight up, and the flange has the orientation of the base. Links follow Craig's
/// convention (modified Denavit–Hartenberg): a rotation by α about x, a rotation by q about z and a
/// translation by d along z,
///
///     α = 0, −90°, 90°, 90°, −90°, −90°, 90°,    d = d₁, 0, d₃, 0, d₅, 0, d₇
///
/// (as in Modi1987/KST-Kuka-Sunrise-Toolbox), so A2 and A6 rotate about +y and A4 about −y. Twists
/// and wrenches refer to the origin of the tool frame, in the axes of the base.
///
/// No function allocates, and only the constructor throws; a joint angle that is NaN gives a pose
/// of NaN.
class IiwaKinematics {
 public:
  /// The tool's pose in the base frame, and the 6×7 geometric Jacobian J at the tool.
  struct State {
    Pose tool;
    IiwaJacobian jacobian = IiwaJacobian::Zero();
  };

  /// @param tool  relative to the flange, whose z points away from the arm; the default is the
  ///              flange itself.
  /// @throws std::invalid_argument  if the tool is not finite, or its rotation is no rotation (to
  /// 1e-6).
  explicit IiwaKinematics(IiwaModel model, const Pose& tool = {});

  /// Pose and Jacobian at joint angles @p q [rad].
  State at(const JointVector& q) const noexcept;

  IiwaModel model() const noexcept { return model_; }
  const IiwaProperties& properties() const noexcept { return propertiesOf(model_); }

 private:
  IiwaModel model_;
  Pose tool_;
  std::array<double, 7> lengths_;  ///< d of each link [m]
};

}  // namespace haptics::devices

#pragma once

#include <array>
#include <cstdint>

#include <Eigen/Core>

namespace haptics::devices {

/// Which KUKA LBR iiwa: 7 kg and 800 mm of reach, or 14 kg and 820 mm.
enum class IiwaModel : std::uint8_t { Iiwa7, Iiwa14 };

/// What a data sheet says about an arm. Seven values are those of A1 to A7.
struct IiwaProperties {
  double baseToShoulder = 0.0;   ///< from the floor of the base to A2, along z [m]
  double shoulderToElbow = 0.0;  ///< from A2 to A4 [m]
  double elbowToWrist = 0.0;     ///< from A4 to A6 [m]
  double wristToFlange = 0.0;    ///< from A6 to the bare flange [m]; a media flange is a tool
  std::array<double, 7> maxPosition{};  ///< either way of zero [rad]
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
/// Lengths agree in two public descriptions: the URDF of IFL-CAMP/iiwa_stack and the DH table of
/// Modi1987/KST-Kuka-Sunrise-Toolbox. Limits of position and velocity are those of
/// lbr-stack/lbr_fri_ros2_stack. The torques were not confirmed by a second source [unverified].
constexpr const IiwaProperties& propertiesOf(IiwaModel model) noexcept {
  return model == IiwaModel::Iiwa7 ? detail::kIiwa7 : detail::kIiwa14;
}

using JointVector = Eigen::Matrix<double, 7, 1>;   ///< A1 to A7
using Twist = Eigen::Matrix<double, 6, 1>;         ///< linear [m/s], then angular [rad/s]
using Wrench = Eigen::Matrix<double, 6, 1>;        ///< force [N], then moment [N·m]
using IiwaJacobian = Eigen::Matrix<double, 6, 7>;  ///< linear [m/rad], then angular [1]

/// Where a frame is, and how it is turned, as seen from another.
struct Pose {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();      ///< [m]
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  ///< its columns are the frame's axes
};

/// Frame c as seen from a, of b as seen from a and c as seen from b.
Pose operator*(const Pose& a, const Pose& b) noexcept;

/// The turn from @p from to @p to as axis times angle, in the frame that both are seen from; its
/// length is in [0, π] [rad].
Eigen::Vector3d turnBetween(const Eigen::Matrix3d& from, const Eigen::Matrix3d& to) noexcept;

/// How far a tool has come along an axis since a start, s = a·(p − p₀) [m]. @p axis has length 1.
double displacementAlong(const Eigen::Vector3d& axis, const Pose& start, const Pose& now) noexcept;

/// Where the tool of an LBR iiwa is, how it moves, and what it takes to hold it.
///
/// The base frame stands on the floor of the base with z up; with all joints at zero the arm stands
/// straight up and the flange is turned as the base is. The chain is Craig's (modified
/// Denavit–Hartenberg): every link is a turn of α about x, a turn of q about z and a way d along z,
///
///     α = 0, −90°, 90°, 90°, −90°, −90°, 90°,    d = d₁, 0, d₃, 0, d₅, 0, d₇
///
/// (as in Modi1987/KST-Kuka-Sunrise-Toolbox), so A2 and A6 turn about +y and A4 about −y. Twists
/// and wrenches are at the tool's point, in the axes of the base.
///
/// Nothing here allocates or throws but the constructor; a joint that is no number gives a pose
/// that is none.
class IiwaKinematics {
 public:
  /// A tool's pose, and the 6×7 geometric Jacobian J there.
  struct State {
    Pose tool;
    IiwaJacobian jacobian = IiwaJacobian::Zero();
  };

  /// @param tool  as seen from the flange, whose z points away from the arm; the default is the
  ///              flange itself.
  /// @throws std::invalid_argument  if the tool is not finite, or its rotation is no rotation (to
  /// 1e-6).
  explicit IiwaKinematics(IiwaModel model, const Pose& tool = {});

  /// The flange as seen from the base, joints @p q [rad].
  Pose flange(const JointVector& q) const noexcept;

  /// The tool as seen from the base, joints @p q [rad].
  Pose tool(const JointVector& q) const noexcept { return flange(q) * tool_; }

  /// Pose and Jacobian together, for less than both apart. @p q [rad].
  State at(const JointVector& q) const noexcept;

  IiwaJacobian jacobian(const JointVector& q) const noexcept { return at(q).jacobian; }

  /// How the tool moves, J q̇. @p q [rad], @p velocity [rad/s].
  Twist twist(const JointVector& q, const JointVector& velocity) const noexcept;

  /// What joints have to give to exert @p wrench on the world, or take where the world exerts it on
  /// the tool: Jᵀ w [N·m]. @p q [rad].
  JointVector torque(const JointVector& q, const Wrench& wrench) const noexcept;

  IiwaModel model() const noexcept { return model_; }
  const IiwaProperties& properties() const noexcept { return propertiesOf(model_); }

 private:
  IiwaModel model_;
  Pose tool_;
  std::array<double, 7> lengths_;  ///< d of each link [m]
};

}  // namespace haptics::devices

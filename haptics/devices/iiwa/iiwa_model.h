#pragma once

#include <array>
#include <cstdint>

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

}  // namespace haptics::devices

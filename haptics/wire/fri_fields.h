#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <type_traits>

#include "haptics/wire/fri_message.h"

/// The table of all fields, for decoding, validating and encoding: number and member of every
/// field, in ascending order, and the versions that have it. Only for the codec's own sources; all
/// others include fri_codec.h.
namespace haptics::wire::fri {

/// Length field in the frame of 2.7 [bytes]; the CRC has the same size.
inline constexpr std::size_t kLengthSize = 4;
inline constexpr std::size_t kFrameSize = 2 * kLengthSize;  ///< [bytes]

/// The first and the last version that have a field.
struct Versions {
  Version since = Version::V1_11;
  Version until = Version::V2_7;
};
inline constexpr Versions kAllVersions{};
inline constexpr Versions kSince1_14{.since = Version::V1_14};
inline constexpr Versions kUntil1_16{.until = Version::V1_16};
inline constexpr Versions kSince2_5{.since = Version::V2_5};
inline constexpr Versions kSince2_7{.since = Version::V2_7};
inline constexpr Versions kUntil2_5{.until = Version::V2_5};

constexpr bool isInVersions(Version version, Versions versions) noexcept {
  return version >= versions.since && version <= versions.until;
}

constexpr std::size_t mostElements(Version version) noexcept {
  return isInVersions(version, kSince2_5) ? 7 : 12;
}

template <typename T, typename Wanted>
concept Is = std::same_as<std::remove_const_t<T>, Wanted>;

// visit() calls `field(number, value, versions)` for every field. A field that is neither optional
// nor a list is required.

void visit(Is<Header> auto& m, auto& field) noexcept {
  field(1, m.identifier, kAllVersions);
  field(2, m.sequence, kAllVersions);
  field(3, m.reflected, kAllVersions);
}

void visit(Is<TimeStamp> auto& m, auto& field) noexcept {
  field(1, m.seconds, kAllVersions);
  field(2, m.nanoseconds, kAllVersions);
}

void visit(Is<Transformation> auto& m, auto& field) noexcept {
  field(1, m.name, kAllVersions);
  field(2, m.elements, kAllVersions);
  field(3, m.timestamp, kAllVersions);
}

void visit(Is<IoValue> auto& m, auto& field) noexcept {
  field(1, m.name, kAllVersions);
  field(2, m.type, kAllVersions);
  field(3, m.direction, kAllVersions);
  field(4, m.digital, kAllVersions);
  field(5, m.analog, kAllVersions);
}

void visit(Is<Redundancy> auto& m, auto& field) noexcept {
  field(1, m.strategy, kAllVersions);
  field(2, m.value, kAllVersions);
}

void visit(Is<ConnectionInfo> auto& m, auto& field) noexcept {
  field(1, m.state, kAllVersions);
  field(2, m.quality, kAllVersions);
  field(3, m.sendPeriod, kAllVersions);
  field(4, m.receiveMultiplier, kAllVersions);
}

void visit(Is<RobotInfo> auto& m, auto& field) noexcept {
  field(1, m.jointCount, kAllVersions);
  field(2, m.safetyState, kAllVersions);
  field(5, m.driveStates, kAllVersions);
  field(6, m.operationMode, kAllVersions);
  field(7, m.controlMode, kAllVersions);
}

void visit(Is<MonitorData> auto& m, auto& field) noexcept {
  field(1, m.measuredPosition, kAllVersions);
  field(2, m.measuredTorque, kAllVersions);
  field(3, m.commandedPosition, kUntil1_16);
  field(4, m.commandedTorque, kAllVersions);
  field(5, m.externalTorque, kAllVersions);
  field(6, m.externalForce, kSince2_7);
  field(8, m.inputs, kSince1_14);
  field(9, m.pose, kSince2_5);
  field(10, m.redundancy, kSince2_5);
  field(15, m.timestamp, kAllVersions);
}

void visit(Is<IpoData> auto& m, auto& field) noexcept {
  field(1, m.jointPosition, kAllVersions);
  field(2, m.pose, kSince2_5);
  field(3, m.redundancy, kSince2_5);
  field(10, m.commandMode, kAllVersions);
  field(11, m.overlay, kAllVersions);
  field(12, m.trackingPerformance, kAllVersions);
}

void visit(Is<CommandData> auto& m, auto& field) noexcept {
  field(1, m.jointPosition, kAllVersions);
  field(2, m.wrench, kAllVersions);
  field(3, m.jointTorque, kAllVersions);
  field(4, m.transformations, kAllVersions);
  field(5, m.outputs, kSince1_14);
  field(6, m.pose, kSince2_5);
  field(7, m.redundancy, kSince2_5);
}

void visit(Is<EndOfMessage::Checksum> auto& m, auto& field) noexcept {
  field(1, m.crc32, kAllVersions);
}

void visit(Is<EndOfMessage> auto& m, auto& field) noexcept {
  field(1, m.length, kAllVersions);
  field(2, m.checksum, kAllVersions);
}

void visit(Is<MonitoringMessage> auto& m, auto& field) noexcept {
  field(1, m.header, kAllVersions);
  field(2, m.robotInfo, kAllVersions);
  field(3, m.monitorData, kAllVersions);
  field(4, m.connection, kAllVersions);
  field(5, m.ipoData, kAllVersions);
  field(6, m.requestedTransformations, kAllVersions);
  field(15, m.endOfMessage, kUntil2_5);
}

void visit(Is<CommandMessage> auto& m, auto& field) noexcept {
  field(1, m.header, kAllVersions);
  field(2, m.data, kAllVersions);
  field(15, m.endOfMessage, kUntil2_5);
}

template <typename T>
concept Number = std::same_as<T, std::uint32_t> || std::same_as<T, std::int32_t> ||
    std::same_as<T, std::uint64_t>;
template <typename T>
concept Choice = std::is_enum_v<T>;
template <typename T>
// Overloads for joints, vectors, names and lists are more specialised.
concept Message = std::is_class_v<T>;

constexpr bool isKnown(RedundancyStrategy value) noexcept {
  return value == RedundancyStrategy::E1 || value == RedundancyStrategy::None;
}

/// The last value of every enumeration that has no gaps.
inline constexpr std::tuple kLastEnumerators{
    SessionState::CommandingActive,
    ConnectionQuality::Excellent,
    SafetyState::StopLevel2,
    OperationMode::Automatic,
    DriveState::Active,
    ControlMode::NoControl,
    ClientCommandMode::CartesianPose,
    OverlayType::Cartesian,
    IoType::Analog,
    IoDirection::Output};

template <Choice T>
constexpr bool isKnown(T value) noexcept {
  return value <= std::get<T>(kLastEnumerators);
}

}  // namespace haptics::wire::fri

#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
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
inline constexpr Versions kAlways{};
inline constexpr Versions kSince1_14{.since = Version::V1_14};
inline constexpr Versions kUntil1_16{.until = Version::V1_16};
inline constexpr Versions kSince2_5{.since = Version::V2_5};
inline constexpr Versions kSince2_7{.since = Version::V2_7};
inline constexpr Versions kUntil2_5{.until = Version::V2_5};

constexpr bool knows(Version version, Versions versions) noexcept {
  return version >= versions.since && version <= versions.until;
}

constexpr std::size_t mostElements(Version version) noexcept {
  return knows(version, kSince2_5) ? 7 : 12;
}

template <typename T, typename Wanted>
concept Is = std::same_as<std::remove_const_t<T>, Wanted>;

// visit() calls `field(number, value, versions)` for every field. A field that is neither optional
// nor a list is required.

void visit(Is<Header> auto& m, auto& field) noexcept {
  field(1, m.identifier, kAlways);
  field(2, m.sequence, kAlways);
  field(3, m.reflected, kAlways);
}

void visit(Is<TimeStamp> auto& m, auto& field) noexcept {
  field(1, m.seconds, kAlways);
  field(2, m.nanoseconds, kAlways);
}

void visit(Is<Transformation> auto& m, auto& field) noexcept {
  field(1, m.name, kAlways);
  field(2, m.elements, kAlways);
  field(3, m.timestamp, kAlways);
}

void visit(Is<IoValue> auto& m, auto& field) noexcept {
  field(1, m.name, kAlways);
  field(2, m.type, kAlways);
  field(3, m.direction, kAlways);
  field(4, m.digital, kAlways);
  field(5, m.analog, kAlways);
}

void visit(Is<Redundancy> auto& m, auto& field) noexcept {
  field(1, m.strategy, kAlways);
  field(2, m.value, kAlways);
}

void visit(Is<ConnectionInfo> auto& m, auto& field) noexcept {
  field(1, m.state, kAlways);
  field(2, m.quality, kAlways);
  field(3, m.sendPeriod, kAlways);
  field(4, m.receiveMultiplier, kAlways);
}

void visit(Is<RobotInfo> auto& m, auto& field) noexcept {
  field(1, m.jointCount, kAlways);
  field(2, m.safetyState, kAlways);
  field(5, m.driveStates, kAlways);
  field(6, m.operationMode, kAlways);
  field(7, m.controlMode, kAlways);
}

void visit(Is<MonitorData> auto& m, auto& field) noexcept {
  field(1, m.measuredPosition, kAlways);
  field(2, m.measuredTorque, kAlways);
  field(3, m.commandedPosition, kUntil1_16);
  field(4, m.commandedTorque, kAlways);
  field(5, m.externalTorque, kAlways);
  field(6, m.externalForce, kSince2_7);
  field(8, m.inputs, kSince1_14);
  field(9, m.pose, kSince2_5);
  field(10, m.redundancy, kSince2_5);
  field(15, m.timestamp, kAlways);
}

void visit(Is<IpoData> auto& m, auto& field) noexcept {
  field(1, m.jointPosition, kAlways);
  field(2, m.pose, kSince2_5);
  field(3, m.redundancy, kSince2_5);
  field(10, m.commandMode, kAlways);
  field(11, m.overlay, kAlways);
  field(12, m.trackingPerformance, kAlways);
}

void visit(Is<CommandData> auto& m, auto& field) noexcept {
  field(1, m.jointPosition, kAlways);
  field(2, m.wrench, kAlways);
  field(3, m.jointTorque, kAlways);
  field(4, m.transformations, kAlways);
  field(5, m.outputs, kSince1_14);
  field(6, m.pose, kSince2_5);
  field(7, m.redundancy, kSince2_5);
}

void visit(Is<EndOfMessage::Checksum> auto& m, auto& field) noexcept {
  field(1, m.crc32, kAlways);
}

void visit(Is<EndOfMessage> auto& m, auto& field) noexcept {
  field(1, m.length, kAlways);
  field(2, m.checksum, kAlways);
}

void visit(Is<MonitoringMessage> auto& m, auto& field) noexcept {
  field(1, m.header, kAlways);
  field(2, m.robotInfo, kAlways);
  field(3, m.monitorData, kAlways);
  field(4, m.connection, kAlways);
  field(5, m.ipoData, kAlways);
  field(6, m.requestedTransformations, kAlways);
  field(15, m.endOfMessage, kUntil2_5);
}

void visit(Is<CommandMessage> auto& m, auto& field) noexcept {
  field(1, m.header, kAlways);
  field(2, m.data, kAlways);
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

// The last value of every enumeration that has no gaps.
constexpr SessionState lastOf(SessionState) noexcept {
  return SessionState::CommandingActive;
}
constexpr ConnectionQuality lastOf(ConnectionQuality) noexcept {
  return ConnectionQuality::Excellent;
}
constexpr SafetyState lastOf(SafetyState) noexcept {
  return SafetyState::StopLevel2;
}
constexpr OperationMode lastOf(OperationMode) noexcept {
  return OperationMode::Automatic;
}
constexpr DriveState lastOf(DriveState) noexcept {
  return DriveState::Active;
}
constexpr ControlMode lastOf(ControlMode) noexcept {
  return ControlMode::NoControl;
}
constexpr ClientCommandMode lastOf(ClientCommandMode) noexcept {
  return ClientCommandMode::CartesianPose;
}
constexpr OverlayType lastOf(OverlayType) noexcept {
  return OverlayType::Cartesian;
}
constexpr IoType lastOf(IoType) noexcept {
  return IoType::Analog;
}
constexpr IoDirection lastOf(IoDirection) noexcept {
  return IoDirection::Output;
}

template <Choice T>
constexpr bool isKnown(T value) noexcept {
  return value <= lastOf(value);
}

}  // namespace haptics::wire::fri

#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "haptics/wire/crc32.h"
#include "haptics/wire/fri_codec.h"

/// Datagrams as bytes, and messages of which the tests of the codec make them.
namespace haptics::wire::fri::fri_datagrams {

using Bytes = std::vector<std::uint8_t>;

inline constexpr Joints kJoints{0.1, 0.2, 0.3, -1.0, 0.4, 0.5, 0.6};

/// The bytes that are written as hexadecimal digits.
inline Bytes bytesOf(const std::string& hex) {
  Bytes bytes;
  for (std::size_t i = 0; i < hex.size(); i += 2) {
    bytes.push_back(static_cast<std::uint8_t>(std::stoul(hex.substr(i, 2), nullptr, 16)));
  }
  return bytes;
}

template <typename Message>
Bytes encoded(const Message& message, Version version) {
  std::array<std::uint8_t, kLargestDatagram> out{};
  const std::size_t size = encode(message, version, out);
  return {out.begin(), out.begin() + static_cast<std::ptrdiff_t>(size)};
}

/// What is to be sent inside a frame of 2.7.
inline Bytes framed(const Bytes& inside) {
  Bytes bytes;
  const auto add = [&](std::uint32_t word) {
    for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<std::uint8_t>(word >> (8 * i)));
  };
  add(static_cast<std::uint32_t>(inside.size()));
  bytes.insert(bytes.end(), inside.begin(), inside.end());
  add(crc32(inside.data(), inside.size()));
  return bytes;
}

/// As much as a message can hold in practice.
inline MonitoringMessage full() {
  MonitoringMessage message{.header = {kMonitoring, 600, 598}};
  message.robotInfo = RobotInfo{7, SafetyState::NormalOperation, {}, OperationMode::Automatic, {}};
  for (int i = 0; i < 7; ++i) *message.robotInfo->driveStates.add() = DriveState::Active;
  Transformation pose{.name = Name("Tool"), .timestamp = TimeStamp{1700000000, 1}};
  for (const double element : {0.5, 0.0, 0.6, 1.0, 0.0, 0.0, 0.0}) *pose.elements.add() = element;
  MonitorData data{.measuredPosition = kJoints, .commandedPosition = kJoints};
  data.externalForce = Vector6{1, 2, 3, 4, 5, 6};
  *data.inputs.add() = {Name("Pedal"), IoType::Boolean, IoDirection::Input, 1, {}};
  data.pose = pose;
  data.redundancy = Redundancy{RedundancyStrategy::None, 0.25};
  message.monitorData = data;
  message.connection =
      ConnectionInfo{SessionState::CommandingActive, ConnectionQuality::Good, 1, 1};
  message.ipoData = IpoData{kJoints, pose, data.redundancy, ClientCommandMode::CartesianPose};
  *message.requestedTransformations.add() = pose;
  message.endOfMessage = EndOfMessage{-1, EndOfMessage::Checksum{-2}};
  return message;
}

}  // namespace haptics::wire::fri::fri_datagrams

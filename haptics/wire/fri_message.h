#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

/// The messages between a robot controller and its client over KUKA's Fast Robot Interface.
///
/// Plain values without heap. Written from the facts of the wire format, with names that Palpate
/// chose.
namespace haptics::wire::fri {

inline constexpr std::size_t kLargestDatagram = 1500;   ///< [bytes], in either direction
inline constexpr std::uint32_t kMonitoring = 0x245142;  ///< identifier: controller to client
inline constexpr std::uint32_t kCommand = 0x34001;      ///< identifier: client to controller

/// The version of FRI. Messages do not contain it, so the user chooses it.
enum class Version : std::uint8_t { V1_11, V1_14, V1_15, V1_16, V2_5, V2_7 };

inline constexpr std::array<std::string_view, 6> kVersionNames{
    "1.11", "1.14", "1.15", "1.16", "2.5", "2.7"};

constexpr std::string_view nameOf(Version version) noexcept {
  return kVersionNames[static_cast<std::size_t>(version)];
}

/// The version named "1.11", "1.14", "1.15", "1.16", "2.5" or "2.7"; std::nullopt for other names.
constexpr std::optional<Version> versionNamed(std::string_view name) noexcept {
  for (std::size_t i = 0; i < kVersionNames.size(); ++i) {
    if (kVersionNames[i] == name) return static_cast<Version>(i);
  }
  return std::nullopt;
}

// Enumerators have the values of the wire format.
enum class SessionState : std::uint8_t {
  Idle,
  MonitoringWait,
  MonitoringReady,
  CommandingWait,
  CommandingActive
};
enum class ConnectionQuality : std::uint8_t { Poor, Fair, Good, Excellent };
enum class SafetyState : std::uint8_t { NormalOperation, StopLevel0, StopLevel1, StopLevel2 };
enum class OperationMode : std::uint8_t { Test1, Test2, Automatic };
enum class DriveState : std::uint8_t { Off, Transitioning, Active };
enum class ControlMode : std::uint8_t { Position, CartesianImpedance, JointImpedance, NoControl };
enum class ClientCommandMode : std::uint8_t {
  NoCommand,
  JointPosition,
  Wrench,
  Torque,
  CartesianPose  ///< 2.x
};
enum class OverlayType : std::uint8_t { NoOverlay, Joint, Cartesian };
enum class IoType : std::uint8_t { Boolean, Digital, Analog };
enum class IoDirection : std::uint8_t { Input, Output };
enum class RedundancyStrategy : std::uint8_t { E1 = 0, None = 4 };

using Joints = std::array<double, 7>;   ///< A1 to A7, [rad] or [N m]
using Vector6 = std::array<double, 6>;  ///< Fx Fy Fz [N], torques about A B C [N m]

/// An array of up to N values.
template <typename T, std::size_t N>
struct BoundedArray {
  std::array<T, N> items{};
  std::size_t count = 0;  ///< at most N

  static constexpr std::size_t kCapacity = N;
  constexpr const T* begin() const noexcept { return items.data(); }
  constexpr const T* end() const noexcept { return items.data() + std::min(count, N); }

  /// Appends a default value and returns it; nullptr if the array is full.
  constexpr T* add() noexcept {
    if (count >= N) return nullptr;
    items[count] = T{};
    return &items[count++];
  }

  friend constexpr bool operator==(const BoundedArray& a, const BoundedArray& b) noexcept {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
  }
};

/// A name of up to 63 bytes, as received: not necessarily UTF-8.
struct Name {
  std::array<char, 63> bytes{};
  std::size_t size = 0;  ///< at most 63

  constexpr Name() noexcept = default;
  /// Truncates longer names.
  constexpr explicit Name(std::string_view text) noexcept
      : size(std::min(text.size(), bytes.size())) {
    std::copy_n(text.begin(), size, bytes.begin());
  }
  constexpr std::string_view text() const noexcept {
    return {bytes.data(), std::min(size, bytes.size())};
  }
  friend constexpr bool operator==(const Name& a, const Name& b) noexcept {
    return a.text() == b.text();
  }
};

struct Header {
  std::uint32_t identifier = 0;  ///< kMonitoring or kCommand
  std::uint32_t sequence = 0;    ///< the sender's counter, from 0
  std::uint32_t reflected = 0;   ///< the last counter received from the other side
  friend bool operator==(const Header&, const Header&) = default;
};

struct TimeStamp {
  std::uint32_t seconds = 0;  ///< Unix time [s]
  std::uint32_t nanoseconds = 0;
  friend bool operator==(const TimeStamp&, const TimeStamp&) = default;
};

/// 1.x: a 3 x 4 matrix, 12 elements. 2.x: 7 elements, x y z [mm] qw qx qy qz. A message may have
/// fewer elements.
struct Transformation {
  Name name;
  BoundedArray<double, 12> elements;
  std::optional<TimeStamp> timestamp;
  friend bool operator==(const Transformation&, const Transformation&) = default;
};

/// An input or output; since 1.14.
struct IoValue {
  Name name;
  IoType type = IoType::Boolean;
  IoDirection direction = IoDirection::Input;
  std::optional<std::uint64_t> digital;
  std::optional<double> analog;
  friend bool operator==(const IoValue&, const IoValue&) = default;
};

/// Position of the elbow (redundancy of the 7 joints); 2.x.
struct Redundancy {
  RedundancyStrategy strategy = RedundancyStrategy::E1;
  double value = 0.0;  ///< parameter of the strategy; the wire format states no unit
  friend bool operator==(const Redundancy&, const Redundancy&) = default;
};

struct ConnectionInfo {
  SessionState state = SessionState::Idle;
  ConnectionQuality quality = ConnectionQuality::Poor;
  std::optional<std::uint32_t> sendPeriod;         ///< [ms]
  std::optional<std::uint32_t> receiveMultiplier;  ///< the client answers every k-th message
  friend bool operator==(const ConnectionInfo&, const ConnectionInfo&) = default;
};

struct RobotInfo {
  std::optional<std::int32_t> jointCount;
  std::optional<SafetyState> safetyState;
  BoundedArray<DriveState, 7> driveStates;
  std::optional<OperationMode> operationMode;
  std::optional<ControlMode> controlMode;
  friend bool operator==(const RobotInfo&, const RobotInfo&) = default;
};

/// Measured values.
struct MonitorData {
  std::optional<Joints> measuredPosition;   ///< [rad]
  std::optional<Joints> measuredTorque;     ///< [N m]
  std::optional<Joints> commandedPosition;  ///< [rad], 1.x only
  std::optional<Joints> commandedTorque;    ///< [N m]
  std::optional<Joints> externalTorque;     ///< [N m]
  std::optional<Vector6> externalForce;     ///< 2.7 only
  BoundedArray<IoValue, 10> inputs;         ///< since 1.14
  std::optional<Transformation> pose;       ///< 2.x
  std::optional<Redundancy> redundancy;     ///< 2.x
  std::optional<TimeStamp> timestamp;
  friend bool operator==(const MonitorData&, const MonitorData&) = default;
};

/// State of the controller's interpolator.
struct IpoData {
  std::optional<Joints> jointPosition;   ///< [rad]; present in the commanding states
  std::optional<Transformation> pose;    ///< 2.x
  std::optional<Redundancy> redundancy;  ///< 2.x
  std::optional<ClientCommandMode> commandMode;
  std::optional<OverlayType> overlay;
  std::optional<double> trackingPerformance;  ///< [0, 1]; 0 outside CommandingActive
  friend bool operator==(const IpoData&, const IpoData&) = default;
};

/// Commands to the arm.
struct CommandData {
  std::optional<Joints> jointPosition;  ///< [rad]
  std::optional<Vector6> wrench;
  std::optional<Joints> jointTorque;  ///< [N m]
  BoundedArray<Transformation, 5> transformations;
  BoundedArray<IoValue, 10> outputs;     ///< since 1.14
  std::optional<Transformation> pose;    ///< 2.x
  std::optional<Redundancy> redundancy;  ///< 2.x
  friend bool operator==(const CommandData&, const CommandData&) = default;
};

/// An optional trailer with length and checksum. Not used in practice and not checked; absent in
/// 2.7.
struct EndOfMessage {
  struct Checksum {
    std::optional<std::int32_t> crc32;
    friend bool operator==(const Checksum&, const Checksum&) = default;
  };
  std::optional<std::int32_t> length;
  std::optional<Checksum> checksum;
  friend bool operator==(const EndOfMessage&, const EndOfMessage&) = default;
};

/// Controller to client.
struct MonitoringMessage {
  Header header{.identifier = kMonitoring};
  std::optional<RobotInfo> robotInfo;
  std::optional<MonitorData> monitorData;
  std::optional<ConnectionInfo> connection;  ///< if missing, the state is Idle
  std::optional<IpoData> ipoData;
  BoundedArray<Transformation, 5> requestedTransformations;
  std::optional<EndOfMessage> endOfMessage;
  friend bool operator==(const MonitoringMessage&, const MonitoringMessage&) = default;
};

/// Client to controller.
struct CommandMessage {
  Header header{.identifier = kCommand};
  std::optional<CommandData> data;
  std::optional<EndOfMessage> endOfMessage;
  friend bool operator==(const CommandMessage&, const CommandMessage&) = default;
};

}  // namespace haptics::wire::fri

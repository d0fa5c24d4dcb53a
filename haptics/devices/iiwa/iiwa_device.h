#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "haptics/devices/datagram_socket.h"
#include "haptics/devices/iiwa/iiwa_guard.h"
#include "haptics/devices/iiwa/iiwa_kinematics.h"
#include "haptics/devices/wire_device.h"
#include "haptics/wire/fri_codec.h"
#include "haptics/wire/sequence_check.h"

namespace haptics::devices {

/// The FRI command that carries a force.
enum class IiwaOverlay : std::uint8_t {
  CartesianWrench,  ///< at the tool, under Cartesian impedance control
  JointTorque,      ///< in the joints, under joint impedance control
};

/// The frame in which the robot reads a commanded wrench. It follows from the motion centre that is
/// set in the robot's program.
enum class WrenchFrame : std::uint8_t { Tool, Base };

/// How an arm is connected, and its tool.
struct IiwaSettings {
  std::string robot =
      "127.0.0.1";  ///< the controller's address; datagrams from other addresses are ignored
  std::uint16_t port = 30200;  ///< port of this computer; 30200 to 30209 for a robot
  wire::fri::Version version = wire::fri::Version::V1_15;
  IiwaModel model = IiwaModel::Iiwa14;
  IiwaOverlay overlay = IiwaOverlay::CartesianWrench;
  WrenchFrame wrenchFrame = WrenchFrame::Tool;
  Pose tool;  ///< of the reamer, as seen from the flange
  /// Direction of reaming in the base frame; travel is positive along this direction.
  Eigen::Vector3d axis{0.0, 0.0, -1.0};
  /// Joint angles [rad] at which travel is 0; std::nullopt: the pose at arm()
  std::optional<wire::fri::Joints> zero;
  double largestTravel = 0.02;  ///< [m]
  double maxForce = 140.0;      ///< [N]
  double maxTorque = 10.0;      ///< about the axis [N·m]; 0: no torque is rendered
  double damping = 60.0;        ///< of the arm along the axis [N·s/m]
  /// Name of the robot's boolean input that the reamer's pedal sets; empty: there is no pedal, and
  /// the reamer is on. The reamer is off while a message lacks that input (FRI before 1.14).
  std::string pedal;
  IiwaGuard::Margins margins;
};

/// A KUKA LBR iiwa over FRI (docs/fri.md), paced by the robot's controller: it sends a message per
/// cycle, and this class answers every n-th, with n the session's receive multiplier. Travel is the
/// tool's displacement along the axis of reaming; a torque is about that axis, at the tool.
///
/// Messages are sent to the robot's address only. Messages from other addresses are ignored, and so
/// are damaged, duplicate, late and non-finite messages. Forces are sent in COMMANDING_ACTIVE only,
/// and only while the connection is GOOD or better. A robot that receives no answer switches its
/// force off, so this class only ever sends answers to messages. After 20 missed cycles, or 50 ms
/// if that is less, the device is faulted until open().
class IiwaDevice final : public WireDevice {
 public:
  /// @throws DeviceError  if the settings are not valid.
  explicit IiwaDevice(IiwaSettings settings);
  ~IiwaDevice() override;

  void open() override;
  std::vector<CheckResult> check(double seconds) override;
  DeviceSample read(double dt) noexcept override;
  void command(double force, double torque) noexcept override;

 private:
  using SessionState = wire::fri::SessionState;

  std::string place() const override { return settings_.robot; }
  bool isConnected() const noexcept override { return socket_.has_value(); }
  /// Sends nothing: a robot that receives no answer switches its force off.
  void disconnect(bool /*isFault*/) noexcept override { socket_.reset(); }
  bool waitForMessage(std::int64_t deadline) noexcept override;
  void keepAlive() noexcept override { answer(0.0, 0.0); }
  void awaitReadiness() override;
  void beginForces() noexcept override;
  bool take(const DatagramSocket::Received& received, std::int64_t at) noexcept;
  void updateMotion(std::int64_t at) noexcept;
  void answer(double force, double torque) noexcept;
  void writeOverlay(wire::fri::CommandData& data, double force, double torque) noexcept;
  DeviceFault reasonToEndTrial() const noexcept;
  bool isReamerOn() const noexcept;
  /// Measurements during a check that LinkReport lacks.
  struct ListenResult {
    double seconds = 0.0;                              ///< duration of the measurement
    std::int64_t longestGap = 0;                       ///< between messages [ns]
    bool hasWaited = false;                            ///< the session has been in COMMANDING_WAIT
    std::optional<wire::fri::ClientCommandMode> mode;  ///< as the robot reported it
  };
  ListenResult listen(double seconds);
  base::Message describeSilence() const;
  void awaitMessages();
  std::int64_t longestSilence() const noexcept;
  SessionState state() const noexcept;

  IiwaSettings settings_;
  IiwaKinematics kinematics_;
  IiwaGuard guard_;
  Endpoint robot_;
  std::optional<DatagramSocket> socket_;
  std::array<std::uint8_t, wire::fri::kLargestDatagram + 1> receiveBuffer_{};

  wire::fri::MonitoringMessage lastMessage_;
  wire::SequenceCheck<std::uint32_t> sequence_;
  std::uint32_t answerSequence_ = 0;       // counter of the next answer
  std::uint32_t messagesSinceAnswer_ = 0;  // messages since the last answer
  std::int64_t period_ = 5'000'000;        // between messages [ns]
  Endpoint lastForeignSender_;             // the last sender that was not the robot
  std::int64_t lastGoodAt_ = 0;            // when the connection was last good enough [ns]

  JointVector joints_ = JointVector::Zero();         // [rad]
  JointVector jointVelocity_ = JointVector::Zero();  // [rad/s]
  Pose tool_;
  IiwaJacobian jacobian_ = IiwaJacobian::Zero();
  std::optional<Pose> start_;
  double travel_ = 0.0;    // [m]
  double velocity_ = 0.0;  // [m/s]
  double turn_ = 0.0;      // [rad]

  std::uint32_t lastReflected_ = 0;  // counter of our last command that the robot has reflected
};

}  // namespace haptics::devices

#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "haptics/devices/punch/punch_kind.h"
#include "haptics/devices/serial_port.h"
#include "haptics/devices/wire_device.h"
#include "haptics/engine/scene_spec.h"
#include "haptics/timing/monotonic_clock.h"
#include "haptics/wire/punch_codec.h"
#include "haptics/wire/sequence_check.h"

namespace haptics::devices {

/// Connection and calibration of a device on a serial line.
struct PunchSettings {
  const DeviceKind* kind = &punchKind();
  std::string port;
  int baud = 0;  ///< 0: USB
  /// Expected serial number of the board; std::nullopt: any board.
  std::optional<std::uint32_t> serial;
  /// Expected build of the firmware; std::nullopt: kFirmwareBuild.
  std::optional<std::uint64_t> build;
  /// [travel units]; negative if the count falls while closing.
  double travelPerCount = kind->serial.travelPerCount;
  double travelAtZero = 0.0;      ///< travel at count 0 [travel units]
  double newtonsPerVolt = 0.667;  ///< measured at the handle; the same in every condition
  double maxVoltage = 12.0;       ///< largest voltage on the motor [V]
  int expiry = 10;                ///< time without a command until the device switches its force
                                  ///< off [ms], 1 to 20
  double damping = kind->mechanism.damping;  ///< of the mechanism [N·s/travel unit]
};

/// The punch, or another kind of device with the same protocol, on a serial line
/// (docs/punch-protocol.md). The device's telemetry paces the loop.
///
/// More than 50 ms without a message are a fault.
class PunchDevice final : public WireDevice {
 public:
  explicit PunchDevice(PunchSettings settings);
  ~PunchDevice() override;

  void open() override;
  std::vector<CheckResult> check(double seconds) override;
  DeviceSample read(double dt) noexcept override;
  void command(double force, double torque) noexcept override;

  /// Makes the device compute the forces of @p scene itself from the next arm() on; command() is
  /// then only a sign of life of the host. Sends the scene's parameters, which the device confirms
  /// by their hash.
  /// @throws DeviceError  if the device cannot render the scene: it supports no opening branches,
  ///                      no smoothing, no stiffnesses per element and at most 128 points; or if it
  ///                      is not connected, does not answer, or does not confirm the scene.
  void renderOnDevice(const engine::SceneSpec& scene, double largestForce);

 private:
  std::string place() const override { return settings_.port; }
  bool isConnected() const noexcept override { return port_.isOpen(); }
  void disconnect(bool isFault) noexcept override;
  bool waitForMessage(std::int64_t deadline) noexcept override;
  void keepAlive() noexcept override;
  void beginForces() noexcept override;
  void stopForces() noexcept override;
  bool drain() noexcept;
  void take(const wire::punch::Frame& frame, std::int64_t at) noexcept;
  void handleState(const wire::punch::Frame& frame, std::int64_t at) noexcept;
  void exchangeHello();
  void requireExpectedBoard() const;
  wire::punch::ModelReply awaitModelReply(std::int64_t deadline);
  template <typename Message>
  void send(const Message& message) noexcept {
    std::array<std::uint8_t, wire::punch::kLargestOnWire> bytes{};
    const std::int64_t at = timing::now();
    const std::uint16_t sequence = nextSequence_++;
    const auto time = static_cast<std::uint32_t>(at / timing::kMicrosecond);
    const std::size_t count = wire::punch::encode(message, sequence, time, bytes.data());
    sentAt_[sequence % sentAt_.size()] = at;
    longestPause_ = std::max(longestPause_, at - std::exchange(lastSentAt_, at));
    if (!port_.write({bytes.data(), count}) && port_.isOpen()) ++report_.unsent;
  }
  std::uint8_t relevantFaults() const noexcept;
  double travel() const noexcept {
    return settings_.travelAtZero + settings_.travelPerCount * state_.counts;
  }
  void countLeap(double before, double seconds) noexcept;

  PunchSettings settings_;
  SerialPort port_;
  wire::punch::FrameDecoder decoder_;
  wire::punch::Hello hello_;
  bool hasHello_ = false;
  int helloCount_ = 0;  ///< number of Hello messages received
  std::optional<wire::punch::ModelReply>
      lastModelReply_;  ///< last reply to the parameters of a scene
  /// Hash of the scene that the device renders itself; std::nullopt: it renders commanded forces.
  std::optional<std::uint32_t> sceneHash_;

  wire::SequenceCheck<std::uint16_t> sequence_;
  wire::punch::State state_;
  std::int64_t armedAt_ = 0;          // [ns]
  std::uint32_t damagedBefore_ = 0;   // damaged frames when counting began
  std::uint32_t damagedAtState_ = 0;  // damaged frames at the last State message
  std::int64_t lastSentAt_ = 0;       // [ns]
  std::int64_t longestPause_ = 0;     // between messages to the device since forces began [ns]
  bool hasTravel_ = false;            // a State message arrived since forces began

  std::uint16_t nextSequence_ = 0;
  std::uint16_t lastEcho_ = 0;  // last sequence number of the host that the device acknowledged
};

}  // namespace haptics::devices

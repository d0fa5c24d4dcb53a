#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "haptics/devices/punch/punch_kind.h"
#include "haptics/devices/serial_port.h"
#include "haptics/devices/wire_device.h"
#include "haptics/engine/scene_spec.h"
#include "haptics/timing/monotonic_clock.h"
#include "haptics/wire/punch_codec.h"
#include "haptics/wire/sequence_check.h"

namespace haptics::devices {

/// How a device on a serial line is connected, and what its numbers mean.
struct PunchSettings {
  const DeviceKind* kind = &punchKind();
  std::string port;
  int baud = 0;                         ///< 0: USB
  std::optional<std::uint32_t> serial;  ///< of the board that is meant
  std::optional<std::uint64_t> build;   ///< of the firmware; nothing: the one of this program
  double travelPerCount =
      kind->serial.travelPerCount;  ///< [travel units]; negative where closing counts down
  double travelAtZero = 0.0;        ///< at count 0 [travel units]
  double newtonsPerVolt = 0.667;    ///< at the handle, measured; the same for every condition
  double maxVoltage = 12.0;         ///< on the motor [V]
  int expiry = 10;                  ///< time without a command until the device switches its force
                                    ///< off [ms], 1 to 20
  double damping = kind->mechanism.damping;  ///< of the mechanism [N·s/travel unit]
};

/// The punch on its serial line (docs/punch-protocol.md), paced by its telemetry; or another kind
/// of device with the same protocol.
///
/// More than 50 ms of silence are a fault.
class PunchDevice final : public WireDevice {
 public:
  explicit PunchDevice(PunchSettings settings);
  ~PunchDevice() override;

  void open() override;
  std::vector<CheckResult> check(double seconds) override;
  DeviceSample read(double dt) noexcept override;
  void command(double force, double torque) noexcept override;

  /// Lets the device render @p scene by itself from the next arm() on; commanded forces then only
  /// keep it alive. Its parameters are sent, and the device confirms them by their hash.
  /// @throws DeviceError  if it cannot: opening branches, smoothing, single stiffnesses and more
  ///                      than 128 points stay with the host.
  void renderOnDevice(const engine::SceneSpec& scene, double largestForce);

 private:
  std::string name() const override {
    return "The " + std::string(settings_.kind->name) + " on " + settings_.port;
  }
  bool isConnected() const noexcept override { return port_.isOpen(); }
  void disconnect(bool isFault) noexcept override;
  bool waitForMessage(std::int64_t deadline) noexcept override;
  void keepAlive() noexcept override;
  void beginForces() noexcept override;
  void endForces() noexcept override;
  bool drain() noexcept;
  void take(const wire::punch::Frame& frame, std::int64_t at) noexcept;
  void takeState(const wire::punch::Frame& frame, std::int64_t at) noexcept;
  void exchangeHello();
  void refuseOtherBoard() const;
  wire::punch::ModelReply answerTo(std::int64_t deadline);
  template <typename Message>
  void send(const Message& message) noexcept {
    std::array<std::uint8_t, wire::punch::kLargestOnWire> bytes{};
    const std::int64_t at = timing::now();
    const std::uint16_t sequence = nextSequence_++;
    const auto time = static_cast<std::uint32_t>(at / timing::kMicrosecond);
    const std::size_t count = wire::punch::encode(message, sequence, time, bytes.data());
    sentAt_[sequence % sentAt_.size()] = at;
    if (!port_.write({bytes.data(), count}) && port_.isOpen()) ++report_.unsent;
  }
  std::uint8_t faultsThatCount() const noexcept;

  PunchSettings settings_;
  SerialPort port_;
  wire::punch::FrameDecoder decoder_;
  wire::punch::Hello hello_;
  bool isGreeted_ = false;
  int greetings_ = 0;  ///< number of Hello messages received
  std::optional<wire::punch::ModelReply> taken_;
  std::optional<std::uint32_t> sceneHash_;

  wire::SequenceCheck<std::uint16_t> sequence_;
  wire::punch::State state_;
  std::int64_t armedAt_ = 0;  // [ns]
  std::uint32_t damagedBefore_ = 0;

  std::uint16_t nextSequence_ = 0;
  std::uint16_t lastEcho_ = 0;
};

}  // namespace haptics::devices

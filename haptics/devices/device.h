#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "base/message.h"
#include "haptics/devices/device_kind.h"
#include "haptics/timing/clock_statistics.h"

namespace haptics::devices {

/// Sets the pace of a loop instead of a timer: a device that sends messages and expects answers.
class Pacer {
 public:
  virtual ~Pacer() = default;
  Pacer() = default;
  Pacer(const Pacer&) = delete;
  Pacer& operator=(const Pacer&) = delete;

  /// Waits for the next period, at most until @p deadline [ns on CLOCK_MONOTONIC]. Returns false if
  /// none began.
  virtual bool wait(std::int64_t deadline) noexcept = 0;
};

enum class Finding : std::uint8_t { Pass, Warn, Fail };

const char* nameOf(Finding finding) noexcept;

/// One result of the check of a device.
struct CheckResult {
  Finding finding = Finding::Pass;
  base::Message what;      ///< what was checked: "telemetry"
  base::Message measured;  ///< the result, with its unit
  base::Message fix{};     ///< how to correct it; empty for Pass
};

/// A result that passes, without @p fix, if @p isGood, and is @p otherwise if not.
CheckResult passIf(
    bool isGood, Finding otherwise, base::Message what, base::Message measured, base::Message fix);

/// A device cannot be used: which one, why, and what the operator can do. what() says it in
/// English.
class DeviceError : public std::runtime_error {
 public:
  explicit DeviceError(std::vector<base::Message> messages)
      : std::runtime_error(base::describe(messages)), messages_(std::move(messages)) {}
  explicit DeviceError(base::Message message) : DeviceError(std::vector{std::move(message)}) {}

  const std::vector<base::Message>& messages() const noexcept { return messages_; }

 private:
  std::vector<base::Message> messages_;
};

/// Statistics of a connection: messages received, lost and sent, and their timing.
struct LinkReport {
  bool hasLink = false;        ///< false for a simulated device: the other members are then unused
  std::uint64_t received = 0;  ///< messages that were used
  std::uint64_t lost = 0;      ///< messages that never arrived
  std::uint64_t doubled = 0;   ///< messages that arrived twice; the second was ignored
  std::uint64_t late = 0;      ///< messages that arrived after a newer one; ignored
  std::uint64_t damaged = 0;   ///< messages with a wrong checksum or format
  std::uint64_t foreign = 0;   ///< messages from another sender
  std::uint64_t restarts = 0;  ///< the device restarted its counter
  std::uint64_t leaps = 0;     ///< changes of position that are too fast for any hand
  /// Messages that were read together with a newer one, because the host was late.
  std::uint64_t skipped = 0;
  std::uint64_t stale = 0;   ///< ticks without a new sample
  std::uint64_t unsent = 0;  ///< answers that could not be written: the send buffer was full
  /// Samples during which the connection was too bad for a force.
  std::uint64_t poorConnectionSamples = 0;
  std::uint64_t clipped = 0;  ///< forces above the maximum of the device
  /// Times that the device switched its force off because the host was late.
  std::uint64_t expired = 0;
  /// From an answer of the host to the first sample that acknowledges it [µs].
  timing::LatenessHistogram roundTrip;
  std::optional<double> drift;   ///< of the host's clock against the device's [parts per million]
  std::int64_t clockOffset = 0;  ///< host time at device time 0 [ns]
};

/// The limits and properties of a device, in its kind's unit of travel.
struct Capabilities {
  const DeviceKind* kind;  ///< common to all devices of the kind; lives as long as the program
  std::string name;        ///< as shown to users: "simulated punch"
  double leastTravel = 0.0;
  double largestTravel = 10.0;
  double maxForce = 10.0;  ///< [N]
  double maxTorque = 0.0;  ///< about the tool's axis [N·m]; 0: the device renders no torque
  double damping = 0.0;    ///< of the mechanism itself [N·s / travel unit]
  double rate = 1000.0;    ///< [Hz]
  bool isSimulated = true;

  bool rendersTorque() const noexcept { return maxTorque > 0.0; }
};

enum class DeviceStatus : std::uint8_t {
  Ok,
  Stale,         ///< the device answers, but this sample is not new
  Faulted,       ///< the device reports a fault
  NotAnswering,  ///< the device does not answer
};

/// One reading of a device. It is a measurement only if its status is Ok; otherwise the numbers
/// must not be used.
struct DeviceSample {
  DeviceStatus status = DeviceStatus::NotAnswering;
  double travel = 0.0;    ///< [travel unit]
  double velocity = 0.0;  ///< [travel unit / s]
  /// Angle about the tool's axis since travel was 0 [rad], positive in the right-handed sense about
  /// the direction of advance; 0 for a device that does not measure it.
  double turn = 0.0;
  bool isDeadManHeld = true;  ///< the dead-man switch is held, or the device has no such switch
  bool isReamerOn = true;     ///< the reamer's switch or pedal is pressed, or the device has none
  std::uint32_t leaps = 0;    ///< LinkReport::leaps until this sample
  /// Time of measurement on the device's clock [ns]; 0: the device has no clock.
  std::int64_t deviceTime = 0;
};

/// The state of a device. A fault can follow every state; only open() and close() leave Faulted.
enum class Lifecycle : std::uint8_t {
  Closed,
  Open,     ///< connected: the protocol and the identity of the device are as expected
  Checked,  ///< open, and its check ran to the end without a failure
  Armed,    ///< accepts forces
  Running,  ///< armed, and forces have been commanded
  Faulted,  ///< renders no force until it is opened again
};

/// A haptic device. The thread of the engine calls read() and command() in turn; they neither
/// allocate, wait nor throw. The other functions are called while the engine does not tick, unless
/// their comment says otherwise.
class Device {
 public:
  virtual ~Device() = default;
  Device() = default;
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  virtual const Capabilities& capabilities() const noexcept = 0;

  /// Connects to the device, if it has a connection; also reconnects after a fault.
  /// @throws DeviceError  with a message for the operator.
  virtual void open() {}
  virtual void close() noexcept {}

  /// Listens for @p seconds and checks whether the device can be used. Opens it if needed; a device
  /// that cannot be opened is reported as a failed check.
  virtual std::vector<CheckResult> check(double seconds);

  /// Called before and after a trial: after arm() the device accepts forces, after disarm() it does
  /// not.
  /// @throws DeviceError  if the device cannot be armed.
  virtual void arm() {}
  virtual void disarm() noexcept {}

  /// May be called from any thread.
  virtual Lifecycle lifecycle() const noexcept { return Lifecycle::Running; }
  /// A message about the present fault; empty if there is none. May be called from any thread.
  virtual base::Message fault() const { return {}; }

  /// Statistics of the connection since arm(). Called from the thread that ticks.
  virtual LinkReport link() { return {}; }

  /// The device's pacer if it sets the pace of the loop, else nullptr; lives as long as the device.
  virtual Pacer* pacer() noexcept { return nullptr; }

  /// Returns the present state of the tool, @p dt [s] after the last call.
  virtual DeviceSample read(double dt) noexcept = 0;

  /// Sets the force and torque on the hand until the next command.
  /// @param force   [N]; positive against closing or advancing.
  /// @param torque  about the tool's axis, right-handed about the direction of advance [N·m];
  ///                ignored by a device that renders no torque.
  virtual void command(double force, double torque) noexcept = 0;
};

}  // namespace haptics::devices

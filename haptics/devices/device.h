#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

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

  /// Waits for the next period, no longer than until @p deadline [ns on CLOCK_MONOTONIC]. False
  /// where none came.
  virtual bool wait(std::int64_t deadline) noexcept = 0;
};

enum class Finding : std::uint8_t { Pass, Warn, Fail };

const char* nameOf(Finding finding) noexcept;

/// One result of the check of a device.
struct CheckResult {
  Finding finding = Finding::Pass;
  std::string what;      ///< what was looked at: "telemetry rate"
  std::string measured;  ///< what was seen, with its unit
  std::string fix;       ///< what to do about it; empty where all is well
};

/// A device that cannot be used: which, why, and what to do about it, in words.
class DeviceError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What has come over a wire, what has not, and how long it took.
struct LinkReport {
  bool isThere = false;                 ///< there is a wire
  std::uint64_t received = 0;           ///< that were acted upon
  std::uint64_t lost = 0;               ///< never came
  std::uint64_t doubled = 0;            ///< came twice; the second was not acted upon
  std::uint64_t late = 0;               ///< overtaken; not acted upon
  std::uint64_t damaged = 0;            ///< not as they had been sent
  std::uint64_t foreign = 0;            ///< from another sender
  std::uint64_t restarts = 0;           ///< the device restarted its counter
  std::uint64_t skipped = 0;            ///< came together with a newer one, after we had been late
  std::uint64_t stale = 0;              ///< ticks without a new sample
  std::uint64_t unsent = 0;             ///< answers that found no room on the wire
  std::uint64_t poor = 0;               ///< samples while the connection was too bad for a force
  std::uint64_t clipped = 0;            ///< forces beyond what the device gives
  std::uint64_t expired = 0;            ///< the device switched its force off because we were late
  timing::LatenessHistogram roundTrip;  ///< from our answer to the sample that has seen it [µs]
  std::optional<double> drift;          ///< our clock against the device's [parts per million]
  std::int64_t clockOffset = 0;         ///< our clock at the device's 0 [ns]
};

/// What a device can do, in its kind's unit of travel.
struct Capabilities {
  const DeviceKind* kind;  ///< what is the same for all of its kind; lives as long as the program
  std::string name;        ///< for people: "simulated punch"
  double leastTravel = 0.0;
  double mostTravel = 10.0;
  double maxForce = 10.0;  ///< [N]
  double maxTorque = 0.0;  ///< about the tool's axis [N·m]; 0: it renders none
  double damping = 0.0;    ///< of the mechanism itself [N·s / travel unit]
  double rate = 1000.0;    ///< [Hz]
  bool isSimulated = true;

  bool rendersTorque() const noexcept { return maxTorque > 0.0; }
};

enum class DeviceStatus : std::uint8_t {
  Ok,
  Stale,    ///< answers, but this sample is not new
  Faulted,  ///< says that something is wrong with it
  Gone,     ///< does not answer
};

/// What a device says about itself. Only a sample that is Ok is a measurement: an invalid one is
/// never a plausible zero.
struct DeviceSample {
  DeviceStatus status = DeviceStatus::Gone;
  double travel = 0.0;    ///< [travel unit]
  double velocity = 0.0;  ///< [travel unit / s]
  /// Angle about the tool's axis since travel was 0 [rad], positive in the right-handed sense about
  /// the direction of advance; 0 for a device that does not measure it.
  double turn = 0.0;
  bool isHeld = true;      ///< the dead-man switch is held, or the device has no such switch
  bool isReamerOn = true;  ///< the reamer's switch or pedal is pressed, or the device has none
  std::int64_t deviceTime =
      0;                      ///< when it was measured, on the device's clock [ns]; 0: it has none
  std::int64_t hostTime = 0;  ///< when it arrived, on CLOCK_MONOTONIC [ns]; 0: at once
};

/// What a device is ready for. A fault leads out of every state, and back only through open().
enum class Lifecycle : std::uint8_t {
  Closed,
  Open,     ///< connected: the protocol and the identity of the device are as expected
  Checked,  ///< and is fit for use
  Armed,    ///< takes forces
  Running,  ///< and gives some
  Faulted,  ///< no force until the operator has decided
};

const char* nameOf(Lifecycle state) noexcept;

/// An instrument that a hand holds. read() and command() are called in turn from one thread, the
/// engine's; they neither allocate, wait nor throw. The others are called while the engine does not
/// tick.
class Device {
 public:
  virtual ~Device() = default;
  Device() = default;
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  virtual const Capabilities& capabilities() const noexcept = 0;

  /// Makes a connection, where there is something to connect; again after a fault.
  /// @throws DeviceError  in words for the person at the desk.
  virtual void open() {}
  virtual void close() noexcept {}

  /// Listens for @p seconds and checks whether the device can be used. Opens it if needed; a device
  /// that cannot be opened is a finding.
  virtual std::vector<CheckResult> check(double seconds);

  /// Before and after a trial: from here on it takes forces; from here on it takes none.
  /// @throws DeviceError  if it does not.
  virtual void arm() {}
  virtual void disarm() noexcept {}

  /// Any thread.
  virtual Lifecycle lifecycle() const noexcept { return Lifecycle::Running; }
  /// May be called by any thread: the fault in words; empty if there is none.
  virtual std::string fault() const { return {}; }

  /// What has been received and sent since it was armed. Called from the thread that ticks.
  virtual LinkReport link() { return {}; }

  /// What sets the pace of the loop, if this device does; it lives as long as the device.
  virtual Pacer* pacer() noexcept { return nullptr; }

  /// The present state of the tool, @p dt [s] after the last call.
  virtual DeviceSample read(double dt) noexcept = 0;

  /// Acts on the hand until the next command.
  /// @param force   against closing or advancing is positive [N].
  /// @param torque  about the tool's axis, right-handed about the way of advancing [N·m]; a device
  ///                that renders none ignores it.
  virtual void command(double force, double torque) noexcept = 0;
};

}  // namespace haptics::devices

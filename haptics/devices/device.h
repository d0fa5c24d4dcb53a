#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "haptics/devices/beat.h"
#include "haptics/devices/device_check.h"
#include "haptics/devices/device_kind.h"
#include "haptics/devices/link_report.h"

namespace haptics::devices {

/// What a device can do, in its kind's unit of travel.
struct Capabilities {
  const DeviceKind* kind;  ///< what is the same for all of its kind; lives as long as the program
  std::string name;        ///< for people: "simulated punch"
  double leastTravel = 0.0;
  double mostTravel = 10.0;
  double maxForce = 10.0;  ///< [N]
  double damping = 0.0;    ///< of the mechanism itself [N·s / travel unit]
  double rate = 1000.0;    ///< [Hz]
  bool isSimulated = true;
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
  bool isHeld = true;     ///< somebody holds the dead-man switch, or there is none
  std::int64_t deviceTime =
      0;                      ///< when it was measured, on the device's clock [ns]; 0: it has none
  std::int64_t hostTime = 0;  ///< when it arrived, on CLOCK_MONOTONIC [ns]; 0: at once
};

/// What a device is ready for. A fault leads out of every state, and back only through open().
enum class Lifecycle : std::uint8_t {
  Closed,
  Open,     ///< speaks our language, and is who it should be
  Checked,  ///< and is fit for use
  Armed,    ///< takes forces
  Running,  ///< and gives some
  Faulted,  ///< no force until the operator has decided
};

const char* nameOf(Lifecycle state) noexcept;

/// An instrument in somebody's hand. read() and command() are called in turn from one thread, the
/// engine's; they neither allocate, wait nor throw. The others are called while nobody ticks.
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

  /// Whether it is fit for use: listens for @p seconds, and says what it saw. Opens it if need be;
  /// what cannot be opened is a finding.
  virtual std::vector<CheckResult> check(double seconds);

  /// Before and after a trial: from here on it takes forces; from here on it takes none.
  /// @throws DeviceError  if it does not.
  virtual void arm() {}
  virtual void disarm() noexcept {}

  /// Any thread.
  virtual Lifecycle lifecycle() const noexcept { return Lifecycle::Running; }
  /// Any thread: what is wrong, in words; empty where nothing is.
  virtual std::string fault() const { return {}; }

  /// What has come and gone since it was armed. Asked by whoever ticks.
  virtual LinkReport link() { return {}; }

  /// What sets the pace of the loop, if this device does; it lives as long as the device.
  virtual Beat* beat() noexcept { return nullptr; }

  /// Where the tool is now, @p dt [s] after the last time it was asked.
  virtual DeviceSample read(double dt) noexcept = 0;

  /// Pushes back with @p force [N] until the next command; against closing or advancing is
  /// positive.
  virtual void command(double force) noexcept = 0;
};

}  // namespace haptics::devices

#pragma once

#include <atomic>

#include "haptics/devices/device.h"
#include "haptics/devices/hand.h"

namespace haptics::devices {

/// A simulated instrument: a mass on one axis between the hand that pushes it and the force that
/// the engine commands, with the friction of the mechanism and an elastic stop at either end of
/// travel,
///
///     m ẍ = F_hand − F − b ẋ − F_stop.
///
/// A kind with an inertia also rotates about its axis, by the commanded torque τ against the wrist
/// that holds it,
///
///     I φ̈ = τ − b φ̇ − k φ.
///
/// read() advances the simulation by dt. The hand must outlive the device.
class SimulatedDevice final : public Device {
 public:
  /// @throws std::invalid_argument  if the mechanism is not valid.
  SimulatedDevice(Capabilities capabilities, const Mechanism& mechanism, Hand& hand);
  /// A device with the registered properties of @p kind.
  SimulatedDevice(const DeviceKind& kind, Hand& hand);

  const Capabilities& capabilities() const noexcept override { return capabilities_; }
  DeviceSample read(double dt) noexcept override;
  void command(double force, double torque) noexcept override {
    force_ = force;
    torque_ = torque;
  }

  /// Simulates an unplugged device, which no longer answers, until plugIn(). Any thread.
  void unplug() noexcept { isGone_.store(true, std::memory_order_relaxed); }
  void plugIn() noexcept { isGone_.store(false, std::memory_order_relaxed); }

  /// Presses or releases the dead-man switch. Any thread.
  void hold(bool isDeadManHeld) noexcept {
    isDeadManHeld_.store(isDeadManHeld, std::memory_order_relaxed);
  }

  /// Presses or releases the reamer's switch. Any thread.
  void switchReamer(bool isOn) noexcept { isReamerOn_.store(isOn, std::memory_order_relaxed); }

  /// The last commanded force [N].
  double commandedForce() const noexcept { return force_; }
  /// The last commanded torque about the tool's axis [N·m].
  double commandedTorque() const noexcept { return torque_; }

 private:
  double stopForce() const noexcept;
  /// Advances the rotation about the tool's axis by @p dt [s].
  void turn(double dt) noexcept;

  Capabilities capabilities_;
  Mechanism mechanism_;
  Hand& hand_;
  std::atomic<bool> isGone_{false};
  std::atomic<bool> isDeadManHeld_{true};
  std::atomic<bool> isReamerOn_{true};
  double travel_ = 0.0;           ///< [travel unit]
  double velocity_ = 0.0;         ///< [travel unit / s]
  double force_ = 0.0;            ///< last commanded [N]
  double torque_ = 0.0;           ///< last commanded [N·m]
  double turn_ = 0.0;             ///< [rad]
  double angularVelocity_ = 0.0;  ///< [rad/s]
};

/// The capabilities of a simulated device of @p kind.
Capabilities simulated(const DeviceKind& kind);

}  // namespace haptics::devices

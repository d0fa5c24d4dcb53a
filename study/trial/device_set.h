#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <string>

#include "haptics/devices/hand.h"
#include "haptics/devices/simulated_device.h"
#include "haptics/engine/scene_spec.h"
#include "protocols/model/protocol.h"

namespace study {

/// The instruments of a session. A device is opened when a step first needs it.
class DeviceSet {
 public:
  virtual ~DeviceSet() = default;
  DeviceSet() = default;
  DeviceSet(const DeviceSet&) = delete;
  DeviceSet& operator=(const DeviceSet&) = delete;

  /// The device that the protocol calls @p need.id; opens it if need be. @throws UserError,
  /// haptics::devices::DeviceError  if the device is unknown or cannot be opened.
  virtual haptics::devices::Device& device(const protocols::DeviceRequirement& need) = 0;
  virtual bool isOpen(const std::string& id) const = 0;

  /// Called before a trial on that device. Sends the scene to a device that computes its force
  /// itself.
  virtual void prepare(
      const protocols::DeviceRequirement& /*need*/, const haptics::engine::SceneSpec& /*scene*/) {}
};

/// Simulated instruments, each moved by a hand that the caller provides.
class SimulatedDeviceSet final : public DeviceSet {
 public:
  using HandFor =
      std::function<std::unique_ptr<haptics::devices::Hand>(const protocols::DeviceRequirement&)>;

  explicit SimulatedDeviceSet(HandFor handFor) : handFor_(std::move(handFor)) {}

  haptics::devices::Device& device(const protocols::DeviceRequirement& need) override;
  bool isOpen(const std::string& id) const override { return open_.count(id) > 0; }

  /// Simulates that a device is unplugged.
  void unplug(const std::string& id);
  /// Simulates that a device is connected again.
  void plugIn(const std::string& id);

 private:
  /// An open device and the hand that moves it.
  struct HeldDevice {
    std::unique_ptr<haptics::devices::Hand> hand;
    std::unique_ptr<haptics::devices::SimulatedDevice> device;
  };

  HandFor handFor_;
  std::map<std::string, HeldDevice> open_;
};

/// The smallest feed limit of the scenes that @p protocol renders on @p device [m/s]; infinity if
/// none of them limits the feed (only reaming does).
double feedLimitOn(const protocols::Protocol& protocol, const std::string& device);

/// The hand of a simulated participant, drawn from the study's seed.
///
/// @param mostFeed  feedLimitOn() the device [m/s]. A hand that would be faster is slowed down to
///     stay below this feed, and moves about half as deep.
std::unique_ptr<haptics::devices::Hand> simulatedHandFor(
    const protocols::DeviceRequirement& need,
    std::uint64_t seed,
    const std::string& cohort,
    std::uint64_t slot,
    double mostFeed = std::numeric_limits<double>::infinity());

/// The travel at which a PointerHands' hand has closed the instrument fully [device's travel unit].
double pointerReachFor(const protocols::DeviceRequirement& need) noexcept;

/// The hands on simulated instruments that follow the mouse pointer. The instruments own them: a
/// hand is moved only while its instrument is open.
class PointerHands {
 public:
  /// A hand for SimulatedDeviceSet.
  std::unique_ptr<haptics::devices::Hand> make(const protocols::DeviceRequirement& need);
  /// Moves the hand on that device; does nothing if none was made for it.
  /// @param share  from 0 (open) to 1 (closed).
  void moveTo(const protocols::DeviceRequirement& need, double share);

 private:
  std::map<std::string, haptics::devices::PointerHand*> hands_;  ///< by the device's id
};

}  // namespace study

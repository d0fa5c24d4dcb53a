#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "study/trial/device_file.h"
#include "study/trial/device_set.h"

namespace study {

/// The instruments of a laboratory, as its device file describes them. A device is opened when it
/// is first needed. One that has failed is opened again when it is next asked for, which is the
/// operator's decision.
class HardwareDeviceSet final : public DeviceSet {
 public:
  /// @param handFor  makes the hands of the devices that the file lists as simulated.
  HardwareDeviceSet(std::vector<DeviceEntry> entries, SimulatedDeviceSet::HandFor handFor);

  /// @throws UserError  if the file lists no such device, or the device is another instrument.
  /// @throws haptics::devices::DeviceError  if it cannot be opened.
  haptics::devices::Device& device(const protocols::DeviceRequirement& need) override;
  bool isOpen(const std::string& id) const override;

  /// The device with this id, without opening it; nullptr if the file does not list it.
  haptics::devices::Device* find(const std::string& id);
  const std::vector<DeviceEntry>& entries() const noexcept { return entries_; }

  /// Sends a scene to a punch that computes its force itself; does nothing for other devices.
  void prepare(
      const protocols::DeviceRequirement& need, const haptics::engine::SceneSpec& scene) override;

 private:
  /// The device of an entry; creates it when first called, without opening it.
  haptics::devices::Device& deviceOf(const DeviceEntry& entry);

  std::vector<DeviceEntry> entries_;
  SimulatedDeviceSet::HandFor handFor_;
  std::map<std::string, std::unique_ptr<haptics::devices::Hand>> hands_;
  std::map<std::string, std::unique_ptr<haptics::devices::Device>> devices_;
};

/// The devices of @p deviceFile; if it is empty, of the study's own device file if there is one;
/// otherwise simulated ones.
/// @throws UserError  if the file cannot be used.
std::unique_ptr<DeviceSet> deviceSetFor(
    const std::string& deviceFile,
    const std::filesystem::path& studyFolder,
    SimulatedDeviceSet::HandFor handFor);

/// Runs the device's own checks for @p seconds. With a @p protocol it also compares the kind of
/// instrument, the largest force and the damping with what the protocol's device @p id needs.
std::vector<haptics::devices::CheckResult> preflight(
    haptics::devices::Device& device,
    const protocols::Protocol* protocol,
    const std::string& id,
    double seconds);

/// The result for a device that the protocol needs and the device file lacks.
haptics::devices::CheckResult missingDevice();

}  // namespace study

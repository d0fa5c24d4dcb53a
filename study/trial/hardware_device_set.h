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
/// is first needed, and opened anew where it has failed since: whoever asks for it then has decided
/// so.
class HardwareDeviceSet final : public DeviceSet {
 public:
  /// @param handFor  for what the file has simulated.
  HardwareDeviceSet(std::vector<DeviceEntry> entries, SimulatedDeviceSet::HandFor handFor);

  /// @throws UserError  if the file has no such device, or it is another instrument.
  /// @throws haptics::devices::DeviceError  if it cannot be opened.
  haptics::devices::Device& device(const protocols::DeviceNeed& need) override;
  bool isOpen(const std::string& id) const override;

  /// A device without opening it; nullptr where the file has none of that name.
  haptics::devices::Device* find(const std::string& id);
  const std::vector<DeviceEntry>& entries() const noexcept { return entries_; }

  /// A scene for a punch that renders by itself; elsewhere nothing happens.
  void prepare(const protocols::DeviceNeed& need, const haptics::engine::SceneSpec& scene) override;

 private:
  haptics::devices::Device& made(const DeviceEntry& entry);

  std::vector<DeviceEntry> entries_;
  SimulatedDeviceSet::HandFor handFor_;
  std::map<std::string, std::unique_ptr<haptics::devices::Hand>> hands_;
  std::map<std::string, std::unique_ptr<haptics::devices::Device>> devices_;
};

/// The devices of @p deviceFile; where none is named, of the study's own device file if it has one;
/// otherwise simulated ones.
/// @throws UserError  if the file cannot be used, in words.
std::unique_ptr<DeviceSet> deviceSetFor(
    const std::string& deviceFile,
    const std::filesystem::path& studyFolder,
    SimulatedDeviceSet::HandFor handFor);

/// Whether @p device is fit for what a protocol needs of it: what it finds itself, and what the
/// protocol asks for beyond its strength.
std::vector<haptics::devices::CheckResult> preflight(
    haptics::devices::Device& device, const protocols::DeviceNeed* need, double seconds);

}  // namespace study

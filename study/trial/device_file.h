#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "haptics/devices/iiwa/iiwa_device.h"
#include "haptics/devices/punch/punch_device.h"
#include "questionnaires/json/problem.h"

namespace study {

/// A simulated device in this program.
struct SimulatedSettings {
  const haptics::devices::DeviceKind* kind;
};

/// A device on a serial line, and which side renders its scenes.
struct SerialPunchSettings {
  haptics::devices::PunchSettings punch;
  bool rendersOnDevice = false;
};

/// A device of a laboratory, under the id that protocols use.
struct DeviceEntry {
  std::string id;
  std::variant<SimulatedSettings, SerialPunchSettings, haptics::devices::IiwaSettings> settings;
};

/// The device file in a study's folder that is used unless another one is named.
inline constexpr std::string_view kDeviceFileName = "devices.json";

/// Parses a device file: the devices of a laboratory and how they are connected (docs/devices.md).
/// Adds all problems of the file to @p problems; returns std::nullopt if there are errors.
std::optional<std::vector<DeviceEntry>> readDevices(
    std::string_view json, questionnaires::Problems& problems);

/// Reads and parses the file @p file. @throws UserError  with all problems of the file.
std::vector<DeviceEntry> loadDevices(const std::string& file);

/// The text of a device file with these entries, for devices that palpate starts itself.
std::string devicesAsJson(const std::vector<DeviceEntry>& devices);

}  // namespace study

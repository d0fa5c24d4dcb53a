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

/// A stand-in in this program.
struct SimulatedSettings {
  const haptics::devices::DeviceKind* kind;
};

/// A device on a serial line, and who renders its scenes.
struct SerialPunchSettings {
  haptics::devices::PunchSettings punch;
  bool rendersOnDevice = false;
};

/// A device of a laboratory, by the name that protocols give it.
struct DeviceEntry {
  std::string id;
  std::variant<SimulatedSettings, SerialPunchSettings, haptics::devices::IiwaSettings> settings;
};

const haptics::devices::DeviceKind& deviceKindOf(const DeviceEntry& entry) noexcept;

/// The name of the device file in a study's folder that is used where none is named.
inline constexpr std::string_view kDeviceFileName = "devices.json";

/// Which devices a laboratory has, and how they are connected (docs/devices.md), and everything
/// that is wrong with it; nothing where there are errors.
std::optional<std::vector<DeviceEntry>> readDevices(
    std::string_view json, questionnaires::Problems& problems);

/// The same from a file. @throws UserError  with everything that is wrong with it, in words.
std::vector<DeviceEntry> loadDevices(const std::string& file);

/// Device entries as such a file, for the ones that palpate starts itself.
std::string devicesAsJson(const std::vector<DeviceEntry>& devices);

}  // namespace study

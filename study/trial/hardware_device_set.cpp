#include "study/trial/hardware_device_set.h"

#include <utility>

#include <fmt/format.h>

#include "base/search.h"
#include "haptics/engine/compiled_scene.h"
#include "haptics/engine/passivity.h"
#include "haptics/engine/rendered_slope.h"
#include "study/model/messages.h"
#include "study/model/user_error.h"

namespace study {
namespace {

using haptics::devices::CheckResult;
using haptics::devices::Device;
using haptics::devices::Finding;
using haptics::devices::Lifecycle;

bool isOpen(const Device& device) noexcept {
  const auto state = device.lifecycle();
  return state != Lifecycle::Closed && state != Lifecycle::Faulted;
}

/// Makes the device of an entry. A type of DeviceEntry::settings without an overload here does not
/// compile.
struct DeviceMaker {
  const DeviceEntry& entry;
  const SimulatedDeviceSet::HandFor& handFor;
  /// Hand of a simulated device; outlives the device.
  std::unique_ptr<haptics::devices::Hand>& hand;

  std::unique_ptr<Device> operator()(const SerialPunchSettings& settings) const {
    return std::make_unique<haptics::devices::PunchDevice>(settings.punch);
  }
  std::unique_ptr<Device> operator()(const haptics::devices::IiwaSettings& settings) const {
    return std::make_unique<haptics::devices::IiwaDevice>(settings);
  }
  std::unique_ptr<Device> operator()(const SimulatedSettings& settings) const {
    hand = handFor({.id = entry.id, .kind = settings.kind});
    return std::make_unique<haptics::devices::SimulatedDevice>(*settings.kind, *hand);
  }
};

}  // namespace

HardwareDeviceSet::HardwareDeviceSet(
    std::vector<DeviceEntry> entries, SimulatedDeviceSet::HandFor handFor)
    : entries_(std::move(entries)), handFor_(std::move(handFor)) {}

Device& HardwareDeviceSet::deviceOf(const DeviceEntry& entry) {
  auto& device = devices_[entry.id];
  if (!device) {
    device = std::visit(DeviceMaker{entry, handFor_, hands_[entry.id]}, entry.settings);
  }
  return *device;
}

Device* HardwareDeviceSet::find(const std::string& id) {
  const auto* entry = base::withId(entries_, id);
  return entry == nullptr ? nullptr : &deviceOf(*entry);
}

Device& HardwareDeviceSet::device(const protocols::DeviceRequirement& need) {
  auto* device = find(need.id);
  if (device == nullptr) {
    throw UserError(
        "The protocol needs a device '" + need.id +
        "', and the device file has none of that name. Add it, or give it that id.");
  }
  if (device->capabilities().kind != need.kind) {
    throw UserError(fmt::format(
        "The protocol needs a {} as '{}', and the device file has a {} there. Correct one of them.",
        need.kind->name,
        need.id,
        device->capabilities().kind->name));
  }
  if (!study::isOpen(*device)) device->open();
  return *device;
}

bool HardwareDeviceSet::isOpen(const std::string& id) const {
  const auto found = devices_.find(id);
  return found != devices_.end() && study::isOpen(*found->second);
}

void HardwareDeviceSet::prepare(
    const protocols::DeviceRequirement& need, const haptics::engine::SceneSpec& scene) {
  for (const auto& entry : entries_) {
    const auto* punch = std::get_if<SerialPunchSettings>(&entry.settings);
    if (entry.id != need.id || punch == nullptr || !punch->rendersOnDevice) continue;
    static_cast<haptics::devices::PunchDevice&>(deviceOf(entry))
        .renderOnDevice(scene, need.maxForce);
  }
}

std::unique_ptr<DeviceSet> deviceSetFor(
    const std::string& deviceFile,
    const std::filesystem::path& studyFolder,
    SimulatedDeviceSet::HandFor handFor) {
  const auto own = studyFolder / kDeviceFileName;
  if (deviceFile.empty() && !std::filesystem::exists(own)) {
    return std::make_unique<SimulatedDeviceSet>(std::move(handFor));
  }
  return std::make_unique<HardwareDeviceSet>(
      loadDevices(deviceFile.empty() ? own.string() : deviceFile), std::move(handFor));
}

namespace {

/// Whether the device's damping takes up the energy that the scenes of @p id generate at its rate,
/// for the scene that needs most; no condition is named, because operators are blinded.
CheckResult dampingFinding(
    const protocols::Protocol& protocol,
    const std::string& id,
    const haptics::devices::Capabilities& can) {
  double needed = 0.0;
  for (const auto& condition : protocol.conditions) {
    if (condition.device != id) continue;
    const auto scene = condition.scene();
    const haptics::engine::Passivity passivity{
        .stiffness = haptics::engine::renderedSlope(scene, *can.kind, can.rate).steepest,
        .period = 1.0 / can.rate,
        .filterDelay = haptics::engine::CompiledScene(scene).delay() / can.rate};
    needed = std::max(needed, passivity.requiredDamping());
  }
  return passIf(
      needed <= can.damping,
      Finding::Warn,
      message("preflight.damping"),
      message("preflight.damping.limits", needed, can.damping, can.kind->travel.unit, can.rate),
      can.kind->wire == haptics::devices::Wire::Fri ? message("preflight.damping.fix.fri")
                                                    : message("preflight.damping.fix"));
}

}  // namespace

std::vector<CheckResult> preflight(
    Device& device, const protocols::Protocol* protocol, const std::string& id, double seconds) {
  auto found = device.check(seconds);
  const auto* need = protocol == nullptr ? nullptr : protocol->device(id);
  if (need == nullptr) return found;
  const auto& can = device.capabilities();
  const bool isKind = can.kind == need->kind;
  if (isKind && !isOpen(device)) return found;  // an absent device cannot be checked further
  found.push_back(passIf(
      isKind,
      Finding::Fail,
      message("preflight.instrument"),
      base::Message::verbatim(std::string(can.kind->name)),
      message("preflight.instrument.fix", need->kind->name)));
  if (isKind) found.push_back(dampingFinding(*protocol, id, can));
  found.push_back(passIf(
      can.maxForce >= need->maxForce,
      Finding::Warn,
      message("preflight.force"),
      message("preflight.force.limits", need->maxForce, can.maxForce),
      message("preflight.force.fix")));
  if (!need->needsTorque) return found;
  found.push_back(passIf(
      can.maxTorque >= need->maxTorque,
      Finding::Warn,
      message("preflight.torque"),
      can.rendersTorque() ? message("preflight.torque.limits", need->maxTorque, can.maxTorque)
                          : message("trial.no_torque"),
      can.rendersTorque() ? message("preflight.torque.fix") : message("preflight.no_torque.fix")));
  return found;
}

CheckResult missingDevice() {
  return {
      Finding::Fail,
      message("preflight.device_file"),
      message("preflight.device_file.missing"),
      message("preflight.device_file.fix")};
}

}  // namespace study

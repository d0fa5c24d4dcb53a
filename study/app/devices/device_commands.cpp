#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "haptics/devices/punch/punch_kind.h"
#include "haptics/devices/serial_port.h"
#include "haptics/registry/device_kinds.h"
#include "study/app/command_options.h"
#include "study/app/devices/device_emulate.h"
#include "study/app/devices/device_json_file.h"
#include "study/app/devices/device_listen.h"
#include "study/app/devices/device_rehearse.h"
#include "study/app/devices/device_report.h"
#include "study/model/user_error.h"
#include "study/trial/hardware_device_set.h"

namespace study::app {
namespace {

struct DeviceArguments {
  std::string file = std::string(kDeviceFileName);
  bool isFileNamed = false;
  std::string protocol;
  double seconds = 2.0;
  bool json = false;
};

std::unique_ptr<haptics::devices::Hand> anyHand(const protocols::DeviceRequirement& need) {
  return simulatedHandFor(need, 1, {}, 0);
}

int list(const DeviceArguments& arguments) {
  const auto ports = haptics::devices::serialPorts();
  fmt::print("Serial ports of this computer:{}\n", ports.empty() ? " none" : "");
  for (const auto& port : ports) fmt::print("  {}\n", port);
  fmt::print(
      "Firmware of this program: {:016x}, protocol {}.\n",
      haptics::devices::kFirmwareBuild,
      haptics::wire::punch::kProtocolVersion);
  if (!std::filesystem::exists(arguments.file)) {
    fmt::print("No device file {} is there; docs/devices.md shows one.\n", arguments.file);
    return arguments.isFileNamed ? 1 : 0;
  }
  fmt::print("Devices in {}:\n", arguments.file);
  HardwareDeviceSet deviceSet(loadDevices(arguments.file), anyHand);
  for (const auto& entry : deviceSet.entries()) {
    const auto& can = deviceSet.find(entry.id)->capabilities();
    fmt::print(
        "  {:<12} {:<28} up to {:g} N, {:g} to {:g} {}{}\n",
        entry.id,
        can.name,
        can.maxForce,
        can.leastTravel,
        can.largestTravel,
        can.kind->travel.unit,
        can.isSimulated ? ", simulated" : "");
  }
  return 0;
}

std::vector<DeviceFindings> findingsOf(const DeviceArguments& arguments) {
  if (!std::filesystem::exists(arguments.file)) {
    throw UserError(
        "No device file " + arguments.file +
        " is there. docs/devices.md shows one, and 'palpate device check FILE' takes any other.");
  }
  HardwareDeviceSet deviceSet(loadDevices(arguments.file), anyHand);
  if (arguments.protocol.empty()) return checkAll(deviceSet, nullptr, arguments.seconds);
  const auto loaded = loadValidProtocol(arguments.protocol);
  return checkAll(deviceSet, &loaded.protocol, arguments.seconds);
}

int check(const DeviceArguments& arguments) {
  std::vector<DeviceFindings> found;
  try {
    found = findingsOf(arguments);
  } catch (const std::runtime_error& error) {
    if (!arguments.json) throw;
    std::fputs(problemAsJson(error.what()).c_str(), stdout);
    return 1;
  }
  std::fputs((arguments.json ? checksAsJson(found) : checksAsText(found)).c_str(), stdout);
  return isFit(found) ? 0 : 1;
}

/// @return the option --seed.
CLI::Option* addEmulateOptions(CLI::App& verb, EmulateArguments& options) {
  auto* seed = verb.add_option(
                       "--seed",
                       options.seed,
                       "Seed of the simulated hand's movements and of injected faults")
                   ->capture_default_str();
  verb.add_option(
          "--seconds", options.seconds, "Duration [s] (default: until the program is stopped)")
      ->check(CLI::PositiveNumber);
  verb.add_flag(
      "--until-input-ends",
      options.endsWithInput,
      "For scripts: also stop when the program's input ends, such as a closed pipe or Ctrl-D "
      "(default: keep running)");
  return seed;
}

void addEmulate(CLI::App& parentCommand, Action& action) {
  auto& emulate = addCommandGroup(
      parentCommand,
      "emulate",
      "Emulate a device on its real interface; type 'help' while it runs to list faults to inject");
  for (const auto* kind : haptics::deviceKinds()) {
    if (kind->wire != haptics::devices::Wire::Serial) continue;
    const std::string name(kind->name);
    auto [verb, options] = addCommand(
        emulate,
        action,
        name,
        "Emulate the " + name + " on a virtual serial port (pseudo-terminal)",
        emulateSerial);
    options.kind = kind;
    verb->add_option(
            "--link",
            options.link,
            "File name (a symbolic link) under which the emulator's port can be opened")
        ->type_name("FILE");
    auto* drift =
        verb->add_option("--clock-drift", options.clockDrift, "Drift of the device's clock [ppm]");
    drift->check(CLI::Range(-10'000.0, 10'000.0));
    auto* rate = verb->add_option("--rate", options.rate, "Rate of the device's control loop [Hz]");
    rate->check(CLI::Range(100, 8000))->capture_default_str();
    verb->add_option(
            "--firmware",
            options.firmware,
            "Firmware file of the device's board, run in the emulator QEMU in place of the "
            "built-in emulation")
        ->type_name("FILE")
        ->excludes(rate)
        ->excludes(drift)
        ->excludes(addEmulateOptions(*verb, options));
  }
  auto [iiwa, options] = addCommand(
      emulate,
      action,
      "iiwa",
      "Emulate an LBR iiwa arm and its controller, reached by UDP (FRI)",
      emulateIiwa);
  iiwa->add_option(
          "--client",
          options.client,
          "Address and port of the FRI client (the driver of the arm) that receives the messages")
      ->capture_default_str();
  iiwa->add_option("--fri-version", options.version, "Version of the FRI protocol")
      ->check(CLI::IsMember({"1.11", "1.14", "1.15", "1.16", "2.5", "2.7"}))
      ->capture_default_str();
  iiwa->add_option("--model", options.model, "Model of the arm")
      ->check(CLI::IsMember({"iiwa7", "iiwa14"}))
      ->capture_default_str();
  iiwa->add_option(
          "--overlay",
          options.overlay,
          "How the arm takes forces: as a wrench at the tool, or as torques in the joints")
      ->check(CLI::IsMember({"wrench", "torque"}))
      ->capture_default_str();
  iiwa->add_option("--period", options.period, "Time between two FRI messages [ms]")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
  iiwa->add_option(
          "--advance",
          options.advance,
          "Time in which the simulated hand advances to its full depth [s]")
      ->check(CLI::Range(0.5, 60.0))
      ->capture_default_str();
  addEmulateOptions(*iiwa, options);
}

void addListen(CLI::App& parentCommand, Action& action) {
  auto [verb, options] = addCommand(
      parentCommand,
      action,
      "listen",
      "Record the output of a punch whose Arduino runs the published program (sketch)",
      app::listen);
  verb->add_option("PORT", options.port, "Serial port of the punch")->required();
  verb->add_option("--out", options.out, "New CSV file (default: print to the terminal)")
      ->type_name("FILE");
  verb->add_option("--baud", options.baud, "Speed of the serial port [baud]")
      ->capture_default_str();
  verb->add_option(
          "--seconds", options.seconds, "Duration [s] (default: until the program is stopped)")
      ->check(CLI::PositiveNumber);
}

void addRehearse(CLI::App& parentCommand, Action& action) {
  auto [rehearse, options] = addCommand(
      parentCommand,
      action,
      "rehearse",
      "Rehearse a study: emulate the protocol's devices, check them, run simulated participants",
      app::rehearse);
  rehearse->add_option("--out", options.out, "New folder for device file and study")
      ->type_name("FOLDER")
      ->required();
  rehearse
      ->add_option(
          "--protocol",
          options.protocol,
          "Protocol file to rehearse (.json), or a name from 'palpate protocol list'")
      ->type_name("FILE")
      ->capture_default_str();
  rehearse->add_option("--participants", options.participants, "Number of simulated participants")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  rehearse->add_option("--seed", options.seed, "Seed of all random choices")->capture_default_str();
  rehearse
      ->add_option(
          "--firmware",
          options.firmware,
          "Firmware file of the punch, run in the emulator QEMU (default: the built-in emulation)")
      ->type_name("FILE");
}

void addDeviceFile(CLI::App& verb, DeviceArguments& options) {
  verb.add_option("FILE", options.file, "The laboratory's device file")
      ->capture_default_str()
      ->each([&options](const std::string&) { options.isFileNamed = true; });
}

}  // namespace

void addDeviceCommands(CLI::App& program, Action& action) {
  auto& parentCommand =
      addCommandGroup(program, "device", "List, check and emulate haptic devices");
  auto [list, listing] = addCommand(
      parentCommand,
      action,
      "list",
      "List serial ports, and the devices of a device file",
      app::list);
  addDeviceFile(*list, listing);

  auto [check, checking] = addCommand(
      parentCommand,
      action,
      "check",
      "Check every device: PASS, WARN or FAIL, what was measured, and a fix",
      app::check);
  addDeviceFile(*check, checking);
  check
      ->add_option(
          "--protocol",
          checking.protocol,
          "Also check that the devices give what this protocol needs: a file, or a name from "
          "'palpate protocol list'")
      ->type_name("FILE");
  check->add_option("--seconds", checking.seconds, "Time for each device [s]")
      ->check(CLI::Range(0.5, 600.0))
      ->capture_default_str();
  check->add_flag("--json", checking.json, "Print JSON");

  addEmulate(parentCommand, action);
  addListen(parentCommand, action);
  addRehearse(parentCommand, action);
}

}  // namespace study::app

#include "study/trial/device_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <set>
#include <utility>

#include <nlohmann/json.hpp>

#include "haptics/devices/serial_port.h"
#include "haptics/registry/device_kinds.h"
#include "questionnaires/json/document.h"
#include "study/model/user_error.h"

namespace study {
namespace {

using haptics::devices::DeviceKind;
using haptics::devices::IiwaModel;
using haptics::devices::IiwaOverlay;
using haptics::devices::IiwaSettings;
using haptics::wire::fri::Version;
using Json = nlohmann::ordered_json;
using questionnaires::Node;
using questionnaires::Problems;

constexpr std::string_view kFormat = "palpate-devices-1";
constexpr double kDegree = std::numbers::pi / 180.0;

template <typename Value, std::size_t N>
using Choices = std::array<std::pair<std::string_view, Value>, N>;

constexpr Choices<Version, 6> kVersions{
    {{"1.11", Version::V1_11},
     {"1.14", Version::V1_14},
     {"1.15", Version::V1_15},
     {"1.16", Version::V1_16},
     {"2.5", Version::V2_5},
     {"2.7", Version::V2_7}}};
constexpr Choices<IiwaModel, 2> kModels{
    {{"iiwa7", IiwaModel::Iiwa7}, {"iiwa14", IiwaModel::Iiwa14}}};
constexpr Choices<IiwaOverlay, 2> kOverlays{
    {{"wrench", IiwaOverlay::CartesianWrench}, {"torque", IiwaOverlay::JointTorque}}};
constexpr Choices<haptics::devices::WrenchFrame, 2> kFrames{
    {{"tool", haptics::devices::WrenchFrame::Tool}, {"base", haptics::devices::WrenchFrame::Base}}};
constexpr Choices<bool, 2> kRenderers{{{"host", false}, {"device", true}}};

/// The value of a key that takes one of several names. @p fallback if the key is missing, or its
/// value is unknown, which is reported.
template <typename Known, typename Value>
Value readChoice(const Node& node, std::string_view key, const Known& known, Value fallback) {
  if (!node.has(key)) return fallback;
  std::string names;
  for (const auto& [text, value] : known) {
    names += (names.empty() ? "\"" : ", \"") + std::string(text) + "\"";
  }
  if (!node.member(key)->isText()) {
    node.problem(key, "this is no text", "write one of " + names + ", with its quotes");
    return fallback;
  }
  const std::string name = node.text(key);
  for (const auto& [text, value] : known) {
    if (text == name) return value;
  }
  if (!name.empty()) {
    node.problem(
        key, "'" + questionnaires::shown(name) + "' is not known", "write one of " + names);
  }
  return fallback;
}

/// A list of exactly @p count numbers between @p least and @p most; otherwise std::nullopt, and a
/// problem is reported.
std::optional<std::vector<double>> readNumbers(
    const Node& node, std::string_view key, std::size_t count, double least, double most) {
  if (!node.has(key)) return std::nullopt;
  auto numbers = node.numbers(key, least, most);
  if (numbers.size() == count) return numbers;
  node.problem(
      key,
      "there are " + std::to_string(numbers.size()) + " numbers and not " + std::to_string(count),
      "list all " + std::to_string(count));
  return std::nullopt;
}

std::optional<std::uint64_t> readBuild(const Node& node) {
  if (!node.has("firmware")) return std::nullopt;
  const std::string text = node.text("firmware");
  const bool isHex =
      text.size() == 16 && text.find_first_not_of("0123456789abcdef") == std::string::npos;
  if (isHex) return std::stoull(text, nullptr, 16);
  node.problem("firmware", "it is not 16 hexadecimal digits", "copy them from the message");
  return std::nullopt;
}

/// 0 for USB, or one of the standard speeds of serial ports [baud].
int readBaud(const Node& node) {
  const auto baud = static_cast<int>(node.wholeNumber("baud", 0, 4'000'000, 0));
  if (haptics::devices::SerialPort::supportsBaud(baud)) return baud;
  node.problem(
      "baud",
      "a serial port cannot go at " + std::to_string(baud) + " baud",
      "write 0 for USB, or one of " + haptics::devices::SerialPort::supportedSpeeds());
  return 0;
}

SerialPunchSettings readSerial(const Node& node, const DeviceKind& kind) {
  SerialPunchSettings settings{.punch = {.kind = &kind, .port = {}}};
  auto& p = settings.punch;
  p.port = node.text("port");
  p.baud = readBaud(node);
  if (node.has("serial")) {
    p.serial = static_cast<std::uint32_t>(node.wholeNumber("serial", 0, 4'294'967'295));
  }
  p.build = readBuild(node);
  settings.rendersOnDevice = readChoice(node, "renders", kRenderers, false);
  p.travelPerCount = node.number("travel_per_count", 1e-9, 1.0, p.travelPerCount);
  p.travelAtZero = node.number("travel_at_zero", -1000.0, 1000.0, 0.0);
  p.newtonsPerVolt = node.number("newtons_per_volt", 0.001, 100.0);
  p.maxVoltage = node.number("max_voltage_v", 0.1, 32.0, p.maxVoltage);
  p.expiry = static_cast<int>(node.wholeNumber("expiry_ms", 1, 20, p.expiry));
  p.damping = node.number("damping_n_s_per_travel_unit", 0.0, 100.0, p.damping);
  return settings;
}

Eigen::Vector3d asVector(const std::vector<double>& numbers) {
  return {numbers[0], numbers[1], numbers[2]};
}

void readMargins(const Node& node, IiwaSettings& settings) {
  const auto margins = node.object("margins");
  if (!margins || !margins->isObjectWithOnlyKeys({"position_deg", "velocity", "torque"})) return;
  auto& m = settings.margins;
  m.position = kDegree * margins->number("position_deg", 0.0, 60.0, m.position / kDegree);
  m.velocity = margins->number("velocity", 0.01, 1.0, m.velocity);
  m.torque = margins->number("torque", 0.01, 1.0, m.torque);
}

IiwaSettings readIiwa(const Node& node) {
  IiwaSettings settings;
  settings.robot = node.text("robot_address");
  if (!settings.robot.empty() && !haptics::devices::endpointFrom(settings.robot)) {
    node.problem("robot_address", "it is no numeric IPv4 address", "write it as \"172.31.1.147\"");
  }
  settings.port = static_cast<std::uint16_t>(node.wholeNumber("port", 1024, 65'535, 30200));
  settings.version = readChoice(node, "fri_version", kVersions, Version::V1_15);
  settings.model = readChoice(node, "model", kModels, IiwaModel::Iiwa14);
  settings.overlay = readChoice(node, "overlay", kOverlays, IiwaOverlay::CartesianWrench);
  settings.wrenchFrame =
      readChoice(node, "wrench_frame", kFrames, haptics::devices::WrenchFrame::Tool);
  if (const auto tool = readNumbers(node, "tool_m", 3, -1.0, 1.0))
    settings.tool.position = asVector(*tool);
  if (const auto axis = readNumbers(node, "axis", 3, -1.0, 1.0)) {
    settings.axis = asVector(*axis);
    if (!(settings.axis.norm() > 0.1)) {
      node.problem(
          "axis", "it points nowhere", "write a direction in the base, such as [0, 0, -1]");
    }
  }
  if (const auto zero = readNumbers(node, "zero_joints_deg", 7, -180.0, 180.0)) {
    settings.zero.emplace();
    for (std::size_t i = 0; i < 7; ++i) (*settings.zero)[i] = kDegree * (*zero)[i];
  }
  settings.largestTravel = node.number("most_travel_m", 0.001, 1.0, settings.largestTravel);
  settings.maxForce = node.number("max_force_n", 0.1, 1000.0, settings.maxForce);
  settings.maxTorque = node.number("max_torque_nm", 0.0, 100.0, settings.maxTorque);
  settings.damping = node.number("damping_n_s_per_m", 0.0, 10'000.0, settings.damping);
  if (node.has("pedal")) {
    settings.pedal = node.text("pedal");
    if (settings.pedal.size() > haptics::wire::fri::Name().bytes.size()) {
      node.problem("pedal", "the name of an input has at most 63 bytes", "shorten it");
    }
  }
  readMargins(node, settings);
  return settings;
}

/// A type of connection: its keys other than "id" and "type", and the function that reads these
/// keys.
struct ConnectionType {
  std::vector<std::string_view> keys;
  std::function<decltype(DeviceEntry::settings)(const Node&)> read;
};

std::string simulatedName(const DeviceKind& kind) {
  return "simulated-" + std::string(kind.name);
}
std::string serialName(const DeviceKind& kind) {
  return std::string(kind.name) + "-serial";
}
constexpr std::string_view kIiwaName = "iiwa-fri";

/// All types of connection: one for simulating each kind of device, and one for each real device.
/// All kinds on a serial line use the punch's wire protocol.
std::vector<std::pair<std::string, ConnectionType>> connectionTypes() {
  std::vector<std::pair<std::string, ConnectionType>> connectionTypes;
  for (const auto* kind : haptics::deviceKinds()) {
    connectionTypes.push_back(
        {simulatedName(*kind), {{}, [kind](const Node&) { return SimulatedSettings{kind}; }}});
  }
  for (const auto* kind : haptics::deviceKinds()) {
    if (kind->wire != haptics::devices::Wire::Serial) continue;
    connectionTypes.push_back(
        {serialName(*kind),
         {{"port",
           "baud",
           "serial",
           "firmware",
           "renders",
           "travel_per_count",
           "travel_at_zero",
           "newtons_per_volt",
           "max_voltage_v",
           "expiry_ms",
           "damping_n_s_per_travel_unit"},
          [kind](const Node& node) { return readSerial(node, *kind); }}});
  }
  connectionTypes.push_back(
      {std::string(kIiwaName),
       {{"robot_address",
         "port",
         "fri_version",
         "model",
         "overlay",
         "wrench_frame",
         "tool_m",
         "axis",
         "zero_joints_deg",
         "most_travel_m",
         "max_force_n",
         "max_torque_nm",
         "damping_n_s_per_m",
         "pedal",
         "margins"},
        readIiwa}});
  return connectionTypes;
}

std::optional<DeviceEntry> readEntry(const Node& node) {
  const std::string written = node.isObject() && node.has("type") ? node.text("type") : "";
  const auto known = connectionTypes();
  const auto named =
      std::ranges::find_if(known, [&](const auto& type) { return type.first == written; });
  std::vector<std::string_view> keys{"id", "type"};
  if (named != known.end()) {
    keys.insert(keys.end(), named->second.keys.begin(), named->second.keys.end());
  }
  if (!node.isObjectWithOnlyKeys(keys)) return std::nullopt;
  const std::string id = node.id("id");
  if (!node.has("type")) {
    static_cast<void>(node.text("type"));  // reports that the key is missing
    return std::nullopt;
  }
  return DeviceEntry{id, readChoice(node, "type", known, known.front().second).read(node)};
}

template <typename Value, std::size_t N>
std::string nameIn(const Choices<Value, N>& known, Value value) {
  for (const auto& [text, candidate] : known) {
    if (candidate == value) return std::string(text);
  }
  return {};
}

/// An angle in degrees, rounded to nine decimals; later digits are errors of the conversion.
double inDegrees(double angle) {
  return std::round(1e9 * angle / kDegree) / 1e9;
}

std::string inHex(std::uint64_t number) {
  std::array<char, 17> text{};
  std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(number));
  return text.data();
}

struct AsJson {
  Json& json;

  void operator()(const SimulatedSettings& simulated) const {
    json["type"] = simulatedName(*simulated.kind);
  }
  void operator()(const SerialPunchSettings& settings) const {
    const auto& p = settings.punch;
    json["type"] = serialName(*p.kind);
    json["port"] = p.port;
    json["baud"] = p.baud;
    if (p.serial) json["serial"] = *p.serial;
    if (p.build) json["firmware"] = inHex(*p.build);
    json["renders"] = nameIn(kRenderers, settings.rendersOnDevice);
    json["travel_per_count"] = p.travelPerCount;
    json["travel_at_zero"] = p.travelAtZero;
    json["newtons_per_volt"] = p.newtonsPerVolt;
    json["max_voltage_v"] = p.maxVoltage;
    json["expiry_ms"] = p.expiry;
    json["damping_n_s_per_travel_unit"] = p.damping;
  }
  void operator()(const IiwaSettings& s) const {
    json["type"] = kIiwaName;
    json["robot_address"] = s.robot;
    json["port"] = s.port;
    json["fri_version"] = nameIn(kVersions, s.version);
    json["model"] = nameIn(kModels, s.model);
    json["overlay"] = nameIn(kOverlays, s.overlay);
    json["wrench_frame"] = nameIn(kFrames, s.wrenchFrame);
    json["tool_m"] = {s.tool.position.x(), s.tool.position.y(), s.tool.position.z()};
    json["axis"] = {s.axis.x(), s.axis.y(), s.axis.z()};
    if (s.zero) {
      for (const double joint : *s.zero) json["zero_joints_deg"].push_back(inDegrees(joint));
    }
    json["most_travel_m"] = s.largestTravel;
    json["max_force_n"] = s.maxForce;
    json["max_torque_nm"] = s.maxTorque;
    json["damping_n_s_per_m"] = s.damping;
    json["margins"] = {
        {"position_deg", inDegrees(s.margins.position)},
        {"velocity", s.margins.velocity},
        {"torque", s.margins.torque}};
  }
};

}  // namespace

std::optional<std::vector<DeviceEntry>> readDevices(std::string_view json, Problems& problems) {
  Problems found;
  std::vector<DeviceEntry> devices;
  if (const auto value = questionnaires::parseJson(json, found)) {
    const Node root(*value, "$", found);
    if (root.isObjectWithOnlyKeys({"format", "devices"})) {
      root.requireFormat("format", kFormat);
      std::set<std::string> ids;
      for (const auto& node : root.requiredList("devices")) {
        auto entry = readEntry(node);
        if (entry && !entry->id.empty() && !ids.insert(entry->id).second) {
          node.problem("id", "another device has it already", "give every device its own");
        }
        if (entry) devices.push_back(std::move(*entry));
      }
    }
  }
  problems.append(found);
  if (found.hasErrors()) return std::nullopt;
  return devices;
}

std::vector<DeviceEntry> loadDevices(const std::string& file) {
  Problems problems;
  auto devices = readDevices(questionnaires::readTextFile(file), problems);
  if (!devices) {
    throw UserError(file + " cannot be used yet:\n" + questionnaires::describe(problems.all()));
  }
  return std::move(*devices);
}

std::string devicesAsJson(const std::vector<DeviceEntry>& devices) {
  Json json;
  json["format"] = kFormat;
  for (const auto& device : devices) {
    Json entry;
    entry["id"] = device.id;
    std::visit(AsJson{entry}, device.settings);
    json["devices"].push_back(std::move(entry));
  }
  return json.dump(1) + "\n";
}

}  // namespace study

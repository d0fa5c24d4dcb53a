#include "study/trial/device_file.h"

#include <numbers>

#include <gtest/gtest.h>

#include "haptics/devices/iiwa/reamer_kind.h"
#include "haptics/devices/punch/punch_kind.h"
#include "protocols/load_protocol.h"
#include "study/session/session.h"
#include "study/trial/hardware_device_set.h"
#include "tests/support/says.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_data.h"

namespace study {
namespace device_file_test {

using haptics::devices::punchKind;
using haptics::devices::reamerKind;
using tests::says;

constexpr const char* kBoth = R"({
  "format": "palpate-devices-1",
  "devices": [
    {"id": "punch", "type": "punch-serial", "port": "/dev/serial/by-id/punch", "baud": 1000000,
     "serial": 17, "firmware": "00112233445566ff", "renders": "device", "travel_per_count": 0.0044,
     "travel_at_zero": 11.5, "newtons_per_volt": 0.7, "max_voltage_v": 10, "expiry_ms": 8,
     "damping_n_s_per_travel_unit": 0.06},
    {"id": "reamer", "type": "iiwa-fri", "robot_address": "172.31.1.147", "port": 30201,
     "fri_version": "2.7", "model": "iiwa7", "overlay": "torque", "wrench_frame": "base",
     "tool_m": [0, 0, 0.25], "axis": [0, 1, 0], "zero_joints_deg": [0, 30, 0, -90, 0, 60, 0],
     "most_travel_m": 0.03, "max_force_n": 120, "max_torque_nm": 4, "damping_n_s_per_m": 40,
     "margins": {"position_deg": 6, "velocity": 0.5, "torque": 0.4}},
    {"id": "spare", "type": "simulated-reamer"}
  ]
})";

std::string objectionsTo(const std::string& text) {
  questionnaires::Problems problems;
  EXPECT_FALSE(readDevices(text, problems));
  return questionnaires::describe(problems.all());
}

TEST(DeviceFile, ReadsHowEveryDeviceIsConnected) {
  questionnaires::Problems problems;
  const auto devices = readDevices(kBoth, problems);
  ASSERT_TRUE(devices) << questionnaires::describe(problems.all());
  ASSERT_EQ(devices->size(), 3U);
  const auto& punch = std::get<SerialPunchSettings>((*devices)[0].settings);
  EXPECT_EQ(punch.punch.port, "/dev/serial/by-id/punch");
  EXPECT_EQ(punch.punch.baud, 1'000'000);
  EXPECT_EQ(punch.punch.serial, 17U);
  EXPECT_EQ(punch.punch.build, 0x00112233445566ffU);
  EXPECT_TRUE(punch.rendersOnDevice);
  EXPECT_EQ(punch.punch.travelPerCount, 0.0044);
  EXPECT_EQ(punch.punch.expiry, 8);
  const auto& arm = std::get<haptics::devices::IiwaSettings>((*devices)[1].settings);
  EXPECT_EQ(arm.robot, "172.31.1.147");
  EXPECT_EQ(arm.maxTorque, 4.0);
  EXPECT_EQ(arm.version, haptics::wire::fri::Version::V2_7);
  EXPECT_EQ(arm.model, haptics::devices::IiwaModel::Iiwa7);
  EXPECT_EQ(arm.overlay, haptics::devices::IiwaOverlay::JointTorque);
  EXPECT_EQ(arm.wrenchFrame, haptics::devices::WrenchFrame::Base);
  EXPECT_EQ(arm.tool.position.z(), 0.25);
  ASSERT_TRUE(arm.zero);
  EXPECT_DOUBLE_EQ((*arm.zero)[3], -std::numbers::pi / 2.0);
  EXPECT_DOUBLE_EQ(arm.margins.position, 6.0 * std::numbers::pi / 180.0);
  EXPECT_EQ(arm.margins.torque, 0.4);
  EXPECT_EQ(std::get<SimulatedSettings>((*devices)[2].settings).kind, &reamerKind());
}

TEST(DeviceFile, ReadsWhatItWrites) {
  questionnaires::Problems problems;
  const auto devices = readDevices(kBoth, problems);
  ASSERT_TRUE(devices);
  const auto again = readDevices(devicesAsJson(*devices), problems);
  ASSERT_TRUE(again) << questionnaires::describe(problems.all());
  EXPECT_EQ(devicesAsJson(*again), devicesAsJson(*devices));
  const auto& arm = std::get<haptics::devices::IiwaSettings>((*again)[1].settings);
  EXPECT_NEAR(arm.margins.position, 6.0 * std::numbers::pi / 180.0, 1e-12);
  EXPECT_EQ(std::get<SerialPunchSettings>((*again)[0].settings).punch.build, 0x00112233445566ffU);
}

TEST(DeviceFile, ReportsAllProblemsAtOnce) {
  const auto words = objectionsTo(R"({
    "format": "palpate-devices-2",
    "devices": [
      {"id": "punch", "type": "punch-serial", "port": "/dev/ttyACM0", "newtons_per_volt": 0,
       "expiry_ms": 21, "firmware": "beef", "travel_per_count": -0.01},
      {"id": "punch", "type": "iiwa-fri", "robot_address": "robot.local", "fri_version": "3.0",
       "axis": [0, 0], "zero_joints_deg": [1, 2, 3], "margins": {"speed": 1}},
      {"id": "x", "type": "phantom"},
      {"id": "y", "type": "simulated-punch", "port": "/dev/null"}
    ]
  })");
  for (const auto* part :
       {"$.format",
        "newtons_per_volt",
        "expiry_ms",
        "16 hexadecimal digits",
        "travel_per_count",
        "another device has it already",
        "no numeric IPv4 address",
        "'3.0' is not known",
        "there are 2 numbers and not 3",
        "there are 3 numbers and not 7",
        "speed",
        "'phantom' is not known",
        "$.devices[3]"}) {
    EXPECT_TRUE(says(words, part));
  }
}

TEST(DeviceFile, RefusesUnknownSpeedsOfSerialPorts) {
  const auto words = objectionsTo(R"({"format": "palpate-devices-1", "devices": [
        {"id": "p", "type": "punch-serial", "port": "a", "newtons_per_volt": 1, "baud": 9600}]})");
  EXPECT_TRUE(says(words, "cannot go at 9600 baud"));
  EXPECT_TRUE(
      says(words, "write 0 for USB, or one of 115200, 230400, 460800, 921600, 1000000, 2000000"));
}

TEST(DeviceFile, ReportsThatAVersionNeedsQuotes) {
  const auto words = objectionsTo(R"({"format": "palpate-devices-1", "devices": [
        {"id": "r", "type": "iiwa-fri", "robot_address": "127.0.0.1", "fri_version": 1.15}]})");
  EXPECT_TRUE(says(words, "fri_version"));
  EXPECT_TRUE(says(words, R"("1.15")"));
  EXPECT_TRUE(says(words, "with its quotes"));
}

TEST(DeviceFile, WritesWholeDegreesWithoutRoundingErrors) {
  DeviceEntry reamer{.id = "reamer", .settings = haptics::devices::IiwaSettings{}};
  auto& arm = std::get<haptics::devices::IiwaSettings>(reamer.settings);
  arm.zero = haptics::wire::fri::Joints{0.0, std::numbers::pi / 6.0, 0.0, -std::numbers::pi / 2.0};
  const auto text = devicesAsJson({reamer});
  EXPECT_TRUE(says(text, "\"position_deg\": 5.0,"));
  EXPECT_TRUE(says(text, " 30.0,"));
  EXPECT_TRUE(says(text, " -90.0,"));
}

TEST(DeviceFile, SuggestsTheIntendedKey) {
  EXPECT_TRUE(says(
      objectionsTo(R"({"format": "palpate-devices-1", "devices": [
        {"id": "p", "type": "punch-serial", "port": "a", "newton_per_volt": 1}]})"),
      "newtons_per_volt"));
}

TEST(DeviceFile, CanBeCopiedFromTheDocumentation) {
  const auto page = tests::contentOf((tests::repository() / "docs/devices.md").string());
  const std::string begin = "```json\n";
  int files = 0;
  for (auto at = page.find(begin); at != std::string::npos; at = page.find(begin, at + 1)) {
    const auto from = at + begin.size();
    questionnaires::Problems problems;
    EXPECT_TRUE(readDevices(page.substr(from, page.find("```", from) - from), problems))
        << questionnaires::describe(problems.all());
    ++files;
  }
  EXPECT_EQ(files, 2);
}

TEST(DeviceFile, HasEveryKeyInTheDocumentation) {
  const auto page = tests::contentOf((tests::repository() / "docs/devices.md").string());
  const std::string text = kBoth;
  int keys = 0;
  for (auto colon = text.find("\":"); colon != std::string::npos;
       colon = text.find("\":", colon + 1)) {
    const auto quote = text.rfind('"', colon - 1);
    EXPECT_TRUE(says(page, "`" + text.substr(quote + 1, colon - quote - 1) + "`"));
    ++keys;
  }
  EXPECT_GT(keys, 10);
}

TEST(HardwareDeviceSet, RefusesDevicesThatTheFileDoesNotList) {
  questionnaires::Problems problems;
  HardwareDeviceSet deviceSet(
      *readDevices(kBoth, problems),
      [](const protocols::DeviceRequirement& need) { return simulatedHandFor(need, 1, {}, 0); });
  const auto refusal = [&](const protocols::DeviceRequirement& need) {
    try {
      deviceSet.device(need);
    } catch (const std::exception& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_TRUE(says(refusal({.id = "knife"}), "'knife'"));
  EXPECT_TRUE(says(refusal({.id = "spare", .kind = &punchKind()}), "needs a punch as 'spare'"));
  EXPECT_TRUE(says(refusal({.id = "punch", .kind = &punchKind()}), "There is no serial port"));
  EXPECT_FALSE(deviceSet.isOpen("punch"));
  EXPECT_EQ(refusal({.id = "spare", .kind = &reamerKind()}), "");
  EXPECT_TRUE(deviceSet.isOpen("spare"));
}

TEST(Preflight, WarnsIfTheProtocolNeedsMoreForceThanTheDeviceHas) {
  questionnaires::Problems problems;
  HardwareDeviceSet deviceSet(
      *readDevices(kBoth, problems),
      [](const protocols::DeviceRequirement& need) { return simulatedHandFor(need, 1, {}, 0); });
  protocols::Protocol protocol;
  protocol.devices = {{.id = "spare", .kind = &reamerKind(), .maxForce = 300.0}};
  const auto found = preflight(*deviceSet.find("spare"), &protocol, "spare", 0.1);
  EXPECT_EQ(found.back().finding, haptics::devices::Finding::Warn);
  EXPECT_EQ(base::describe(found.back().measured), "300 N of 140 N");
  EXPECT_TRUE(says(base::describe(found.back().fix), "force_scale"));
}

TEST(Preflight, WarnsOfADeviceThatIsTooSlowForTheStiffestScene) {
  questionnaires::Problems problems;
  auto loaded = protocols::loadProtocolFile("reaming-hardness", problems);
  ASSERT_TRUE(loaded);
  const auto& need = loaded->protocol.devices.front();
  const auto hand = simulatedHandFor(need, 1, {}, 0);
  const auto dampingAt = [&](double rate) {
    auto capabilities = haptics::devices::simulated(reamerKind());
    capabilities.damping = 60.0;
    capabilities.rate = rate;
    haptics::devices::SimulatedDevice device(capabilities, reamerKind().mechanism, *hand);
    for (auto& result : preflight(device, &loaded->protocol, need.id, 0.1)) {
      if (result.what.key() == "preflight.damping") return result;
    }
    return haptics::devices::CheckResult{};
  };
  EXPECT_EQ(dampingAt(500.0).finding, haptics::devices::Finding::Pass);
  const auto slow = dampingAt(200.0);
  EXPECT_EQ(slow.finding, haptics::devices::Finding::Warn);
  EXPECT_EQ(base::describe(slow.measured), "up to 125 of 60 N·s/m at 200 Hz") << "K T/2";
}

TEST(Preflight, PassesNothingOfADeviceThatIsNotThere) {
  questionnaires::Problems problems;
  HardwareDeviceSet deviceSet(
      *readDevices(kBoth, problems),
      [](const protocols::DeviceRequirement& need) { return simulatedHandFor(need, 1, {}, 0); });
  protocols::Protocol protocol;
  protocol.devices = {{.id = "punch", .kind = &punchKind(), .maxForce = 1.0}};
  for (const auto& result : preflight(*deviceSet.find("punch"), &protocol, "punch", 0.1)) {
    EXPECT_EQ(result.finding, haptics::devices::Finding::Fail) << base::describe(result.what);
  }
}

}  // namespace device_file_test
}  // namespace study

// The codec of FRI on the golden datagrams of tests/data/fri.
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/haptics/wire/fri_datagrams.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_data.h"

namespace haptics::wire::fri {
namespace fri_golden_test {

using namespace fri_datagrams;

using nlohmann::json;

/// Messages as the golden file writes them.
template <typename Choice>
json nameIn(std::initializer_list<const char*> names, Choice value) {
  return *(names.begin() + static_cast<std::size_t>(value));
}

json describe(std::uint32_t value) {
  return value;
}
json describe(std::int32_t value) {
  return value;
}
json describe(std::uint64_t value) {
  return value;
}
json describe(double value) {
  return value;
}
json describe(const Name& value) {
  return value.text();
}
json describe(const Joints& value) {
  return {{"value", value}};
}
json describe(const Vector6& value) {
  return {{"element", value}};
}
json describe(SessionState value) {
  return nameIn(
      {"IDLE", "MONITORING_WAIT", "MONITORING_READY", "COMMANDING_WAIT", "COMMANDING_ACTIVE"},
      value);
}
json describe(ConnectionQuality value) {
  return nameIn({"POOR", "FAIR", "GOOD", "EXCELLENT"}, value);
}
json describe(SafetyState value) {
  return nameIn(
      {"NORMAL_OPERATION", "SAFETY_STOP_LEVEL_0", "SAFETY_STOP_LEVEL_1", "SAFETY_STOP_LEVEL_2"},
      value);
}
json describe(OperationMode value) {
  return nameIn({"TEST_MODE_1", "TEST_MODE_2", "AUTOMATIC_MODE"}, value);
}
json describe(DriveState value) {
  return nameIn({"DRIVE_OFF", "DRIVE_TRANSITIONING", "DRIVE_ACTIVE"}, value);
}
json describe(ControlMode value) {
  return nameIn(
      {"POSITION_CONTROL", "CARTESIAN_IMPEDANCE_CONTROL", "JOINT_IMPEDANCE_CONTROL", "NO_CONTROL"},
      value);
}
json describe(ClientCommandMode value) {
  return nameIn({"NO_COMMAND_MODE", "JOINT_POSITION", "WRENCH", "TORQUE", "CARTESIAN_POSE"}, value);
}
json describe(OverlayType value) {
  return nameIn({"NO_OVERLAY", "JOINT_OVERLAY", "CARTESIAN_OVERLAY"}, value);
}
json describe(IoType value) {
  return nameIn({"IO_BOOLEAN", "IO_DIGITAL", "IO_ANALOG"}, value);
}
json describe(IoDirection value) {
  return nameIn({"IO_INPUT", "IO_OUTPUT"}, value);
}
json describe(RedundancyStrategy value) {
  return value == RedundancyStrategy::E1 ? "REDUNDANCY_E1" : "REDUNDANCY_NONE";
}

// Messages hold messages.
json describe(const Header& m);
json describe(const TimeStamp& m);
json describe(const Transformation& m);
json describe(const IoValue& m);
json describe(const Redundancy& m);
json describe(const ConnectionInfo& m);
json describe(const RobotInfo& m);
json describe(const MonitorData& m);
json describe(const IpoData& m);
json describe(const CommandData& m);
json describe(const EndOfMessage::Checksum& m);
json describe(const EndOfMessage& m);

/// Puts together an object of what is there.
class Object {
 public:
  template <typename T>
  Object& with(const char* key, const T& value) {
    object_[key] = describe(value);
    return *this;
  }
  template <typename T>
  Object& with(const char* key, const std::optional<T>& value) {
    return value ? with(key, *value) : *this;
  }
  template <typename T, std::size_t N>
  Object& with(const char* key, const BoundedArray<T, N>& list) {
    for (const T& item : list) object_[key].push_back(describe(item));
    return *this;
  }
  operator json() const { return object_; }  // NOLINT(google-explicit-constructor)

 private:
  json object_ = json::object();
};

json describe(const Header& m) {
  return Object()
      .with("message_identifier", m.identifier)
      .with("sequence_counter", m.sequence)
      .with("reflected_sequence_counter", m.reflected);
}
json describe(const TimeStamp& m) {
  return Object().with("sec", m.seconds).with("nanosec", m.nanoseconds);
}
json describe(const Transformation& m) {
  return Object().with("name", m.name).with("element", m.elements).with("timestamp", m.timestamp);
}
json describe(const IoValue& m) {
  return Object()
      .with("name", m.name)
      .with("type", m.type)
      .with("direction", m.direction)
      .with("digital_value", m.digital)
      .with("analog_value", m.analog);
}
json describe(const Redundancy& m) {
  return Object().with("strategy", m.strategy).with("value", m.value);
}
json describe(const ConnectionInfo& m) {
  return Object()
      .with("session_state", m.state)
      .with("quality", m.quality)
      .with("send_period", m.sendPeriod)
      .with("receive_multiplier", m.receiveMultiplier);
}
json describe(const RobotInfo& m) {
  return Object()
      .with("number_of_joints", m.jointCount)
      .with("safety_state", m.safetyState)
      .with("drive_state", m.driveStates)
      .with("operation_mode", m.operationMode)
      .with("control_mode", m.controlMode);
}
json describe(const MonitorData& m) {
  return Object()
      .with("measured_joint_position", m.measuredPosition)
      .with("measured_torque", m.measuredTorque)
      .with("commanded_joint_position", m.commandedPosition)
      .with("commanded_torque", m.commandedTorque)
      .with("external_torque", m.externalTorque)
      .with("external_force", m.externalForce)
      .with("read_io", m.inputs)
      .with("measured_cartesian_pose", m.pose)
      .with("measured_redundancy", m.redundancy)
      .with("timestamp", m.timestamp);
}
json describe(const IpoData& m) {
  return Object()
      .with("joint_position", m.jointPosition)
      .with("cartesian_pose", m.pose)
      .with("redundancy", m.redundancy)
      .with("client_command_mode", m.commandMode)
      .with("overlay_type", m.overlay)
      .with("tracking_performance", m.trackingPerformance);
}
json describe(const CommandData& m) {
  return Object()
      .with("joint_position", m.jointPosition)
      .with("wrench", m.wrench)
      .with("joint_torque", m.jointTorque)
      .with("commanded_transformation", m.transformations)
      .with("write_io", m.outputs)
      .with("cartesian_pose", m.pose)
      .with("redundancy", m.redundancy);
}
json describe(const EndOfMessage::Checksum& m) {
  return Object().with("crc32", m.crc32);
}
json describe(const EndOfMessage& m) {
  return Object().with("message_length", m.length).with("message_checksum", m.checksum);
}
json describe(const MonitoringMessage& m) {
  return Object()
      .with("header", m.header)
      .with("robot_info", m.robotInfo)
      .with("monitor_data", m.monitorData)
      .with("connection_info", m.connection)
      .with("ipo_data", m.ipoData)
      .with("requested_transformation", m.requestedTransformations)
      .with("end_of_message", m.endOfMessage);
}
json describe(const CommandMessage& m) {
  return Object()
      .with("header", m.header)
      .with("command_data", m.data)
      .with("end_of_message", m.endOfMessage);
}

struct GoldenCase {
  std::string id;
  Version version = Version::V1_15;
  bool isMonitoring = false;
  bool isCanonical = false;
  std::string refusal;
  Bytes bytes;
  json decoded;
};

std::vector<GoldenCase> goldenCases() {
  const json file = json::parse(tests::contentOf(tests::testData("fri/golden.json")));
  std::vector<GoldenCase> cases;
  for (const json& entry : file.at("cases")) {
    cases.push_back(
        {entry.at("id"),
         versionNamed(entry.at("version").get<std::string>()).value(),
         entry.at("direction") == "monitoring",
         entry.at("canonical"),
         entry.at("reason").is_null() ? "none" : entry.at("reason").get<std::string>(),
         bytesOf(entry.at("hex")),
         entry.at("decoded")});
  }
  return cases;
}

template <typename Message>
void expectMeaning(const GoldenCase& golden) {
  const Message untouched{.header = {1, 2, 3}};
  Message message = untouched;
  const Refusal refusal = decode(golden.bytes, golden.version, message);
  EXPECT_EQ(nameOf(refusal), golden.refusal);
  if (refusal != Refusal::None) {
    EXPECT_EQ(message, untouched);
    return;
  }
  EXPECT_EQ(describe(message), golden.decoded);
  if (golden.isCanonical) {
    EXPECT_EQ(encoded(message, golden.version), golden.bytes);
  }
}

TEST(FriGolden, ReadsRefusesAndWritesTheGoldenDatagrams) {
  int accepted = 0;
  int canonical = 0;
  for (const GoldenCase& golden : goldenCases()) {
    SCOPED_TRACE(golden.id);
    golden.isMonitoring ? expectMeaning<MonitoringMessage>(golden)
                        : expectMeaning<CommandMessage>(golden);
    accepted += golden.refusal == "none" ? 1 : 0;
    canonical += golden.isCanonical ? 1 : 0;
  }
  EXPECT_EQ(accepted, 34);
  EXPECT_EQ(canonical, 24);
}

/// Reads it twice, as either message: always the same answer, and what is taken can be written,
/// and is read again as the same as far as the version knows it.
template <typename Message>
Refusal steadyVerdict(std::span<const std::uint8_t> bytes, Version version) {
  Message first;
  Message second;
  const Refusal refusal = decode(bytes, version, first);
  EXPECT_EQ(decode(bytes, version, second), refusal);
  EXPECT_EQ(first, second);
  if (refusal != Refusal::None) return refusal;
  const Bytes once = encoded(first, version);
  EXPECT_FALSE(once.empty());
  EXPECT_EQ(decode(once, version, second), Refusal::None);
  EXPECT_EQ(encoded(second, version), once);
  return refusal;
}

TEST(FriGolden, SurvivesEveryTruncationAndEveryChangedByte) {
  for (const GoldenCase& golden : goldenCases()) {
    SCOPED_TRACE(golden.id);
    const auto verdict =
        golden.isMonitoring ? steadyVerdict<MonitoringMessage> : steadyVerdict<CommandMessage>;
    const auto other =
        golden.isMonitoring ? steadyVerdict<CommandMessage> : steadyVerdict<MonitoringMessage>;
    const bool isGuarded = golden.version == Version::V2_7 && golden.refusal == "none";
    EXPECT_TRUE(golden.refusal != "none" || other(golden.bytes, golden.version) != Refusal::None);
    for (std::size_t size = 0; size < golden.bytes.size(); ++size) {
      const std::span<const std::uint8_t> cut(golden.bytes.data(), size);
      const Refusal refusal = verdict(cut, golden.version);
      EXPECT_TRUE(!isGuarded || refusal != Refusal::None);
    }
    Bytes changed = golden.bytes;
    for (std::size_t i = 0; i < changed.size(); ++i) {
      for (const unsigned flip : {1U, 2U, 4U, 8U, 0x10U, 0x20U, 0x40U, 0x80U, 0xFFU}) {
        changed[i] = static_cast<std::uint8_t>(golden.bytes[i] ^ flip);
        const Refusal refusal = verdict(changed, golden.version);
        EXPECT_TRUE(!isGuarded || refusal != Refusal::None);
      }
      changed[i] = golden.bytes[i];
    }
  }
}

}  // namespace fri_golden_test
}  // namespace haptics::wire::fri

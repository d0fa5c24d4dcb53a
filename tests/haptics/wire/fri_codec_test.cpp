#include "haptics/wire/fri_codec.h"

#include <array>
#include <bit>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "haptics/wire/crc32.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_data.h"

namespace haptics::wire::fri {
namespace fri_codec_test {

using nlohmann::json;
using Bytes = std::vector<std::uint8_t>;

constexpr Joints kJoints{0.1, 0.2, 0.3, -1.0, 0.4, 0.5, 0.6};

Bytes bytesOf(const std::string& hex) {
  Bytes bytes;
  for (std::size_t i = 0; i < hex.size(); i += 2) {
    bytes.push_back(static_cast<std::uint8_t>(std::stoul(hex.substr(i, 2), nullptr, 16)));
  }
  return bytes;
}

template <typename Message>
Bytes encoded(const Message& message, Version version) {
  std::array<std::uint8_t, kLargestDatagram> out{};
  const std::size_t size = encode(message, version, out);
  return {out.begin(), out.begin() + static_cast<std::ptrdiff_t>(size)};
}

/// What is to be sent inside a frame of 2.7.
Bytes framed(const Bytes& inside) {
  Bytes bytes;
  const auto add = [&](std::uint32_t word) {
    for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<std::uint8_t>(word >> (8 * i)));
  };
  add(static_cast<std::uint32_t>(inside.size()));
  bytes.insert(bytes.end(), inside.begin(), inside.end());
  add(crc32(inside.data(), inside.size()));
  return bytes;
}

// ---- messages as the golden file writes them ----

template <typename Choice>
json nameIn(std::initializer_list<const char*> names, Choice value) {
  return *(names.begin() + static_cast<std::size_t>(value));
}

json inWords(std::uint32_t value) {
  return value;
}
json inWords(std::int32_t value) {
  return value;
}
json inWords(std::uint64_t value) {
  return value;
}
json inWords(double value) {
  return value;
}
json inWords(const Name& value) {
  return value.text();
}
json inWords(const Joints& value) {
  return {{"value", value}};
}
json inWords(const Vector6& value) {
  return {{"element", value}};
}
json inWords(SessionState value) {
  return nameIn(
      {"IDLE", "MONITORING_WAIT", "MONITORING_READY", "COMMANDING_WAIT", "COMMANDING_ACTIVE"},
      value);
}
json inWords(ConnectionQuality value) {
  return nameIn({"POOR", "FAIR", "GOOD", "EXCELLENT"}, value);
}
json inWords(SafetyState value) {
  return nameIn(
      {"NORMAL_OPERATION", "SAFETY_STOP_LEVEL_0", "SAFETY_STOP_LEVEL_1", "SAFETY_STOP_LEVEL_2"},
      value);
}
json inWords(OperationMode value) {
  return nameIn({"TEST_MODE_1", "TEST_MODE_2", "AUTOMATIC_MODE"}, value);
}
json inWords(DriveState value) {
  return nameIn({"DRIVE_OFF", "DRIVE_TRANSITIONING", "DRIVE_ACTIVE"}, value);
}
json inWords(ControlMode value) {
  return nameIn(
      {"POSITION_CONTROL", "CARTESIAN_IMPEDANCE_CONTROL", "JOINT_IMPEDANCE_CONTROL", "NO_CONTROL"},
      value);
}
json inWords(ClientCommandMode value) {
  return nameIn({"NO_COMMAND_MODE", "JOINT_POSITION", "WRENCH", "TORQUE", "CARTESIAN_POSE"}, value);
}
json inWords(OverlayType value) {
  return nameIn({"NO_OVERLAY", "JOINT_OVERLAY", "CARTESIAN_OVERLAY"}, value);
}
json inWords(IoType value) {
  return nameIn({"IO_BOOLEAN", "IO_DIGITAL", "IO_ANALOG"}, value);
}
json inWords(IoDirection value) {
  return nameIn({"IO_INPUT", "IO_OUTPUT"}, value);
}
json inWords(RedundancyStrategy value) {
  return value == RedundancyStrategy::E1 ? "REDUNDANCY_E1" : "REDUNDANCY_NONE";
}

// Messages hold messages.
json inWords(const Header& m);
json inWords(const TimeStamp& m);
json inWords(const Transformation& m);
json inWords(const IoValue& m);
json inWords(const Redundancy& m);
json inWords(const ConnectionInfo& m);
json inWords(const RobotInfo& m);
json inWords(const MonitorData& m);
json inWords(const IpoData& m);
json inWords(const CommandData& m);
json inWords(const EndOfMessage::Checksum& m);
json inWords(const EndOfMessage& m);

/// Puts together an object of what is there.
class Object {
 public:
  template <typename T>
  Object& with(const char* key, const T& value) {
    object_[key] = inWords(value);
    return *this;
  }
  template <typename T>
  Object& with(const char* key, const std::optional<T>& value) {
    return value ? with(key, *value) : *this;
  }
  template <typename T, std::size_t N>
  Object& with(const char* key, const List<T, N>& list) {
    for (const T& item : list) object_[key].push_back(inWords(item));
    return *this;
  }
  operator json() const { return object_; }  // NOLINT(google-explicit-constructor)

 private:
  json object_ = json::object();
};

json inWords(const Header& m) {
  return Object()
      .with("message_identifier", m.identifier)
      .with("sequence_counter", m.sequence)
      .with("reflected_sequence_counter", m.reflected);
}
json inWords(const TimeStamp& m) {
  return Object().with("sec", m.seconds).with("nanosec", m.nanoseconds);
}
json inWords(const Transformation& m) {
  return Object().with("name", m.name).with("element", m.elements).with("timestamp", m.timestamp);
}
json inWords(const IoValue& m) {
  return Object()
      .with("name", m.name)
      .with("type", m.type)
      .with("direction", m.direction)
      .with("digital_value", m.digital)
      .with("analog_value", m.analog);
}
json inWords(const Redundancy& m) {
  return Object().with("strategy", m.strategy).with("value", m.value);
}
json inWords(const ConnectionInfo& m) {
  return Object()
      .with("session_state", m.state)
      .with("quality", m.quality)
      .with("send_period", m.sendPeriod)
      .with("receive_multiplier", m.receiveMultiplier);
}
json inWords(const RobotInfo& m) {
  return Object()
      .with("number_of_joints", m.jointCount)
      .with("safety_state", m.safetyState)
      .with("drive_state", m.driveStates)
      .with("operation_mode", m.operationMode)
      .with("control_mode", m.controlMode);
}
json inWords(const MonitorData& m) {
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
json inWords(const IpoData& m) {
  return Object()
      .with("joint_position", m.jointPosition)
      .with("cartesian_pose", m.pose)
      .with("redundancy", m.redundancy)
      .with("client_command_mode", m.commandMode)
      .with("overlay_type", m.overlay)
      .with("tracking_performance", m.trackingPerformance);
}
json inWords(const CommandData& m) {
  return Object()
      .with("joint_position", m.jointPosition)
      .with("wrench", m.wrench)
      .with("joint_torque", m.jointTorque)
      .with("commanded_transformation", m.transformations)
      .with("write_io", m.outputs)
      .with("cartesian_pose", m.pose)
      .with("redundancy", m.redundancy);
}
json inWords(const EndOfMessage::Checksum& m) {
  return Object().with("crc32", m.crc32);
}
json inWords(const EndOfMessage& m) {
  return Object().with("message_length", m.length).with("message_checksum", m.checksum);
}
json inWords(const MonitoringMessage& m) {
  return Object()
      .with("header", m.header)
      .with("robot_info", m.robotInfo)
      .with("monitor_data", m.monitorData)
      .with("connection_info", m.connection)
      .with("ipo_data", m.ipoData)
      .with("requested_transformation", m.requestedTransformations)
      .with("end_of_message", m.endOfMessage);
}
json inWords(const CommandMessage& m) {
  return Object()
      .with("header", m.header)
      .with("command_data", m.data)
      .with("end_of_message", m.endOfMessage);
}

// ---- the golden datagrams ----

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
  EXPECT_EQ(inWords(message), golden.decoded);
  if (golden.isCanonical) {
    EXPECT_EQ(encoded(message, golden.version), golden.bytes);
  }
}

TEST(FriCodec, ReadsRefusesAndWritesTheGoldenDatagrams) {
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

TEST(FriCodec, SurvivesEveryTruncationAndEveryChangedByte) {
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

// ---- what needs no shared data ----

constexpr auto kObserved =
    "0a0a0881800d10d70418d70412410a3f099a9999999999b93f099a9999999999c93f09333333333333d33f09000000"
    "000000f0bf099a9999999999d93f09000000000000e03f09333333333333e33f";

CommandMessage observed() {
  return {.header = {kCommand, 599, 599}, .data = CommandData{.jointPosition = kJoints}};
}

/// As much as a message can hold in practice.
MonitoringMessage full() {
  MonitoringMessage message{.header = {kMonitoring, 600, 598}};
  message.robotInfo = RobotInfo{7, SafetyState::NormalOperation, {}, OperationMode::Automatic, {}};
  for (int i = 0; i < 7; ++i) *message.robotInfo->driveStates.add() = DriveState::Active;
  Transformation pose{.name = Name("Tool"), .timestamp = TimeStamp{1700000000, 1}};
  for (const double element : {0.5, 0.0, 0.6, 1.0, 0.0, 0.0, 0.0}) *pose.elements.add() = element;
  MonitorData data{.measuredPosition = kJoints, .commandedPosition = kJoints};
  data.externalForce = Vector6{1, 2, 3, 4, 5, 6};
  *data.inputs.add() = {Name("Pedal"), IoType::Boolean, IoDirection::Input, 1, {}};
  data.pose = pose;
  data.redundancy = Redundancy{RedundancyStrategy::None, 0.25};
  message.monitorData = data;
  message.connection =
      ConnectionInfo{SessionState::CommandingActive, ConnectionQuality::Good, 1, 1};
  message.ipoData = IpoData{kJoints, pose, data.redundancy, ClientCommandMode::CartesianPose};
  *message.requestedTransformations.add() = pose;
  message.endOfMessage = EndOfMessage{-1, EndOfMessage::Checksum{-2}};
  return message;
}

TEST(FriCodec, WritesAndReadsWhatWasObserved) {
  const Bytes expected = bytesOf(kObserved);
  ASSERT_EQ(expected.size(), 79U);
  EXPECT_EQ(encoded(observed(), Version::V1_15), expected);
  CommandMessage message;
  EXPECT_EQ(decode(expected, Version::V1_15, message), Refusal::None);
  EXPECT_EQ(message, observed());
}

/// A field of so many bytes, below 16 384, as protobuf writes it.
Bytes field(int number, const Bytes& content) {
  Bytes bytes{static_cast<std::uint8_t>(number << 3 | 2)};
  const auto size = content.size();
  if (size < 0x80) {
    bytes.push_back(static_cast<std::uint8_t>(size));
  } else {
    bytes.push_back(static_cast<std::uint8_t>((size & 0x7f) | 0x80));
    bytes.push_back(static_cast<std::uint8_t>(size >> 7));
  }
  bytes.insert(bytes.end(), content.begin(), content.end());
  return bytes;
}

Joints jointsFrom(double first) {
  Joints joints{};
  for (double& joint : joints) joint = first++;
  return joints;
}

/// The values of seven joints: field 1, seven times, each with eight bytes.
Bytes onTheWire(const Joints& joints) {
  Bytes bytes;
  for (const double joint : joints) {
    bytes.push_back(1 << 3 | 1);
    const auto bits = std::bit_cast<std::uint64_t>(joint);
    for (int i = 0; i < 8; ++i) bytes.push_back(static_cast<std::uint8_t>(bits >> (8 * i)));
  }
  return bytes;
}

TEST(FriCodec, ReadsAndWritesTheValuesOfJointsInTheFieldsOfTheirNumbers) {
  // Fields 1 to 5 of the monitor data, in the order of tests/data/fri/fri_messages.proto.
  Bytes data;
  for (int number = 1; number <= 5; ++number) {
    const auto joints = field(number, onTheWire(jointsFrom(10.0 * number)));
    data.insert(data.end(), joints.begin(), joints.end());
  }
  auto datagram = encoded(MonitoringMessage{.header = {kMonitoring, 600, 598}}, Version::V1_15);
  const auto monitorData = field(3, data);
  datagram.insert(datagram.end(), monitorData.begin(), monitorData.end());

  MonitoringMessage message;
  ASSERT_EQ(decode(datagram, Version::V1_15, message), Refusal::None);
  ASSERT_TRUE(message.monitorData.has_value());
  EXPECT_EQ(message.monitorData->measuredPosition, jointsFrom(10.0));
  EXPECT_EQ(message.monitorData->measuredTorque, jointsFrom(20.0));
  EXPECT_EQ(message.monitorData->commandedPosition, jointsFrom(30.0));
  EXPECT_EQ(message.monitorData->commandedTorque, jointsFrom(40.0));
  EXPECT_EQ(message.monitorData->externalTorque, jointsFrom(50.0));
  EXPECT_EQ(encoded(message, Version::V1_15), datagram);
}

TEST(FriCodec, HasTheObservedSizes) {
  CommandMessage wrench = observed();
  wrench.data->wrench = Vector6{};
  EXPECT_EQ(encoded(wrench, Version::V1_15).size(), 131U);
  CommandMessage torque = observed();
  torque.data->jointTorque = kJoints;
  EXPECT_EQ(encoded(torque, Version::V1_15).size(), 145U);
  EXPECT_EQ(encoded(torque, Version::V2_7).size(), 153U);
}

TEST(FriCodec, FramesWithTheChecksumOfZlib) {
  const std::string check = "123456789";
  EXPECT_EQ(crc32(Bytes(check.begin(), check.end()).data(), 9), 0xCBF43926U);
  EXPECT_EQ(encoded(observed(), Version::V2_7), framed(bytesOf(kObserved)));
}

TEST(FriCodec, LeavesOutWhatAVersionDoesNotKnow) {
  const MonitoringMessage whole = full();
  for (const std::string_view name : kVersionNames) {
    SCOPED_TRACE(name);
    const Version version = versionNamed(name).value();
    const bool isTwo = version >= Version::V2_5;
    MonitoringMessage expected = whole;
    if (version == Version::V1_11) expected.monitorData->inputs = {};
    if (isTwo) expected.monitorData->commandedPosition.reset();
    if (version != Version::V2_7) expected.monitorData->externalForce.reset();
    if (version == Version::V2_7) expected.endOfMessage.reset();
    if (!isTwo) {
      expected.monitorData->pose.reset();
      expected.monitorData->redundancy.reset();
      expected.ipoData = IpoData{.jointPosition = kJoints};
    }
    MonitoringMessage message;
    EXPECT_EQ(decode(encoded(whole, version), version, message), Refusal::None);
    EXPECT_EQ(message, expected);
  }
}

TEST(FriCodec, KnowsItsVersionsByName) {
  EXPECT_EQ(versionNamed("1.11"), Version::V1_11);
  EXPECT_EQ(versionNamed("2.7"), Version::V2_7);
  EXPECT_EQ(versionNamed("2.6"), std::nullopt);
  for (const std::string_view name : kVersionNames) {
    EXPECT_EQ(nameOf(versionNamed(name).value()), name);
  }
}

TEST(FriCodec, NeverSendsWhatIsNotFiniteOrDoesNotExist) {
  for (const double bad : {std::nan(""), double{INFINITY}, -double{INFINITY}}) {
    CommandMessage message = observed();
    message.data->jointTorque = kJoints;
    (*message.data->jointTorque)[6] = bad;
    EXPECT_TRUE(encoded(message, Version::V1_15).empty());
    MonitoringMessage other = full();
    other.ipoData->trackingPerformance = bad;
    EXPECT_TRUE(encoded(other, Version::V2_7).empty());
  }
  MonitoringMessage unknown = full();
  unknown.connection->state = static_cast<SessionState>(5);
  EXPECT_TRUE(encoded(unknown, Version::V2_5).empty());
  unknown = full();
  unknown.monitorData->redundancy->strategy = static_cast<RedundancyStrategy>(2);
  EXPECT_TRUE(encoded(unknown, Version::V2_5).empty());
  EXPECT_FALSE(encoded(unknown, Version::V1_16).empty());
}

TEST(FriCodec, WritesNothingBeyondTheBuffer) {
  const MonitoringMessage message = full();
  for (const Version version : {Version::V1_15, Version::V2_7}) {
    const Bytes whole = encoded(message, version);
    for (std::size_t size = 0; size <= whole.size(); ++size) {
      Bytes buffer(size);  // on the heap, where the sanitizer sees one byte too many
      EXPECT_EQ(encode(message, version, buffer), size < whole.size() ? 0 : size);
    }
  }
}

TEST(FriCodec, WritesNoDatagramThatNobodyTakes) {
  MonitoringMessage message = full();
  const std::string name(63, 'x');
  while (IoValue* const value = message.monitorData->inputs.add()) value->name = Name(name);
  for (int i = 0; i < 4; ++i) {
    Transformation& added = *message.requestedTransformations.add();
    added.name = Name(name);
    added.elements.count = 7;
  }
  std::array<std::uint8_t, 4000> out{};
  EXPECT_EQ(encode(message, Version::V2_7, out), 0U);
  message.requestedTransformations.count = 1;
  EXPECT_GT(encode(message, Version::V2_7, out), 1000U);
}

/// A sound command with something behind it.
Refusal refusalWith(const std::string& hexBehind, Version version = Version::V1_15) {
  Bytes bytes = bytesOf("0a080881800d10001800" + hexBehind);
  if (version == Version::V2_7) bytes = framed(bytes);
  CommandMessage message;
  return decode(bytes, version, message);
}

std::string repeated(const std::string& piece, int times) {
  std::string whole;
  for (int i = 0; i < times; ++i) whole += piece;
  return whole;
}

TEST(FriCodec, PassesOverGroupsAsDeepAsProtobufDoes) {
  EXPECT_EQ(refusalWith(repeated("9b06", 100) + repeated("9c06", 100)), Refusal::None);
  EXPECT_EQ(refusalWith(repeated("9b06", 101) + repeated("9c06", 101)), Refusal::Malformed);
  EXPECT_EQ(refusalWith(repeated("9b06", 700)), Refusal::Malformed);
  EXPECT_EQ(refusalWith("9b069c06"), Refusal::None);
  EXPECT_EQ(refusalWith("9b06a406"), Refusal::Malformed) << "the end of another group";
  EXPECT_EQ(refusalWith("9c06"), Refusal::Malformed) << "an end without a beginning";
  EXPECT_EQ(
      refusalWith("1202"
                  "9b06"
                  "9c06"),
      Refusal::Malformed)
      << "open at the end of its message";
}

TEST(FriCodec, RefusesWhatProtobufCannotRead) {
  const std::string doubles = repeated("00", 48);
  EXPECT_EQ(
      refusalWith(
          "1234"
          "1232"
          "0a30" +
          doubles),
      Refusal::None);
  EXPECT_EQ(
      refusalWith(
          "1235"
          "1233"
          "0a31" +
          doubles + "00"),
      Refusal::Malformed)
      << "49 bytes";
  EXPECT_EQ(refusalWith("12022202"), Refusal::Malformed) << "a message beyond its message";
  EXPECT_EQ(
      refusalWith("98868080"
                  "00"
                  "01"),
      Refusal::None)
      << "a tag of five bytes";
  EXPECT_EQ(
      refusalWith("98868080"
                  "8000"
                  "01"),
      Refusal::Malformed)
      << "and of six";
  EXPECT_EQ(
      refusalWith("9a06"
                  "8180808000"
                  "07"),
      Refusal::None)
      << "a length of five bytes";
  EXPECT_EQ(
      refusalWith("9a06"
                  "818080808000"
                  "07"),
      Refusal::Malformed)
      << "and of six";
  EXPECT_EQ(refusalWith("9806" + repeated("ff", 9) + "7f"), Refusal::None);
  EXPECT_EQ(refusalWith("9806" + repeated("ff", 10) + "01"), Refusal::Malformed);
  EXPECT_EQ(refusalWith("0801"), Refusal::None) << "a header of another type is no header";
  const std::string transformations = repeated("22020a00", 5);
  EXPECT_EQ(refusalWith("1216" + transformations + "2200"), Refusal::Malformed) << "without a name";
}

TEST(FriCodec, RefusesAPackedDriveStateThatIsCutOff) {
  MonitoringMessage message;
  const auto refusal = [&](const std::string& robotInfo) {
    const Bytes bytes = bytesOf("0a0908c2a291011000180012" + robotInfo);
    return decode(bytes, Version::V1_15, message);
  };
  EXPECT_EQ(refusal("042a020201"), Refusal::None);
  EXPECT_EQ(message.robotInfo->driveStates.count, 2U);
  EXPECT_EQ(refusal("042a020282"), Refusal::Malformed);
}

TEST(FriCodec, RefusesMoreThanAMessageHolds) {
  const std::string output =
      "2a06"
      "0a00"
      "1000"
      "1800";  // 8 bytes
  const std::string transformation =
      "2202"
      "0a00";  // 4 bytes
  EXPECT_EQ(refusalWith("1250" + repeated(output, 10)), Refusal::None);
  EXPECT_EQ(refusalWith("1258" + repeated(output, 11)), Refusal::ElementCount);
  EXPECT_EQ(refusalWith("1214" + repeated(transformation, 5)), Refusal::None);
  EXPECT_EQ(refusalWith("1218" + repeated(transformation, 6)), Refusal::ElementCount);
  EXPECT_EQ(
      refusalWith(
          "12432241"
          "0a3f" +
          repeated("78", 63)),
      Refusal::None);
  EXPECT_EQ(
      refusalWith(
          "12442242"
          "0a40" +
          repeated("78", 64)),
      Refusal::ElementCount);
}

TEST(FriCodec, TakesTheElementsOfATransformationThatItsVersionHas) {
  const std::string seven =
      "123e223c"
      "0a00"
      "1238" +
      repeated("00", 56);
  const std::string twelve =
      "12662264"
      "0a00"
      "1260" +
      repeated("00", 96);
  const std::string thirteen =
      "126e226c"
      "0a00"
      "1268" +
      repeated("00", 104);
  EXPECT_EQ(refusalWith(seven, Version::V1_11), Refusal::None);
  EXPECT_EQ(refusalWith(seven, Version::V2_7), Refusal::None);
  EXPECT_EQ(refusalWith(twelve, Version::V1_16), Refusal::None);
  EXPECT_EQ(refusalWith(twelve, Version::V2_5), Refusal::ElementCount);
  EXPECT_EQ(refusalWith(thirteen, Version::V1_16), Refusal::ElementCount);
}

TEST(FriCodec, AllocatesNothing) {
  std::array<std::uint8_t, kLargestDatagram> out{};
  const MonitoringMessage message = full();
  MonitoringMessage again;
  const tests::AllocationCounter allocations;
  for (int i = 0; i < 100; ++i) {
    const std::size_t size = encode(message, Version::V2_7, out);
    ASSERT_EQ(decode({out.data(), size}, Version::V2_7, again), Refusal::None);
    ASSERT_EQ(decode({out.data(), size - 1}, Version::V2_7, again), Refusal::LengthMismatch);
    ASSERT_EQ(decode({out.data(), size}, Version::V1_15, again), Refusal::Malformed);
  }
  EXPECT_EQ(allocations.count(), 0U);
}

}  // namespace fri_codec_test
}  // namespace haptics::wire::fri

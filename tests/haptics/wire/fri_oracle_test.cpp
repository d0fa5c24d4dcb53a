#include <fri_messages.pb.h>  // made by protoc from fri_messages.proto
#include <google/protobuf/stubs/logging.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "haptics/wire/crc32.h"
#include "haptics/wire/fri_codec.h"

// The hand-written codec against Google's protobuf: what that writes we read, what we write are its
// bytes, and of what was damaged both say the same.

namespace haptics::wire::fri {
namespace fri_oracle_test {

namespace pb = palpate::fri;
using google::protobuf::FieldDescriptor;
using google::protobuf::Reflection;
using PbMessage = google::protobuf::Message;

// ---- our messages as protobuf's ----

void copy(const Joints& from, pb::JointValues& to) {
  for (const double value : from) to.add_value(value);
}

void copy(const Vector6& from, pb::CartesianVector& to) {
  for (const double value : from) to.add_element(value);
}

void copy(const TimeStamp& from, pb::TimeStamp& to) {
  to.set_sec(from.seconds);
  to.set_nanosec(from.nanoseconds);
}

void copy(const Transformation& from, pb::Transformation& to) {
  to.set_name(std::string(from.name.text()));
  for (const double element : from.elements) to.add_element(element);
  if (from.timestamp) copy(*from.timestamp, *to.mutable_timestamp());
}

void copy(const IoValue& from, pb::IoValue& to) {
  to.set_name(std::string(from.name.text()));
  to.set_type(static_cast<pb::IoType>(from.type));
  to.set_direction(static_cast<pb::IoDirection>(from.direction));
  if (from.digital) to.set_digital_value(*from.digital);
  if (from.analog) to.set_analog_value(*from.analog);
}

void copy(const Redundancy& from, pb::RedundancyInformation& to) {
  to.set_strategy(static_cast<pb::RedundancyStrategy>(from.strategy));
  to.set_value(from.value);
}

void copy(const Header& from, pb::MessageHeader& to) {
  to.set_message_identifier(from.identifier);
  to.set_sequence_counter(from.sequence);
  to.set_reflected_sequence_counter(from.reflected);
}

void copy(const ConnectionInfo& from, pb::ConnectionInfo& to) {
  to.set_session_state(static_cast<pb::SessionState>(from.state));
  to.set_quality(static_cast<pb::ConnectionQuality>(from.quality));
  if (from.sendPeriod) to.set_send_period(*from.sendPeriod);
  if (from.receiveMultiplier) to.set_receive_multiplier(*from.receiveMultiplier);
}

void copy(const RobotInfo& from, pb::RobotInfo& to) {
  if (from.jointCount) to.set_number_of_joints(*from.jointCount);
  if (from.safetyState) to.set_safety_state(static_cast<pb::SafetyState>(*from.safetyState));
  for (const DriveState state : from.driveStates) {
    to.add_drive_state(static_cast<pb::DriveState>(state));
  }
  if (from.operationMode) {
    to.set_operation_mode(static_cast<pb::OperationMode>(*from.operationMode));
  }
  if (from.controlMode) to.set_control_mode(static_cast<pb::ControlMode>(*from.controlMode));
}

void copy(const MonitorData& from, pb::MonitorData& to) {
  if (from.measuredPosition) copy(*from.measuredPosition, *to.mutable_measured_joint_position());
  if (from.measuredTorque) copy(*from.measuredTorque, *to.mutable_measured_torque());
  if (from.commandedPosition) copy(*from.commandedPosition, *to.mutable_commanded_joint_position());
  if (from.commandedTorque) copy(*from.commandedTorque, *to.mutable_commanded_torque());
  if (from.externalTorque) copy(*from.externalTorque, *to.mutable_external_torque());
  if (from.externalForce) copy(*from.externalForce, *to.mutable_external_force());
  for (const IoValue& input : from.inputs) copy(input, *to.add_read_io());
  if (from.pose) copy(*from.pose, *to.mutable_measured_cartesian_pose());
  if (from.redundancy) copy(*from.redundancy, *to.mutable_measured_redundancy());
  if (from.timestamp) copy(*from.timestamp, *to.mutable_timestamp());
}

void copy(const IpoData& from, pb::IpoData& to) {
  if (from.jointPosition) copy(*from.jointPosition, *to.mutable_joint_position());
  if (from.pose) copy(*from.pose, *to.mutable_cartesian_pose());
  if (from.redundancy) copy(*from.redundancy, *to.mutable_redundancy());
  if (from.commandMode) {
    to.set_client_command_mode(static_cast<pb::ClientCommandMode>(*from.commandMode));
  }
  if (from.overlay) to.set_overlay_type(static_cast<pb::OverlayType>(*from.overlay));
  if (from.trackingPerformance) to.set_tracking_performance(*from.trackingPerformance);
}

void copy(const CommandData& from, pb::CommandData& to) {
  if (from.jointPosition) copy(*from.jointPosition, *to.mutable_joint_position());
  if (from.wrench) copy(*from.wrench, *to.mutable_wrench());
  if (from.jointTorque) copy(*from.jointTorque, *to.mutable_joint_torque());
  for (const Transformation& item : from.transformations) {
    copy(item, *to.add_commanded_transformation());
  }
  for (const IoValue& output : from.outputs) copy(output, *to.add_write_io());
  if (from.pose) copy(*from.pose, *to.mutable_cartesian_pose());
  if (from.redundancy) copy(*from.redundancy, *to.mutable_redundancy());
}

void copy(const EndOfMessage& from, pb::EndOfMessage& to) {
  if (from.length) to.set_message_length(*from.length);
  if (!from.checksum) return;
  to.mutable_message_checksum();
  if (from.checksum->crc32) to.mutable_message_checksum()->set_crc32(*from.checksum->crc32);
}

void copy(const MonitoringMessage& from, pb::MonitoringMessage& to) {
  copy(from.header, *to.mutable_header());
  if (from.robotInfo) copy(*from.robotInfo, *to.mutable_robot_info());
  if (from.monitorData) copy(*from.monitorData, *to.mutable_monitor_data());
  if (from.connection) copy(*from.connection, *to.mutable_connection_info());
  if (from.ipoData) copy(*from.ipoData, *to.mutable_ipo_data());
  for (const Transformation& item : from.requestedTransformations) {
    copy(item, *to.add_requested_transformation());
  }
  if (from.endOfMessage) copy(*from.endOfMessage, *to.mutable_end_of_message());
}

void copy(const CommandMessage& from, pb::CommandMessage& to) {
  copy(from.header, *to.mutable_header());
  if (from.data) copy(*from.data, *to.mutable_command_data());
  if (from.endOfMessage) copy(*from.endOfMessage, *to.mutable_end_of_message());
}

// ---- what protobuf's messages may hold ----

struct Range {
  int least;
  int most;
};

/// How often a field may be there that can be there several times.
Range rangeOf(const FieldDescriptor& field, Version version) {
  static const std::map<std::string_view, Range> kRanges{
      {"palpate.fri.JointValues.value", {7, 7}},
      {"palpate.fri.CartesianVector.element", {6, 6}},
      {"palpate.fri.RobotInfo.drive_state", {0, 7}},
      {"palpate.fri.MonitorData.read_io", {0, 10}},
      {"palpate.fri.CommandData.write_io", {0, 10}},
      {"palpate.fri.CommandData.commanded_transformation", {0, 5}},
      {"palpate.fri.MonitoringMessage.requested_transformation", {0, 5}}};
  if (field.full_name() == "palpate.fri.Transformation.element") {
    return {0, version >= Version::V2_5 ? 7 : 12};
  }
  return kRanges.at(field.full_name());
}

bool isKnown(const FieldDescriptor& field, Version version) {
  static const std::map<std::string_view, std::pair<Version, Version>> kKnown{
      {"palpate.fri.MonitorData.commanded_joint_position", {Version::V1_11, Version::V1_16}},
      {"palpate.fri.MonitorData.external_force", {Version::V2_7, Version::V2_7}},
      {"palpate.fri.MonitorData.read_io", {Version::V1_14, Version::V2_7}},
      {"palpate.fri.MonitorData.measured_cartesian_pose", {Version::V2_5, Version::V2_7}},
      {"palpate.fri.MonitorData.measured_redundancy", {Version::V2_5, Version::V2_7}},
      {"palpate.fri.IpoData.cartesian_pose", {Version::V2_5, Version::V2_7}},
      {"palpate.fri.IpoData.redundancy", {Version::V2_5, Version::V2_7}},
      {"palpate.fri.CommandData.write_io", {Version::V1_14, Version::V2_7}},
      {"palpate.fri.CommandData.cartesian_pose", {Version::V2_5, Version::V2_7}},
      {"palpate.fri.CommandData.redundancy", {Version::V2_5, Version::V2_7}},
      {"palpate.fri.MonitoringMessage.end_of_message", {Version::V1_11, Version::V2_5}},
      {"palpate.fri.CommandMessage.end_of_message", {Version::V1_11, Version::V2_5}}};
  const auto row = kKnown.find(field.full_name());
  return row == kKnown.end() || (version >= row->second.first && version <= row->second.second);
}

void forEachMessageIn(PbMessage& message, const FieldDescriptor& field, const auto& then) {
  const Reflection& reflection = *message.GetReflection();
  if (!field.is_repeated()) return then(*reflection.MutableMessage(&message, &field));
  for (int i = 0; i < reflection.FieldSize(message, &field); ++i) {
    then(*reflection.MutableRepeatedMessage(&message, &field, i));
  }
}

/// Takes away what a version does not know.
void restrictTo(Version version, PbMessage& message) {
  const Reflection& reflection = *message.GetReflection();
  std::vector<const FieldDescriptor*> fields;
  reflection.ListFields(message, &fields);
  for (const FieldDescriptor* field : fields) {
    const bool isMode = field->full_name() == "palpate.fri.IpoData.client_command_mode";
    const bool isUnknownMode = isMode && version < Version::V2_5 &&
                               reflection.GetEnumValue(message, field) == pb::CARTESIAN_POSE;
    if (!isKnown(*field, version) || isUnknownMode) {
      reflection.ClearField(&message, field);
    } else if (field->cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE) {
      forEachMessageIn(message, *field, [&](PbMessage& inside) { restrictTo(version, inside); });
    }
  }
}

// ---- random messages ----

class Chance {
 public:
  explicit Chance(unsigned seed) : random_(seed) {}

  bool happens(double probability) { return std::bernoulli_distribution(probability)(random_); }
  int between(int least, int most) {
    return std::uniform_int_distribution<int>(least, most)(random_);
  }
  std::size_t below(std::size_t end) {
    return std::uniform_int_distribution<std::size_t>(0, end - 1)(random_);
  }
  std::uint64_t bits() { return random_() >> between(0, 63); }

  double finite() {
    if (happens(0.5)) return between(-8, 8) / 4.0;
    const auto value = std::bit_cast<double>(random_());
    return std::isfinite(value) ? value : -0.0;
  }

  std::string text() {
    std::string text(static_cast<std::size_t>(happens(0.1) ? 63 : between(0, 12)), ' ');
    for (char& c : text) c = static_cast<char>(between(0, 127));
    return text;
  }

  /// Every field of every version, perhaps.
  void fill(PbMessage& message, Version version) {
    for (int i = 0; i < message.GetDescriptor()->field_count(); ++i) {
      const FieldDescriptor& field = *message.GetDescriptor()->field(i);
      if (field.is_repeated()) {
        const Range range = rangeOf(field, version);
        const bool isShort = field.cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE;
        const int most = isShort && happens(0.9) ? 1 : range.most;
        for (int n = between(std::min(range.least, most), most); n > 0; --n) {
          set(message, field, version);
        }
      } else if (field.is_required() || happens(0.6)) {
        set(message, field, version);
      }
    }
  }

 private:
  void set(PbMessage& message, const FieldDescriptor& field, Version version) {
    const Reflection& reflection = *message.GetReflection();
    const bool isList = field.is_repeated();
    switch (field.cpp_type()) {
      case FieldDescriptor::CPPTYPE_MESSAGE:
        return fill(
            isList ? *reflection.AddMessage(&message, &field)
                   : *reflection.MutableMessage(&message, &field),
            version);
      case FieldDescriptor::CPPTYPE_ENUM: {
        const auto& values = *field.enum_type();
        const auto* const value = values.value(between(0, values.value_count() - 1));
        return isList ? reflection.AddEnum(&message, &field, value)
                      : reflection.SetEnum(&message, &field, value);
      }
      case FieldDescriptor::CPPTYPE_DOUBLE:
        return isList ? reflection.AddDouble(&message, &field, finite())
                      : reflection.SetDouble(&message, &field, finite());
      case FieldDescriptor::CPPTYPE_STRING:
        return reflection.SetString(&message, &field, text());
      case FieldDescriptor::CPPTYPE_UINT32:
        return reflection.SetUInt32(&message, &field, static_cast<std::uint32_t>(bits()));
      case FieldDescriptor::CPPTYPE_UINT64:
        return reflection.SetUInt64(&message, &field, bits());
      default:
        return reflection.SetInt32(&message, &field, static_cast<std::int32_t>(bits()));
    }
  }

  std::mt19937_64 random_;
};

template <typename Ours>
struct Peer;
template <>
struct Peer<MonitoringMessage> {
  using Type = pb::MonitoringMessage;
};
template <>
struct Peer<CommandMessage> {
  using Type = pb::CommandMessage;
};

template <typename Ours>
typename Peer<Ours>::Type madeUp(Chance& chance, Version version) {
  typename Peer<Ours>::Type message;
  chance.fill(message, version);
  message.mutable_header()->set_message_identifier(Ours{}.header.identifier);
  if constexpr (std::is_same_v<Ours, MonitoringMessage>) {
    if (message.connection_info().session_state() >= pb::COMMANDING_WAIT &&
        !message.ipo_data().has_joint_position()) {
      copy(Joints{1, 2, 3, 4, 5, 6, 7}, *message.mutable_ipo_data()->mutable_joint_position());
    }
  }
  return message;
}

// ---- bytes ----

std::string framed(const std::string& inside, Version version) {
  if (version != Version::V2_7) return inside;
  const auto word = [](std::size_t value) {
    std::string bytes;
    for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xFFU);
    return bytes;
  };
  const auto* const bytes = reinterpret_cast<const std::uint8_t*>(inside.data());
  return word(inside.size()) + inside + word(crc32(bytes, inside.size()));
}

template <typename Ours>
Refusal decodeText(const std::string& bytes, Version version, Ours& out) {
  return decode({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, version, out);
}

template <typename Ours>
std::string encodeText(const Ours& message, Version version) {
  std::array<std::uint8_t, kLargestDatagram> out{};
  const std::size_t size = encode(message, version, out);
  return {reinterpret_cast<const char*>(out.data()), size};
}

template <typename Ours>
std::string asProtobufWritesIt(const Ours& message) {
  typename Peer<Ours>::Type same;
  copy(message, same);
  return same.SerializeAsString();
}

template <typename Ours>
void expectSameBytes(unsigned seed, Version version, int times) {
  Chance chance(seed);
  int tooLong = 0;
  for (int i = 0; i < times; ++i) {
    auto message = madeUp<Ours>(chance, version);
    const std::string sent = framed(message.SerializeAsString(), version);
    Ours ours;
    const Refusal refusal = decodeText(sent, version, ours);
    if (sent.size() > kLargestDatagram) {
      ASSERT_EQ(refusal, Refusal::TooLong);
      ++tooLong;
      continue;
    }
    ASSERT_EQ(refusal, Refusal::None) << nameOf(refusal) << '\n' << message.DebugString();
    ASSERT_EQ(asProtobufWritesIt(ours), message.SerializeAsString()) << message.DebugString();
    restrictTo(version, message);
    ASSERT_EQ(encodeText(ours, version), framed(message.SerializeAsString(), version))
        << message.DebugString();
  }
  EXPECT_LT(tooLong, times / 4);
}

TEST(FriOracle, ReadsAndWritesLikeProtobuf) {
  unsigned seed = 2707;
  for (const std::string_view name : kVersionNames) {
    SCOPED_TRACE(name);
    expectSameBytes<MonitoringMessage>(seed++, versionNamed(name).value(), 1000);
    expectSameBytes<CommandMessage>(seed++, versionNamed(name).value(), 1000);
  }
}

// ---- damage ----

/// Finds the first thing that a careful receiver refuses, in ascending order of fields.
class Inspector {
 public:
  explicit Inspector(Version version) : version_(version) {}

  void inspect(PbMessage& message) {
    const Reflection& reflection = *message.GetReflection();
    const std::string& type = message.GetDescriptor()->full_name();
    if (type == "palpate.fri.JointValues") {
      expect(static_cast<pb::JointValues&>(message).value_size() == 7, Refusal::JointCount);
    }
    std::vector<const FieldDescriptor*> fields;
    reflection.ListFields(message, &fields);
    if (type == "palpate.fri.CartesianVector" && fields.empty()) expect(false, kElements);
    for (const FieldDescriptor* field : fields) inspectField(message, *field);
  }

  Refusal first() const { return first_; }
  bool isOverfull() const { return isOverfull_; }

 private:
  static constexpr Refusal kElements = Refusal::ElementCount;

  void inspectField(PbMessage& message, const FieldDescriptor& field) {
    const Reflection& reflection = *message.GetReflection();
    const int size = field.is_repeated() ? reflection.FieldSize(message, &field) : 1;
    if (field.is_repeated()) {
      const Range range = rangeOf(field, version_);
      const bool isExact = range.least > 0;
      if (size > (field.full_name().ends_with("Transformation.element") ? 12 : range.most)) {
        isOverfull_ = isOverfull_ || !isExact;
      }
      expect(size >= range.least && size <= range.most, kElements);
    }
    if (field.cpp_type() == FieldDescriptor::CPPTYPE_STRING) {
      isOverfull_ = isOverfull_ || reflection.GetString(message, &field).size() > 63;
    } else if (field.cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE) {
      forEachMessageIn(message, field, [&](PbMessage& inside) { inspect(inside); });
    } else if (field.cpp_type() == FieldDescriptor::CPPTYPE_DOUBLE) {
      for (int i = 0; i < size; ++i) {
        const double value = field.is_repeated() ? reflection.GetRepeatedDouble(message, &field, i)
                                                 : reflection.GetDouble(message, &field);
        expect(std::isfinite(value), Refusal::NotFinite);
      }
    }
  }

  void expect(bool isTrue, Refusal otherwise) {
    if (!isTrue && first_ == Refusal::None) first_ = otherwise;
  }

  Version version_;
  Refusal first_ = Refusal::None;
  bool isOverfull_ = false;
};

bool misses(const pb::MonitoringMessage& message) {
  return message.connection_info().session_state() >= pb::COMMANDING_WAIT &&
         !message.ipo_data().has_joint_position();
}

bool misses(const pb::CommandMessage& /*message*/) {
  return false;
}

/// What the rules say of bytes that protobuf has read.
template <typename Ours>
Refusal verdict(const std::string& bytes, Version version, typename Peer<Ours>::Type& message) {
  if (bytes.size() + (version == Version::V2_7 ? 8 : 0) > kLargestDatagram) {
    return Refusal::TooLong;
  }
  if (!message.ParsePartialFromString(bytes) || !message.IsInitialized()) return Refusal::Malformed;
  message.DiscardUnknownFields();
  if (message.header().message_identifier() != Ours{}.header.identifier) {
    return Refusal::WrongIdentifier;
  }
  Inspector inspector(version);
  inspector.inspect(message);
  if (inspector.isOverfull()) return Refusal::ElementCount;
  if (inspector.first() != Refusal::None) return inspector.first();
  return misses(message) ? Refusal::MissingIpoJointPosition : Refusal::None;
}

/// Fields that nobody knows, sound and unsound, and known ones as nobody writes them.
std::string oddPiece(Chance& chance) {
  using namespace std::string_view_literals;
  constexpr std::array kPieces{
      "\x9b\x06\x9c\x06"sv,                                          // a group
      "\x9b\x06\xa3\x06\x08\x01\xa4\x06\x9c\x06"sv,                  // a group in a group
      "\x9b\x06\xa4\x06"sv,                                          // the end of another one
      "\x9c\x06"sv,                                                  // an end without a beginning
      "\x9d\x06\x01\x02\x03\x04"sv,                                  // fixed32
      "\x99\x06\x01\x02\x03\x04\x05\x06\x07\x08"sv,                  // fixed64
      "\x98\x06\xff\xff\xff\xff\xff\xff\xff\xff\xff\x7f"sv,          // a varint of ten bytes
      "\x98\x06\xff\xff\xff\xff\xff\xff\xff\xff\xff\xff\x01"sv,      // and of eleven
      "\x98\x86\x80\x80\x00\x01"sv,                                  // a tag of five bytes
      "\x98\x86\x80\x80\x80\x00\x01"sv,                              // and of six
      "\x9a\x86\x80\x80\x70\x01\x00"sv,                              // a tag that overflows
      "\x9a\x06\x82\x80\x80\x80\x00\x01\x02"sv,                      // a length of five bytes
      "\x9a\x06\x82\x80\x80\x80\x80\x00\x01\x02"sv,                  // and of six
      "\x9a\x06\x82\x80\x80\x80\x10\x01\x02"sv,                      // a length that overflows
      "\x0a\x0c\x08\xc2\xa2\x91\x81\xf0\xff\xff\xff\xff\x01\x00"sv,  // an identifier that does
      "\x22\x06\x08\x82\x80\x80\x80\x10"sv,                          // a session state that does: 2
      "\x12\x07\x2a\x05\x02\x01\x09\x00\x02"sv,  // packed drive states, one unknown
      "\x00"sv,
      "\x9e\x06"sv,
      "\x08\x01"sv};  // a header that is a number
  return std::string(kPieces[chance.below(kPieces.size())]);
}

std::string damaged(std::string bytes, const std::string& other, Chance& chance) {
  for (int n = chance.between(1, 3); n > 0; --n) {
    const std::size_t at = chance.below(bytes.size() + 1);
    const std::size_t from = chance.below(other.size());
    switch (chance.between(0, 9)) {
      case 0:
        bytes.resize(at);
        break;
      case 1:
        bytes += other.substr(from, chance.below(40));
        break;
      case 2:
        bytes += other;  // merged
        break;
      case 3:
        bytes.insert(at, other.substr(from, chance.below(12)));
        break;
      case 4:
        bytes.erase(at, chance.below(12));
        break;
      case 5:
        bytes += oddPiece(chance);
        break;
      case 6:
        bytes.insert(0, oddPiece(chance));
        break;
      case 7:
        if (at + 2 <= bytes.size()) bytes.replace(at, 2, "\xf0\x7f");  // perhaps an infinity
        break;
      default:
        if (at < bytes.size()) bytes[at] = static_cast<char>(chance.between(-128, 127));
    }
  }
  return bytes;
}

template <typename Ours>
void expectSameVerdict(
    unsigned seed, Version version, int times, std::map<std::string_view, int>& counts) {
  Chance chance(seed);
  for (int i = 0; i < times; ++i) {
    const std::string one = madeUp<Ours>(chance, version).SerializeAsString();
    const std::string two = madeUp<Ours>(chance, version).SerializeAsString();
    const std::string bytes = damaged(one, two, chance);
    typename Peer<Ours>::Type message;
    const Refusal expected = verdict<Ours>(bytes, version, message);
    Ours ours;
    const Refusal refusal = decodeText(framed(bytes, version), version, ours);
    ASSERT_EQ(nameOf(refusal), nameOf(expected)) << i << '\n' << message.ShortDebugString();
    ++counts[nameOf(refusal)];
    if (refusal == Refusal::None) {
      ASSERT_EQ(asProtobufWritesIt(ours), message.SerializeAsString()) << i;
    }
  }
}

TEST(FriOracle, JudgesDamagedDatagramsLikeProtobuf) {
  const google::protobuf::LogSilencer quiet;  // it complains about names that are no UTF-8
  std::map<std::string_view, int> counts;
  unsigned seed = 3112;
  for (const std::string_view name : kVersionNames) {
    SCOPED_TRACE(name);
    const Version version = versionNamed(name).value();
    expectSameVerdict<MonitoringMessage>(seed++, version, 2000, counts);
    expectSameVerdict<CommandMessage>(seed++, version, 2000, counts);
  }
  for (const std::string_view reason :
       {"none",
        "too_long",
        "malformed",
        "wrong_identifier",
        "joint_count",
        "element_count",
        "not_finite",
        "missing_ipo_joint_position"}) {
    EXPECT_GT(counts[reason], 0) << reason;
    RecordProperty(std::string(reason), counts[reason]);
  }
}

}  // namespace fri_oracle_test
}  // namespace haptics::wire::fri

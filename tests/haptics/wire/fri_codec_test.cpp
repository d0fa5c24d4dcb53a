// The codec of FRI: what is written and read back, what is left out and what is refused.
#include <array>
#include <bit>
#include <cmath>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "tests/haptics/wire/fri_datagrams.h"
#include "tests/support/allocation_counter.h"

namespace haptics::wire::fri {
namespace fri_codec_test {

using namespace fri_datagrams;

constexpr auto kObserved =
    "0a0a0881800d10d70418d70412410a3f099a9999999999b93f099a9999999999c93f09333333333333d33f09000000"
    "000000f0bf099a9999999999d93f09000000000000e03f09333333333333e33f";

CommandMessage observed() {
  return {.header = {kCommand, 599, 599}, .data = CommandData{.jointPosition = kJoints}};
}

TEST(FriCodec, WritesAndReadsObservedMessages) {
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

TEST(FriCodec, LeavesOutFieldsThatAVersionDoesNotHave) {
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

TEST(FriCodec, NeverSendsNonFiniteOrInvalidValues) {
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

TEST(FriCodec, WritesNoDatagramLargerThanTheLimit) {
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

TEST(FriCodec, RefusesInvalidProtobuf) {
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

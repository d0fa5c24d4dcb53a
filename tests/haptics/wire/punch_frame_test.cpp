#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "haptics/wire/punch_codec.h"

namespace haptics::wire::punch {
namespace punch_frame_test {

using Bytes = std::vector<uint8_t>;

template <typename Message>
Bytes onWire(const Message& message, uint16_t sequence = 1, uint32_t time = 2) {
  Bytes bytes(kLargestOnWire);
  bytes.resize(encode(message, sequence, time, bytes.data()));
  return bytes;
}

/// The frames in @p bytes, their payloads copied.
struct Found {
  Frame frame;
  Bytes payload;
};
std::vector<Found> framesIn(const Bytes& bytes, FrameDecoder& decoder) {
  std::vector<Found> found;
  Frame frame;
  for (const auto byte : bytes) {
    if (!decoder.take(byte, frame)) continue;
    found.push_back({frame, Bytes(frame.payload, frame.payload + frame.size)});
    found.back().frame.payload = nullptr;
  }
  return found;
}

template <typename Message>
Message roundTrip(const Message& message) {
  FrameDecoder decoder;
  Frame frame;
  Message result;
  for (const auto byte : onWire(message, 0xABCD, 0x12345678)) {
    if (!decoder.take(byte, frame)) continue;
    EXPECT_EQ(frame.type, Message::kType);
    EXPECT_EQ(frame.sequence, 0xABCD);
    EXPECT_EQ(frame.time, 0x12345678U);
    EXPECT_TRUE(read(frame, result));
    return result;
  }
  ADD_FAILURE() << "no frame came out";
  return result;
}

TEST(PunchCodec, RoundTripsEveryMessage) {
  const auto hello = roundTrip(Hello{
      .protocolVersion = 7,
      .build = 0x1122334455667788,
      .serial = 99,
      .counts = 8192,
      .rate = 1000,
      .largestVoltage = -12,
      .largestSlew = 1200});
  EXPECT_EQ(hello.build, 0x1122334455667788U);
  EXPECT_EQ(hello.serial, 99U);
  EXPECT_EQ(hello.largestVoltage, -12);
  EXPECT_EQ(hello.largestSlew, 1200);
  EXPECT_TRUE(roundTrip(Arm{.isArmed = true, .expiry = 7}).isArmed);
  EXPECT_EQ(roundTrip(SetForce{.voltage = -12000, .expiry = 3}).voltage, -12000);
  const auto state = roundTrip(State{
      .counts = -70000,
      .velocity = 123456,
      .voltage = -5,
      .faults = 0x91,
      .echo = 65535,
      .lateLoops = 3,
      .badFrames = 4,
      .isRendering = true});
  EXPECT_EQ(state.counts, -70000);
  EXPECT_EQ(state.velocity, 123456);
  EXPECT_EQ(state.faults, 0x91);
  EXPECT_EQ(state.echo, 65535);
  EXPECT_TRUE(state.isRendering);
  EXPECT_EQ(roundTrip(Event{EventCode::TooFast, 0xFFFFFFFF}).value, 0xFFFFFFFFU);
  Model model{.kind = ModelKind::Kalman, .tableSize = 74, .travelPerCount = -0.00439F};
  model.noise[5] = 2.5F;
  EXPECT_EQ(roundTrip(model).travelPerCount, -0.00439F);
  EXPECT_EQ(roundTrip(model).noise[5], 2.5F);
  ModelTable table{.first = 16, .count = 16};
  table.force[15] = 4.25F;
  EXPECT_EQ(roundTrip(table).force[15], 4.25F);
  EXPECT_EQ(
      roundTrip(ModelReply{ModelVerdict::InvalidModel, 5}).verdict, ModelVerdict::InvalidModel);
  EXPECT_EQ(roundTrip(Render{.hash = 0xDEADBEEF, .expiry = 20}).hash, 0xDEADBEEFU);
  EXPECT_EQ(roundTrip(Stop{StopReason::HostFault}).reason, StopReason::HostFault);
}

TEST(PunchCodec, RefusesInvalidValuesOfMessages) {
  const auto isRead = [](const auto& message, auto into) {
    FrameDecoder decoder;
    Frame frame;
    for (const auto byte : onWire(message)) {
      if (decoder.take(byte, frame)) return read(frame, into);
    }
    return true;
  };
  EXPECT_FALSE(isRead(SetForce{.voltage = 1, .expiry = 0}, SetForce{}));
  EXPECT_FALSE(isRead(SetForce{.voltage = 1, .expiry = 21}, SetForce{}));
  EXPECT_FALSE(isRead(Render{.expiry = 21}, Render{}));
  EXPECT_FALSE(isRead(Model{.travelPerCount = std::numeric_limits<float>::quiet_NaN()}, Model{}));
  EXPECT_FALSE(isRead(Model{.equationVariants = 16}, Model{}));
  EXPECT_FALSE(isRead(Model{.tableSize = 129}, Model{}));
  EXPECT_FALSE(isRead(ModelTable{.first = 120, .count = 16}, ModelTable{}));
  EXPECT_FALSE(isRead(ModelTable{.count = 17}, ModelTable{}));
  EXPECT_FALSE(isRead(Arm{.expiry = 0}, Arm{}));
  EXPECT_FALSE(isRead(ModelReply{.verdict = ModelVerdict{4}}, ModelReply{}));
  EXPECT_FALSE(isRead(SetForce{}, State{})) << "another message's length";
}

TEST(FrameDecoder, FindsTheNextWholeFrameAfterAnything) {
  std::mt19937 random(11);
  FrameDecoder decoder;
  uint32_t damagedBefore = 0;
  for (int round = 0; round < 3000; ++round) {
    const Bytes good = onWire(State{.counts = round}, static_cast<uint16_t>(round));
    Bytes bytes;
    const int kind = round % 4;
    const bool isBroken = kind != 0;
    if (kind == 1) {  // garbage that ends like a frame
      for (int i = 0; i < 40; ++i) bytes.push_back(static_cast<uint8_t>(1 + random() % 255));
      bytes.push_back(0);
    } else if (kind == 2) {  // one byte of a frame is another
      bytes = good;
      const size_t at = random() % (bytes.size() - 1);
      bytes[at] = static_cast<uint8_t>(bytes[at] == 255 ? 1 : bytes[at] + 1);
    } else if (kind == 3) {  // its end is missing
      bytes.assign(
          good.begin(), good.begin() + 1 + static_cast<long>(random() % (good.size() - 2)));
      bytes.push_back(0);
    }
    bytes.insert(bytes.end(), good.begin(), good.end());
    const auto found = framesIn(bytes, decoder);
    ASSERT_EQ(found.size(), 1U) << "round " << round;
    ASSERT_EQ(found[0].frame.sequence, static_cast<uint16_t>(round));
    ASSERT_EQ(decoder.damaged() - damagedBefore, isBroken ? 1U : 0U) << "round " << round;
    damagedBefore = decoder.damaged();
  }
}

TEST(FrameDecoder, TakesNoFrameLongerThanAnyMessage) {
  FrameDecoder decoder;
  Bytes bytes(5000, 0x01);
  bytes.push_back(0);
  EXPECT_TRUE(framesIn(bytes, decoder).empty());
  EXPECT_EQ(decoder.damaged(), 1U);
  EXPECT_EQ(framesIn(onWire(Stop{}), decoder).size(), 1U);
}

TEST(FrameDecoder, DetectsEverySingleDamagedBit) {
  const Bytes good = onWire(SetForce{.voltage = 4321, .expiry = 10}, 77, 88);
  for (size_t bit = 0; bit < 8 * (good.size() - 1); ++bit) {
    Bytes bytes = good;
    bytes[bit / 8] = static_cast<uint8_t>(bytes[bit / 8] ^ (1U << (bit % 8)));
    FrameDecoder decoder;
    EXPECT_TRUE(framesIn(bytes, decoder).empty()) << "bit " << bit;
  }
}

}  // namespace punch_frame_test
}  // namespace haptics::wire::punch

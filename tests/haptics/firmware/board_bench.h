#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "haptics/firmware/punch_program.h"

/// The punch's own program on hardware that a test plays: its clock, its encoder, its line.
namespace haptics::firmware::board_bench {

using namespace wire::punch;
using Bytes = std::vector<std::uint8_t>;

inline constexpr std::uint32_t kMillisecond = 1000;  // [µs]

/// Does what the test says, and remembers what was said.
struct Bench {
  std::uint32_t time = 0;
  std::int32_t position = 0;
  std::int16_t voltage = 0;
  bool isFaulty = false;
  std::deque<std::uint8_t> toBoard;
  Bytes fromBoard;

  std::uint32_t micros() const { return time; }
  std::int32_t counts() const { return position; }
  void drive(std::int16_t millivolts) { voltage = millivolts; }
  bool hasDriverFault() const { return isFaulty; }
  int read() {
    if (toBoard.empty()) return -1;
    const int byte = toBoard.front();
    toBoard.pop_front();
    return byte;
  }
  void write(const std::uint8_t* bytes, std::size_t count) {
    fromBoard.insert(fromBoard.end(), bytes, bytes + count);
  }
};

template <typename Message>
Bytes payloadOf(const Message& message) {
  Bytes payload(kLargestPayload);
  Writer writer(payload.data());
  write(writer, message);
  payload.resize(writer.size());
  return payload;
}

template <typename Message>
Bytes onWire(const Message& message, std::uint16_t sequence) {
  Bytes bytes(kLargestOnWire);
  bytes.resize(encode(message, sequence, 0, bytes.data()));
  return bytes;
}

/// What the board has said, by type.
struct Said {
  std::vector<Hello> hellos;
  std::vector<State> states;
  std::vector<Event> events;
  std::vector<ModelReply> taken;
  std::vector<Stop> stops;

  std::size_t frames() const {
    return hellos.size() + states.size() + events.size() + taken.size() + stops.size();
  }
  long count(EventCode code) const {
    return std::count_if(
        events.begin(), events.end(), [&](const Event& event) { return event.code == code; });
  }
};

inline PunchLimits limits() {
  return {.build = 0x1122334455667788, .serial = 7};
}

/// A host that says what the test wants, a board, and time that passes when the test says so.
class BoardBench : public testing::Test {
 protected:
  void begin(const PunchLimits& what, std::uint32_t time = 0) {
    program_.reset();
    bench_ = {.time = time};
    said_ = {};
    program_.emplace(bench_, what);
  }
  void SetUp() override { begin(limits()); }

  void put(const Bytes& bytes) {
    bench_.toBoard.insert(bench_.toBoard.end(), bytes.begin(), bytes.end());
  }
  template <typename Message>
  void send(const Message& message) {
    put(onWire(message, ++sequence_));
  }

  /// One turn of the loop; the voltage after it [mV].
  int step(std::uint32_t micros = kMillisecond) {
    bench_.time += micros;
    program_->step();
    hear();
    return bench_.voltage;
  }
  void steps(int count) {
    for (int i = 0; i < count; ++i) step();
  }
  void greet() {
    send(Hello{});
    step();
  }
  void greetAndArm(std::uint8_t expiry = 20) {
    greet();
    send(Arm{.isArmed = true, .expiry = expiry});
    step();
  }
  /// Keeps asking for @p voltage for some loops.
  int hold(int voltage, int loops, std::uint8_t expiry = 10) {
    for (int i = 0; i < loops; ++i) {
      send(SetForce{.voltage = static_cast<std::int16_t>(voltage), .expiry = expiry});
      step();
    }
    return bench_.voltage;
  }
  const State& state() const { return said_.states.back(); }
  bool has(std::uint8_t fault) const { return (state().faults & fault) != 0; }

  Bench bench_;
  Said said_;
  std::optional<PunchProgram<Bench>> program_;
  std::uint16_t sequence_ = 0;

 private:
  template <typename Message>
  void keep(const Frame& frame, std::vector<Message>& where) {
    Message message;
    ASSERT_TRUE(wire::punch::read(frame, message));
    where.push_back(message);
  }
  void hear() {
    Frame frame;
    for (const auto byte : bench_.fromBoard) {
      if (!decoder_.take(byte, frame)) continue;
      if (frame.type == Type::Hello) keep(frame, said_.hellos);
      if (frame.type == Type::State) keep(frame, said_.states);
      if (frame.type == Type::Event) keep(frame, said_.events);
      if (frame.type == Type::ModelReply) keep(frame, said_.taken);
      if (frame.type == Type::Stop) keep(frame, said_.stops);
    }
    bench_.fromBoard.clear();
    ASSERT_EQ(decoder_.damaged(), 0U);
  }

  FrameDecoder decoder_;
};

}  // namespace haptics::firmware::board_bench

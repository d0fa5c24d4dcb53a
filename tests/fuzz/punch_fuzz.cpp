#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "haptics/firmware/punch_program.h"
#include "haptics/wire/punch_codec.h"

// Fuzzes what the punch and its host take from the line. The first byte chooses: bytes as they
// come, for the host's decoder and for the firmware; or payloads that are put into sound frames, so
// that everything behind the CRC is reached.

namespace {

using namespace haptics::wire::punch;

void expect(bool isTrue) {
  if (!isTrue) std::abort();
}

/// Written again, a message that was read is the same bytes.
template <typename Message>
void check(const Frame& frame) {
  Message message;
  if (!read(frame, message)) return;
  std::uint8_t payload[kLargestPayload];
  Writer writer(payload);
  write(writer, message);
  expect(writer.size() == frame.size);
  for (std::size_t i = 0; i < frame.size; ++i) expect(payload[i] == frame.payload[i]);
}

void checkAll(const Frame& frame) {
  check<Hello>(frame);
  check<Arm>(frame);
  check<SetForce>(frame);
  check<State>(frame);
  check<Event>(frame);
  check<Model>(frame);
  check<ModelTable>(frame);
  check<ModelReply>(frame);
  check<Render>(frame);
  check<Stop>(frame);
}

/// A board whose line is the fuzzer's.
struct Board {
  std::vector<std::uint8_t> input;
  std::size_t at = 0;
  std::uint32_t time = 0;
  std::int32_t position = 0;
  int voltage = 0;

  std::uint32_t micros() const { return time; }
  std::int32_t counts() const { return position; }
  void drive(std::int16_t millivolts) { voltage = millivolts; }
  static bool hasDriverFault() { return false; }
  int read() { return at < input.size() ? input[at++] : -1; }
  static void write(const std::uint8_t*, std::size_t) {}
};

/// Whatever it is told: never more than its limit, never faster than its slew, and nothing once the
/// host has been silent.
void run(std::vector<std::uint8_t> bytes) {
  Board board;
  board.input = std::move(bytes);
  const haptics::firmware::PunchLimits limits;
  haptics::firmware::PunchProgram<Board> program(board, limits);
  const auto steps = static_cast<int>(board.input.size() / 16 + 60);
  for (int i = 0; i < steps; ++i) {
    const int before = board.voltage;
    board.time += 1000;
    board.position += 7;
    program.step();
    expect(std::abs(board.voltage) <= limits.largestVoltage);
    expect(std::abs(board.voltage - before) <= limits.largestSlew);
  }
  if (board.at == board.input.size()) {
    for (int i = 0; i < 60; ++i) {
      board.time += 1000;
      program.step();
    }
    expect(board.voltage == 0 && !program.isArmed());
  }
}

void append(
    std::vector<std::uint8_t>& line, Type type, const std::uint8_t* payload, std::size_t size) {
  std::uint8_t wire[kLargestOnWire];
  const std::size_t count =
      encodeFrame(type, static_cast<std::uint16_t>(line.size()), 0, payload, size, wire);
  line.insert(line.end(), wire, wire + count);
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t count) {
  if (count == 0) return 0;
  std::vector<std::uint8_t> line;
  if ((data[0] & 1U) != 0) {
    line.assign(data + 1, data + count);
  } else {
    // Frames: a type, a length, a payload, again and again, after a sound Hello.
    std::uint8_t hello[64];
    Writer writer(hello);
    write(writer, Hello{});
    append(line, Type::Hello, hello, writer.size());
    for (std::size_t at = 1; at + 2 <= count;) {
      const auto type = static_cast<Type>(data[at]);
      const std::size_t wanted = data[at + 1] % (kLargestPayload + 1);
      const std::size_t left = count - at - 2;
      const std::size_t size = wanted < left ? wanted : left;
      append(line, type, data + at + 2, size);
      at += 2 + size;
    }
  }
  FrameDecoder decoder;
  Frame frame;
  for (const auto byte : line) {
    if (decoder.take(byte, frame)) checkAll(frame);
  }
  run(std::move(line));
  return 0;
}

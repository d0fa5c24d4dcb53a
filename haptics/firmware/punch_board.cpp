// The punch's program on an ARM MPS2 board (AN385, Cortex-M3) emulated by QEMU, with the first UART
// to the host, the system timer as the clock, and a handle that is simulated on the board.
#include <stddef.h>
#include <stdint.h>

#include "haptics/firmware/bench_handle.h"
#include "haptics/firmware/punch_program.h"

#ifndef PALPATE_FIRMWARE_BUILD
#define PALPATE_FIRMWARE_BUILD 0
#endif

extern "C" {
extern uint32_t stack_top[];
int main();
[[noreturn]] void reset();
[[noreturn]] void fault();
void tick();
void receive();
}

namespace haptics::firmware {
namespace {

volatile uint32_t& at(uint32_t address) {
  return *reinterpret_cast<volatile uint32_t*>(address);
}

constexpr uint32_t kUartData = 0x40004000;
constexpr uint32_t kUartState = 0x40004004;  // bit 0: transmit buffer full; bit 1: byte received
constexpr uint32_t kUartControl = 0x40004008;
constexpr uint32_t kUartInterrupt = 0x4000400C;  // 2: byte received
constexpr uint32_t kUartDivider = 0x40004010;
constexpr uint32_t kEnableInterrupts = 0xE000E100;
constexpr uint32_t kTimerControl = 0xE000E010;
constexpr uint32_t kTimerReload = 0xE000E014;
constexpr uint32_t kTimerValue = 0xE000E018;
constexpr uint32_t kTicksPerMillisecond = 25'000;  // 25 MHz

// QEMU transfers single bytes, too slowly for a thousand frames per second.
constexpr uint16_t kRate = 250;  // [Hz]
constexpr int kStep = 4;         // [ms]

volatile uint32_t milliseconds = 0;

/// A ring buffer of received bytes, filled by the UART's interrupt and read by the program.
constexpr uint32_t kReceiveBufferSize = 1024;
volatile uint8_t received[kReceiveBufferSize];
volatile uint32_t receivedTo = 0;
volatile uint32_t receivedFrom = 0;

class Board {
 public:
  Board() noexcept {
    at(kUartDivider) = 16;
    at(kUartControl) = 3 | 8;  // transmit and receive, with the receive interrupt
    at(kEnableInterrupts) = 1;
    at(kTimerReload) = kTicksPerMillisecond - 1;
    at(kTimerValue) = 0;
    at(kTimerControl) = 7;  // processor clock, with interrupt
  }

  uint32_t micros() const noexcept {
    for (;;) {
      const uint32_t before = milliseconds;
      const uint32_t passed = (kTicksPerMillisecond - 1 - at(kTimerValue)) / 25;
      if (milliseconds == before) return 1000 * before + passed;
    }
  }
  int32_t counts() const noexcept { return counts_; }
  void drive(int16_t millivolts) noexcept { voltage_ = millivolts; }
  static bool hasDriverFault() noexcept { return false; }
  static int read() noexcept {
    if (receivedFrom == receivedTo) return -1;
    const int byte = received[receivedFrom % kReceiveBufferSize];
    receivedFrom = receivedFrom + 1;
    return byte;
  }
  static void write(const uint8_t* bytes, size_t count) noexcept {
    for (size_t i = 0; i < count; ++i) {
      for (int tries = 0; (at(kUartState) & 1U) != 0 && tries < 10'000; ++tries) {
      }
      at(kUartData) = bytes[i];
    }
  }

  /// Advances the handle by a millisecond.
  void move() noexcept {
    constexpr float kNewtonsPerVolt = 0.667F;
    constexpr float kTravelPerCount = 0.00439F;
    const float force = 0.001F * kNewtonsPerVolt * static_cast<float>(voltage_);
    counts_ = static_cast<int32_t>(handle_.step(force, 0.001F) / kTravelPerCount);
  }

 private:
  BenchHandle handle_;
  int32_t counts_ = 0;
  int16_t voltage_ = 0;
};

}  // namespace
}  // namespace haptics::firmware

int main() {
  using namespace haptics::firmware;
  static Board board;
  PunchLimits limits;
  limits.build = PALPATE_FIRMWARE_BUILD;
  limits.serial = 1;
  limits.rate = kRate;
  limits.maxCountsPerStep *= kStep;
  static PunchProgram<Board> program(board, limits);
  uint32_t last = milliseconds;
  for (;;) {
    while (milliseconds - last < static_cast<uint32_t>(kStep)) asm volatile("wfi");
    last += kStep;
    for (int i = 0; i < kStep; ++i) board.move();
    program.step();
  }
}

void reset() {
  main();
  for (;;) {
  }
}

void fault() {
  for (;;) {
  }
}

void tick() {
  haptics::firmware::milliseconds = haptics::firmware::milliseconds + 1;
}

void receive() {
  using namespace haptics::firmware;
  at(kUartInterrupt) = 2;
  while ((at(kUartState) & 2U) != 0) {
    received[receivedTo % kReceiveBufferSize] = static_cast<uint8_t>(at(kUartData));
    receivedTo = receivedTo + 1;
  }
}

/// The vector table, which the processor reads at reset: stack pointer and exception handlers.
[[gnu::section(".vectors"), gnu::used]] const void* const vectors[17] = {
    stack_top,
    reinterpret_cast<const void*>(&reset),
    reinterpret_cast<const void*>(&fault),
    reinterpret_cast<const void*>(&fault),
    reinterpret_cast<const void*>(&fault),
    reinterpret_cast<const void*>(&fault),
    reinterpret_cast<const void*>(&fault),
    nullptr,
    nullptr,
    nullptr,
    nullptr,
    reinterpret_cast<const void*>(&fault),
    reinterpret_cast<const void*>(&fault),
    nullptr,
    reinterpret_cast<const void*>(&fault),
    reinterpret_cast<const void*>(&tick),
    reinterpret_cast<const void*>(&receive)};

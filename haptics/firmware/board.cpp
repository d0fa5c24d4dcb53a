#include "haptics/firmware/board.h"

extern "C" {
extern uint32_t stack_bottom[];
extern uint32_t stack_top[];
int main();
[[noreturn]] void reset();
[[noreturn]] void fault();
}

namespace haptics::firmware::board {
namespace {

constexpr uint32_t kStackFillPattern = 0xA5A5A5A5;

volatile uint32_t& at(uint32_t address) {
  return *reinterpret_cast<volatile uint32_t*>(address);
}

constexpr uint32_t kTimerControl = 0xE000E010;
constexpr uint32_t kTimerReload = 0xE000E014;
constexpr uint32_t kTimerValue = 0xE000E018;
constexpr uint32_t kTimerMask = 0xFFFFFF;

/// ARM semihosting: calls a function of the emulator or debugger.
uint32_t callSemihosting(uint32_t operation, const void* parameter) {
  register uint32_t r0 asm("r0") = operation;
  register const void* r1 asm("r1") = parameter;
  asm volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
  return r0;
}

}  // namespace

void print(const char* text) noexcept {
  constexpr uint32_t kWrite0 = 0x04;
  callSemihosting(kWrite0, text);
}

void printNumber(uint32_t number, bool isHexadecimal) noexcept {
  char text[11] = {};
  const uint32_t base = isHexadecimal ? 16 : 10;
  char* digit = text + 10;
  do {
    *--digit = "0123456789abcdef"[number % base];
    number /= base;
  } while (number > 0);
  print(digit);
}

void exit(int status) noexcept {
  constexpr uint32_t kExitExtended = 0x20;
  constexpr uint32_t kApplicationExit = 0x20026;
  const uint32_t block[2] = {kApplicationExit, static_cast<uint32_t>(status)};
  callSemihosting(kExitExtended, block);
  for (;;) {
  }
}

void startCounting() noexcept {
  at(kTimerReload) = kTimerMask;
  at(kTimerValue) = 0;
  at(kTimerControl) = 5;  // processor clock, no interrupt
}

uint32_t instructions() noexcept {
  const uint32_t ticks = kTimerMask - at(kTimerValue);
  return ticks * 5 / 8;
}

uint32_t stackUsed() noexcept {
  const uint32_t* word = stack_bottom;
  while (word < stack_top && *word == kStackFillPattern) ++word;
  return static_cast<uint32_t>(stack_top - word) * sizeof(uint32_t);
}

namespace {
void paintStack() {
  constexpr uintptr_t kStackInUse = 256;  // used by this function and its caller [bytes]
  const uintptr_t end = reinterpret_cast<uintptr_t>(stack_top) - kStackInUse;
  for (uint32_t* word = stack_bottom; reinterpret_cast<uintptr_t>(word) < end; ++word) {
    *word = kStackFillPattern;
  }
}
}  // namespace

}  // namespace haptics::firmware::board

void reset() {
  haptics::firmware::board::paintStack();
  haptics::firmware::board::exit(main());
}

void fault() {
  haptics::firmware::board::print("fault\n");
  haptics::firmware::board::exit(1);
}

/// The vector table, which the processor reads at reset: stack pointer and exception handlers.
[[gnu::section(".vectors"), gnu::used]] const void* const vectors[16] = {
    stack_top,
    reinterpret_cast<const void*>(&reset),
    reinterpret_cast<const void*>(&fault),
    reinterpret_cast<const void*>(&fault),
    reinterpret_cast<const void*>(&fault),
    reinterpret_cast<const void*>(&fault),
    reinterpret_cast<const void*>(&fault)};

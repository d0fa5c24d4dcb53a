#pragma once

#include <stdint.h>

/// An ARM MPS2 board with a Cortex-M3 (AN385), as QEMU has it: a console by semihosting, and a
/// count of instructions by the system timer.
namespace haptics::firmware::board {

void print(const char* text) noexcept;
void printNumber(uint32_t number, bool isHexadecimal) noexcept;
[[noreturn]] void exit(int status) noexcept;

void startCounting() noexcept;
/// Instructions since startCounting(), ten million at most: under `-icount shift=6` one takes 64 ns
/// of the board's time, whose timer runs at 25 MHz, 1.6 ticks.
uint32_t instructions() noexcept;

/// The deepest that the stack has been [bytes].
uint32_t stackUsed() noexcept;

}  // namespace haptics::firmware::board

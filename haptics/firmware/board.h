#pragma once

#include <stdint.h>

/// An ARM MPS2 board with a Cortex-M3 (AN385), emulated by QEMU: a console by semihosting, and a
/// count of instructions by the system timer.
namespace haptics::firmware::board {

void print(const char* text) noexcept;
void printNumber(uint32_t number, bool isHexadecimal) noexcept;
[[noreturn]] void exit(int status) noexcept;

void startCounting() noexcept;
/// Number of instructions since startCounting(), at most ten million. Under `-icount shift=6` an
/// instruction takes 64 ns of the board's time, i.e. 1.6 ticks of the timer at 25 MHz.
uint32_t instructions() noexcept;

/// Largest size of the stack so far [bytes].
uint32_t stackUsed() noexcept;

}  // namespace haptics::firmware::board

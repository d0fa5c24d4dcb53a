#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace study::app {

/// The options of `palpate device rehearse`.
struct RehearseArguments {
  std::string out;
  std::string protocol = "two-devices";
  std::string firmware;  ///< firmware that QEMU runs; empty: the built-in emulator
  int participants = 1;
  std::uint64_t seed = 1;
};

/// The result of a rehearsal; its value is the exit status.
enum class RehearsalVerdict {
  Passed = 0,
  Failed = 1,
  Inconclusive = 3,  ///< the computer stalled for longer than a device's timeout
};

/// The verdict of a rehearsal; @p longestStall is the longest stall of the computer during it.
RehearsalVerdict verdictOf(bool isPassed, std::chrono::milliseconds longestStall) noexcept;

/// Starts both emulators as processes, writes a device file for them, runs the checks of `device
/// check`, and runs sessions of simulated participants in real time over the devices' real
/// protocols (pseudo-terminal, UDP).
/// @return the exit status: a RehearsalVerdict.
int rehearse(const RehearseArguments& arguments);

}  // namespace study::app

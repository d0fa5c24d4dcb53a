#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace study::app {

struct RehearseArguments {
  std::string out;
  std::string protocol = "two-devices";
  std::string firmware;  ///< for QEMU; empty: the built-in emulator
  int participants = 1;
  std::uint64_t seed = 1;
};

/// The result of a rehearsal, which is its exit status.
enum class RehearsalVerdict {
  Passed = 0,
  Failed = 1,
  NotJudged = 3,  ///< the computer stalled for longer than a device's timeout
};

/// The verdict of a rehearsal on a computer whose longest stall was @p stoodStill.
RehearsalVerdict verdictOf(bool isPassed, std::chrono::milliseconds stoodStill) noexcept;

/// Starts both emulators as processes, writes a device file for them, runs the checks of `device
/// check`, and runs sessions of simulated participants in real time over the devices' real
/// protocols (pseudo-terminal, UDP).
/// @return the exit status: a RehearsalVerdict.
int rehearse(const RehearseArguments& arguments);

}  // namespace study::app

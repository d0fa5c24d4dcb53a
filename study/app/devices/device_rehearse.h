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
  NotJudged = 3,  ///< the machine stood still for longer than a device waits
};

/// The verdict of a rehearsal that passed or not, on a machine that stood still for at most @p
/// stoodStill.
RehearsalVerdict verdictOf(bool isPassed, std::chrono::milliseconds stoodStill) noexcept;

/// Starts both emulators as processes, writes a device file for them, runs the checks of `device
/// check`, and lets simulated participants take part over real wires in real time.
/// @return the exit status: a RehearsalVerdict.
int rehearse(const RehearseArguments& arguments);

}  // namespace study::app

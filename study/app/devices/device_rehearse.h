#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace study::app {

struct RehearseArguments {
  std::string out;
  std::string protocol = "two-devices";
  std::string firmware;  ///< for QEMU; empty: native
  int participants = 1;
  std::uint64_t seed = 1;
};

/// How a rehearsal ended; its exit status.
enum class RehearsalVerdict {
  Passed = 0,
  Failed = 1,
  NotJudged = 3,  ///< the machine stood still for longer than a device waits: try again
};

/// What a rehearsal that went well or not says, on a machine that stood still for so long at most.
RehearsalVerdict verdictOf(bool isPassed, std::chrono::milliseconds stoodStill) noexcept;

/// Both emulators as processes of their own, a device file for them, the check of `device check`,
/// and participants who do not exist, on real wires and in real time.
/// @return the exit status: a RehearsalVerdict.
int rehearse(const RehearseArguments& arguments);

}  // namespace study::app

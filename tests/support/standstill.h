#pragma once

#include <chrono>

namespace tests {

/// Runs all tests. When PALPATE_JUDGE_MACHINE is set, a run that fails on a machine that stood
/// still for 5 ms or longer (haptics/timing/standstill_watch.h) says so and ends with
/// kMachineStoodStill, which ctest counts as skipped.
int runAllTests();

inline constexpr int kMachineStoodStill = 77;

/// The exit status of a run that ended with @p status on a machine that stood still for @p longest.
int judged(int status, std::chrono::milliseconds longest) noexcept;

}  // namespace tests

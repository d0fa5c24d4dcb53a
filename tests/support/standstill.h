#pragma once

#include <atomic>
#include <chrono>
#include <thread>

namespace tests {

/// Watches how punctual this machine is while a test runs: a thread that asks to be woken every
/// millisecond and keeps how late it was at most. A test of a device fails for no fault of ours
/// when the machine stands still for longer than a device waits (20 ms).
class StandstillWatch {
 public:
  StandstillWatch();
  ~StandstillWatch();
  StandstillWatch(const StandstillWatch&) = delete;
  StandstillWatch& operator=(const StandstillWatch&) = delete;

  std::chrono::milliseconds longest() const noexcept;

 private:
  std::atomic<std::chrono::steady_clock::rep> longest_{0};
  std::atomic<bool> isOver_{false};
  std::thread thread_;
};

/// Runs all tests. When PALPATE_JUDGE_MACHINE is set, a run that fails on a machine that stood
/// still for 5 ms or longer says so and ends with kMachineStoodStill, which ctest counts as
/// skipped.
int runAllTests();

inline constexpr int kMachineStoodStill = 77;

}  // namespace tests

#include "tests/support/standstill.h"

#include <time.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include <gtest/gtest.h>

namespace tests {
namespace {

using Clock = std::chrono::steady_clock;

/// A quarter of what a device waits for the next sample.
constexpr std::chrono::milliseconds kTooLong{5};

constexpr std::chrono::milliseconds kPause{1};
constexpr std::chrono::microseconds kWork{150};  // about what a device's loop needs

/// What this thread has had of a processor.
std::chrono::nanoseconds processorTime() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

void work() {
  const auto end = processorTime() + kWork;
  while (processorTime() < end) {
  }
}

}  // namespace

StandstillWatch::StandstillWatch()
    : thread_([this] {
        while (!isOver_.load(std::memory_order_relaxed)) {
          const auto due = Clock::now() + kPause + kWork;
          std::this_thread::sleep_for(kPause);
          work();
          const auto late = (Clock::now() - due).count();
          longest_.store(std::max(late, longest_.load()), std::memory_order_relaxed);
        }
      }) {}

StandstillWatch::~StandstillWatch() {
  isOver_.store(true);
  thread_.join();
}

std::chrono::milliseconds StandstillWatch::longest() const noexcept {
  return std::chrono::duration_cast<std::chrono::milliseconds>(Clock::duration(longest_.load()));
}

int runAllTests() {
  if (std::getenv("PALPATE_JUDGE_MACHINE") == nullptr) return RUN_ALL_TESTS();
  const StandstillWatch watch;
  const int status = RUN_ALL_TESTS();
  const auto longest = watch.longest();
  if (status == 0 || longest < kTooLong) return status;
  std::printf(
      "Skipped: the machine stood still for %lld ms, longer than a device waits\n",
      static_cast<long long>(longest.count()));
  return kMachineStoodStill;
}

}  // namespace tests

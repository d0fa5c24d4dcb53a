#pragma once

#include <time.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>

namespace haptics::timing {

/// Measures how long this machine stalls: a thread sleeps for 1 ms, works for 150 µs as a device's
/// loop does, and records its largest lateness. A real-time test can thus tell a stall of the
/// machine from a fault of the program.
class StandstillWatch {
 public:
  StandstillWatch() : thread_([this] { watch(); }) {}
  ~StandstillWatch() {
    isOver_.store(true);
    thread_.join();
  }
  StandstillWatch(const StandstillWatch&) = delete;
  StandstillWatch& operator=(const StandstillWatch&) = delete;

  /// Largest lateness since construction or restart().
  std::chrono::milliseconds longest() const noexcept {
    return std::chrono::duration_cast<std::chrono::milliseconds>(
        Clock::duration(longest_.load(std::memory_order_relaxed)));
  }

  /// Resets longest() to 0.
  void restart() noexcept { longest_.store(0, std::memory_order_relaxed); }

 private:
  using Clock = std::chrono::steady_clock;

  /// Processor time of this thread.
  static std::chrono::nanoseconds processorTime() noexcept {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
  }

  void watch() noexcept {
    constexpr std::chrono::milliseconds kPause{1};
    constexpr std::chrono::microseconds kWork{150};
    while (!isOver_.load(std::memory_order_relaxed)) {
      const auto due = Clock::now() + kPause + kWork;
      std::this_thread::sleep_for(kPause);
      for (const auto end = processorTime() + kWork; processorTime() < end;) {
      }
      const auto late = (Clock::now() - due).count();
      longest_.store(std::max(late, longest_.load()), std::memory_order_relaxed);
    }
  }

  std::atomic<Clock::rep> longest_{0};
  std::atomic<bool> isOver_{false};
  std::thread thread_;  // last member, because it uses the others
};

}  // namespace haptics::timing

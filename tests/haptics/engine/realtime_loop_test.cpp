#include "haptics/engine/realtime_loop.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>

namespace haptics::engine {
namespace realtime_loop_test {

TEST(RealtimeLoop, TicksAndReportsItsTiming) {
  std::atomic<int> calls{0};
  RealtimeLoop loop({.rate = 1000.0}, [&](double dt, double lateness) {
    EXPECT_EQ(dt, 0.001);
    EXPECT_GE(lateness, 0.0);
    ++calls;
  });
  while (loop.ticks() < 100) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  const auto& report = loop.finish();
  EXPECT_EQ(report.ticks, static_cast<std::uint64_t>(calls.load()));
  EXPECT_EQ(report.lateness.count(), report.ticks);
  EXPECT_GT(report.seconds, 0.05);
  EXPECT_LE(report.lateTicks, report.ticks);
}

TEST(RealtimeLoop, DoesNotChaseLostTime) {
  // One tick takes 50 ms at 1 kHz: fifty periods are missed, and no burst follows.
  int calls = 0;
  std::chrono::steady_clock::time_point stalled;
  std::atomic<bool> isDone{false};
  double nextGap = 0.0;
  RealtimeLoop loop({.rate = 1000.0}, [&](double, double) {
    const auto now = std::chrono::steady_clock::now();
    if (calls == 20) {
      while (std::chrono::steady_clock::now() - now < std::chrono::milliseconds(50)) {
      }
      stalled = std::chrono::steady_clock::now();
    }
    if (calls == 23) {
      nextGap = std::chrono::duration<double>(now - stalled).count();
      isDone = true;
    }
    ++calls;
  });
  while (!isDone) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  const auto& report = loop.finish();
  EXPECT_GE(report.lateTicks, 1U);
  EXPECT_GE(nextGap, 0.0015);  // two periods between three ticks, not none
}

TEST(RealtimeLoop, CountsPeriodsThatItMissedItselfAsItsOwn) {
  // A tick of 20 ms at 1 kHz is nobody else's fault.
  int calls = 0;
  std::atomic<bool> isDone{false};
  RealtimeLoop loop({.rate = 1000.0}, [&](double, double) {
    if (++calls == 30) {
      const auto start = std::chrono::steady_clock::now();
      while (std::chrono::steady_clock::now() - start < std::chrono::milliseconds(20)) {
      }
    }
    isDone = calls > 40;
  });
  while (!isDone) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  const auto& report = loop.finish();
  EXPECT_GE(report.ownLateTicks, 1U);
  EXPECT_GE(report.missedPeriods, 15U);
  EXPECT_EQ(report.lateTicks, report.ownLateTicks + report.hostPauses);
  EXPECT_GE(report.compute.largest(), 20'000.0);
  EXPECT_EQ(report.ownLateness.count(), report.lateness.count());
  EXPECT_LE(report.ownLateness.largest(), report.lateness.largest());
}

/// Sets the pace every two milliseconds from another thread, as a device's datagrams would.
class ThreadPacer final : public devices::Pacer {
 public:
  bool wait(std::int64_t deadline) noexcept override {
    std::unique_lock lock(mutex_);
    const auto until = std::chrono::steady_clock::time_point(std::chrono::nanoseconds(deadline));
    const bool came = condition_.wait_until(lock, until, [&] { return pending_ > 0; });
    if (came) --pending_;
    ++waits_;
    return came;
  }
  std::uint64_t waits() {
    const std::lock_guard lock(mutex_);
    return waits_;
  }
  void signal() {
    const std::lock_guard lock(mutex_);
    ++pending_;
    condition_.notify_one();
  }

 private:
  std::mutex mutex_;
  std::condition_variable condition_;
  int pending_ = 0;
  std::uint64_t waits_ = 0;
};

TEST(RealtimeLoop, FollowsThePaceOfADevice) {
  using Clock = std::chrono::steady_clock;
  ThreadPacer pacer;
  std::atomic<std::uint64_t> calls{0};
  Clock::time_point last = Clock::now();
  int soon = 0;  // ticks that came much sooner after the one before than a timer's
  RealtimeLoop loop({.rate = 20.0, .pacer = &pacer}, [&](double dt, double) {
    EXPECT_EQ(dt, 0.05);
    const auto now = Clock::now();
    if (now - last < std::chrono::milliseconds(25)) ++soon;
    last = now;
    ++calls;
  });
  for (int i = 0; i < 50; ++i) {
    pacer.signal();
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  while (calls < 50) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  const auto ticks = loop.finish().ticks;  // before waits are read: a compiler may read them first
  EXPECT_EQ(ticks, pacer.waits()) << "one tick for each wait";
  EXPECT_EQ(calls, pacer.waits());
  // Where the machine stands still, signals gather, and their ticks follow at once.
  EXPECT_GE(soon, 10);
}

TEST(RealtimeLoop, CallsTheFirstMessageOfADeviceNotLate) {
  ThreadPacer pacer;
  std::atomic<double> first{-1.0};
  RealtimeLoop loop({.rate = 2.0, .pacer = &pacer}, [&](double, double lateness) {
    if (first < 0.0) first = lateness;
  });
  std::this_thread::sleep_for(std::chrono::milliseconds(50));  // within its first period
  pacer.signal();
  while (first < 0.0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_EQ(first, 0.0);
}

TEST(RealtimeLoop, TicksOnWhenTheDeviceStopsSoThatTheFaultIsNoticed) {
  ThreadPacer silent;
  std::atomic<int> late{0};
  RealtimeLoop loop({.rate = 200.0, .pacer = &silent}, [&](double dt, double lateness) {
    if (lateness >= 0.9e6 * dt) ++late;
  });
  while (late < 10) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_GE(loop.finish().ticks, 10U);
}

TEST(RealtimeLoop, RefusesToSpinForLongerThanTheKernelLets) {
  const auto nothing = [](double, double) {};
  EXPECT_THROW(RealtimeLoop({.spinning = 0.11}, nothing), std::invalid_argument);
  EXPECT_THROW(RealtimeLoop({.spinning = -0.1}, nothing), std::invalid_argument);
  EXPECT_NO_THROW(RealtimeLoop({.spinning = 0.1}, nothing));
}

TEST(RealtimeLoop, RefusesAnImpossibleRate) {
  const auto nothing = [](double, double) {};
  EXPECT_THROW(RealtimeLoop({.rate = 0.0}, nothing), std::invalid_argument);
  EXPECT_THROW(RealtimeLoop({.rate = 1e6}, nothing), std::invalid_argument);
}

}  // namespace realtime_loop_test
}  // namespace haptics::engine

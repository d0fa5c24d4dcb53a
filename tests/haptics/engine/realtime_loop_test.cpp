#include "haptics/engine/realtime_loop.h"

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>

namespace haptics::engine {
namespace {

TEST(RealtimeLoop, TicksAndReportsWhatItDid) {
  std::atomic<int> calls{0};
  RealtimeLoop loop(1000.0, [&](double dt, double lateness) {
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
  // One tick takes 50 ms at 1 kHz: fifty beats are lost, and no burst follows.
  int calls = 0;
  std::chrono::steady_clock::time_point stalled;
  std::atomic<bool> isDone{false};
  double nextGap = 0.0;
  RealtimeLoop loop(1000.0, [&](double, double) {
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

TEST(RealtimeLoop, RefusesAnImpossibleRate) {
  const auto nothing = [](double, double) {};
  EXPECT_THROW(RealtimeLoop(0.0, nothing), std::invalid_argument);
  EXPECT_THROW(RealtimeLoop(1e6, nothing), std::invalid_argument);
}

}  // namespace
}  // namespace haptics::engine

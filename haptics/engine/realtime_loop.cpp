#include "haptics/engine/realtime_loop.h"

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <time.h>

#include <stdexcept>
#include <utility>

namespace haptics::engine {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;  // [ns]

std::int64_t now() noexcept {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return time.tv_sec * kSecond + time.tv_nsec;
}

void sleepUntil(std::int64_t due) noexcept {
  const timespec time{.tv_sec = due / kSecond, .tv_nsec = due % kSecond};
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &time, nullptr) != 0) {
  }
}

/// Asks for what helps. Timer slack needs no privilege; the rest may be refused.
bool requestRealtime() noexcept {
  prctl(PR_SET_TIMERSLACK, 1UL);
  const sched_param priority{.sched_priority = 80};
  if (pthread_setschedparam(pthread_self(), SCHED_FIFO, &priority) != 0) return false;
  mlockall(MCL_CURRENT | MCL_ONFAULT);
  return true;
}

}  // namespace

RealtimeLoop::RealtimeLoop(double rate, Tick tick) : rate_(rate), tick_(std::move(tick)) {
  if (!(rate >= 1.0 && rate <= 10'000.0)) {
    throw std::invalid_argument("the loop's rate must lie between 1 and 10,000 Hz");
  }
  thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

RealtimeLoop::~RealtimeLoop() {
  finish();
}

const RealtimeLoop::Report& RealtimeLoop::finish() {
  if (thread_.joinable()) {
    thread_.request_stop();
    thread_.join();
  }
  return report_;
}

void RealtimeLoop::run(const std::stop_token& stop) {
  isRealtime_ = requestRealtime();
  const double dt = 1.0 / rate_;
  const auto period = static_cast<std::int64_t>(dt * static_cast<double>(kSecond));
  const std::int64_t start = now();
  std::int64_t due = start;
  std::int64_t last = start;
  while (!stop.stop_requested()) {
    last = now();
    const std::int64_t late = last - due;
    report_.lateness.add(static_cast<double>(late) / 1000.0);
    ticks_.store(++report_.ticks, std::memory_order_relaxed);
    if (late > period) {
      lateTicks_.store(++report_.lateTicks, std::memory_order_relaxed);
      due = last;
    }
    tick_(dt, static_cast<double>(late) / 1000.0);
    due += period;
    sleepUntil(due);
  }
  report_.seconds = static_cast<double>(last - start) / static_cast<double>(kSecond);
}

}  // namespace haptics::engine

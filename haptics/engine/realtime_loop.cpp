#include "haptics/engine/realtime_loop.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <stdexcept>
#include <utility>

#include "haptics/timing/monotonic_clock.h"

namespace haptics::engine {

HostPauseDetector::HostPauseDetector() noexcept
    : file_(open("/proc/thread-self/schedstat", O_RDONLY | O_CLOEXEC)) {
  restart();
}

HostPauseDetector::~HostPauseDetector() {
  if (file_ >= 0) close(file_);
}

/// Total time that the thread has waited for a processor [ns], which is the second number in the
/// file; −1 if the kernel does not count. A kernel that does not count writes 0 as the third number
/// (of time slices), although the thread is running.
std::int64_t HostPauseDetector::waited() const noexcept {
  char text[96];
  const auto length = file_ < 0 ? -1 : pread(file_, text, sizeof text, 0);
  if (length <= 0) return -1;
  const char* const end = text + length;
  const char* second = std::find(static_cast<const char*>(text), end, ' ');
  if (second == end) return -1;
  std::int64_t waited = -1;
  std::int64_t turns = 0;
  const auto read = std::from_chars(second + 1, end, waited);
  if (read.ptr != end) std::from_chars(read.ptr + 1, end, turns);
  return turns > 0 ? waited : -1;
}

void HostPauseDetector::restart() noexcept {
  waitedBefore_ = waited();
}

std::int64_t HostPauseDetector::latenessWithoutHostPause(std::int64_t late) noexcept {
  const std::int64_t now = waited();
  const bool isCounted = now >= 0 && waitedBefore_ >= 0;
  const std::int64_t ours =
      isCounted ? std::clamp<std::int64_t>(now - waitedBefore_, 0, late) : late;
  waitedBefore_ = now;
  return ours;
}

namespace {

using timing::kSecond;
using timing::now;
using timing::sleepUntil;

double microseconds(std::int64_t nanoseconds) noexcept {
  return static_cast<double>(nanoseconds) / 1000.0;
}

/// Touches the thread's stack, so that no tick causes a page fault in it.
void touchStack() noexcept {
  constexpr std::size_t kStackBytes = std::size_t{64} * 1024;
  [[maybe_unused]] volatile char stack[kStackBytes];
  for (std::size_t i = 0; i < kStackBytes; i += 1024) stack[i] = 0;
}

/// Requests real-time scheduling. Timer slack needs no privilege; the other requests may be
/// refused.
bool requestRealtime() noexcept {
  prctl(PR_SET_TIMERSLACK, 1UL);
  if (!timing::raisePriority(timing::kLoopPriority)) return false;
  mlockall(MCL_CURRENT | MCL_ONFAULT);
  touchStack();
  return true;
}

}  // namespace

/// Computes when the next tick is due, and waits for it.
class RealtimeLoop::Pace {
 public:
  Pace(const Options& options, std::int64_t period) noexcept
      : period_(period),
        spin_(static_cast<std::int64_t>(options.spinning * static_cast<double>(period))),
        pacer_(options.pacer),
        due_(now()) {}

  /// Waits for the next tick and returns its lateness [ns]. Missed ticks are not made up for.
  std::int64_t wait() noexcept {
    if (pacer_ != nullptr && isFirst_) {
      isFirst_ = false;
      // When the device's period begins is known only now, so its first message is never late.
      pacer_->wait(due_ + 2 * period_);
      due_ = now() + period_;
      return 0;
    }
    if (pacer_ != nullptr) {
      pacer_->wait(due_ + period_);  // the tick detects a silent device
    } else {
      if (spin_ < due_ - now()) sleepUntil(due_ - spin_);
      while (now() < due_) {
      }
    }
    const std::int64_t woken = now();
    const std::int64_t late = std::max<std::int64_t>(woken - due_, 0);
    const bool isPacedByDevice = pacer_ != nullptr;
    due_ = (isPacedByDevice || late > period_ ? woken : due_) + period_;
    return late;
  }

 private:
  std::int64_t period_;
  std::int64_t spin_;
  devices::Pacer* pacer_;
  std::int64_t due_;
  bool isFirst_ = true;
};

RealtimeLoop::RealtimeLoop(const Options& options, Tick tick)
    : options_(options), tick_(std::move(tick)) {
  if (!(options.rate >= 1.0 && options.rate <= 10'000.0)) {
    throw std::invalid_argument("the loop's rate must lie between 1 and 10,000 Hz");
  }
  if (!(options.spinning >= 0.0 && options.spinning <= kMaxSpinFraction)) {
    throw std::invalid_argument("the loop may spin for at most a tenth of a period");
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

void RealtimeLoop::recordTick(std::int64_t late, std::int64_t own, std::int64_t period) noexcept {
  report_.lateness.add(microseconds(late));
  report_.ownLateness.add(microseconds(own));
  ticks_.store(++report_.ticks, std::memory_order_relaxed);
  if (late <= period) return;
  lateTicks_.store(++report_.lateTicks, std::memory_order_relaxed);
  report_.missedPeriods += static_cast<std::uint64_t>(late / period);
  if (own > period) {
    ++report_.ownLateTicks;
  } else {
    ++report_.hostPauses;
    report_.longestHostPause = std::max(report_.longestHostPause, microseconds(late - own));
  }
}

void RealtimeLoop::run(const std::stop_token& stop) {
  // Timer slack and priority are requested together, so that requestsRealtime = false measures
  // without both.
  isRealtime_ = options_.requestsRealtime && requestRealtime();
  HostPauseDetector hostPauses;
  const double dt = 1.0 / options_.rate;
  const auto period = static_cast<std::int64_t>(dt * static_cast<double>(kSecond));
  // Lateness above this is attributed to its cause; less is timer slack and wake-up latency.
  constexpr std::int64_t kLeastHostPause = 200'000;  // [ns]
  const std::int64_t suspicious = std::max(period / 4, kLeastHostPause);
  // `hostPauses` is reset every few ticks, so that it measures little more than the late tick.
  constexpr std::uint64_t kTicksPerRestart = 8;
  Pace pace(options_, period);
  const std::int64_t start = now();
  std::int64_t last = start;
  std::int64_t overrun = 0;
  while (!stop.stop_requested()) {
    const std::int64_t late = pace.wait();
    std::int64_t own = late;
    if (late > suspicious) {
      own = std::min(late, std::max(hostPauses.latenessWithoutHostPause(late), overrun));
    } else if (report_.ticks % kTicksPerRestart == 0) {
      hostPauses.restart();
    }
    recordTick(late, own, period);
    last = now();
    tick_(dt, microseconds(late));
    const std::int64_t took = now() - last;
    report_.compute.add(microseconds(took));
    const std::int64_t room = late > period ? period : period - late;
    overrun = std::max<std::int64_t>(took - room, 0);
  }
  report_.seconds = static_cast<double>(last - start) / static_cast<double>(kSecond);
}

}  // namespace haptics::engine

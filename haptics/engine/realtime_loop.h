#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <stop_token>
#include <thread>

#include "haptics/devices/device.h"
#include "haptics/timing/clock_statistics.h"

namespace haptics::engine {

/// Splits the lateness of a thread's wake-up into a part that this machine caused, and the rest,
/// which is called a host pause.
///
/// The kernel counts in /proc/thread-self/schedstat how long a runnable thread waits for a
/// processor: this part is caused by other work on this machine. In a host pause the timer fired
/// late, because the host of this (virtual) machine, or the firmware, had stopped it. If the kernel
/// does not count, all lateness is attributed to this machine.
class HostPauseDetector {
 public:
  /// Measures the calling thread; only that thread may use the object.
  HostPauseDetector() noexcept;
  ~HostPauseDetector();
  HostPauseDetector(const HostPauseDetector&) = delete;
  HostPauseDetector& operator=(const HostPauseDetector&) = delete;

  /// Restarts the count. Call it now and then while no tick is late, so that the short waits of
  /// many wake-ups do not add up.
  void restart() noexcept;

  /// Returns the part of @p late [ns] that this machine caused [ns]; the rest is a host pause.
  /// Restarts the count.
  std::int64_t latenessWithoutHostPause(std::int64_t late) noexcept;

 private:
  std::int64_t waited() const noexcept;

  int file_ = -1;
  std::int64_t waitedBefore_ = 0;
};

/// A thread that calls a function at a fixed rate, or at the pace of a device. It drives
/// ForceEngine::tick() in real time.
///
/// Sleeps until absolute times on CLOCK_MONOTONIC with a timer slack of 1 ns, and spins over the
/// last small part of a period, which hides most of the wake-up latency. Requests real-time
/// priority and locked memory, and works without them if they are refused; see isRealtime(). Missed
/// ticks are not made up for: a burst of ticks would feel like a knock.
class RealtimeLoop {
 public:
  /// One step: @p dt is the nominal period [s], @p lateness the delay of the call after its due
  /// time [µs]. Every whole period of lateness is a missed period.
  using Tick = std::function<void(double dt, double lateness)>;

  /// Largest fraction of a period to spin; more could exceed the kernel's limit for real-time
  /// threads (950 ms per second).
  static constexpr double kMaxSpinFraction = 0.1;

  struct Options {
    double rate = 1000.0;    ///< [Hz], 1 to 10,000
    double spinning = 0.05;  ///< fraction of a period to spin at its end, 0 to kMaxSpinFraction
    bool requestsRealtime = true;
    devices::Pacer* pacer = nullptr;  ///< sets the pace if given; must outlive the loop
  };

  struct Report {
    std::uint64_t ticks = 0;
    std::uint64_t lateTicks = 0;     ///< ticks that were late by more than a period
    std::uint64_t ownLateTicks = 0;  ///< late ticks that this machine caused
    std::uint64_t missedPeriods = 0;
    std::uint64_t hostPauses = 0;           ///< late ticks that a host pause caused
    double longestHostPause = 0.0;          ///< [µs]
    double seconds = 0.0;                   ///< from the first tick to the last
    timing::LatenessHistogram lateness;     ///< of every tick
    timing::LatenessHistogram ownLateness;  ///< of every tick, without host pauses
    timing::LatenessHistogram compute;      ///< duration of the ticks
  };

  /// Starts the thread. @p tick must not allocate, wait or throw.
  /// @throws std::invalid_argument  if the rate or the share of spinning is out of range.
  RealtimeLoop(const Options& options, Tick tick);

  /// Stops the loop and waits for the last tick to end.
  ~RealtimeLoop();
  RealtimeLoop(const RealtimeLoop&) = delete;
  RealtimeLoop& operator=(const RealtimeLoop&) = delete;

  /// Stops the loop and returns its measurements. A second call returns the same.
  const Report& finish();

  /// The functions below may be called from any thread while the loop runs.
  std::uint64_t ticks() const noexcept { return ticks_.load(std::memory_order_relaxed); }
  std::uint64_t lateTicks() const noexcept { return lateTicks_.load(std::memory_order_relaxed); }
  bool isRealtime() const noexcept { return isRealtime_.load(std::memory_order_relaxed); }

 private:
  class Pace;
  void run(const std::stop_token& stop);
  void recordTick(std::int64_t late, std::int64_t own, std::int64_t period) noexcept;

  Options options_;
  Tick tick_;
  Report report_;
  std::atomic<std::uint64_t> ticks_{0};
  std::atomic<std::uint64_t> lateTicks_{0};
  std::atomic<bool> isRealtime_{false};
  std::jthread thread_;
};

}  // namespace haptics::engine

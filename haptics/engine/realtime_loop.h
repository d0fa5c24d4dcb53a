#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <stop_token>
#include <thread>

#include "haptics/devices/device.h"
#include "haptics/timing/clock_statistics.h"

namespace haptics::engine {

/// Tells whose fault it is that a thread woke up late.
///
/// A thread that waits for a processor although its time has come counts that in
/// /proc/thread-self/schedstat: other work of this machine, ours to answer for. The rest of the
/// lateness is a hole: the timer itself came late, because the host of this (virtual) machine had
/// stopped it, or its firmware had. Where the kernel does not count, everything is ours.
class HoleDetector {
 public:
  /// Belongs to the thread that makes it.
  HoleDetector() noexcept;
  ~HoleDetector();
  HoleDetector(const HoleDetector&) = delete;
  HoleDetector& operator=(const HoleDetector&) = delete;

  bool isAvailable() const noexcept { return file_ >= 0; }

  /// Resets the count: call it now and then while nothing is late, so that the small change of
  /// many wake-ups does not add up.
  void restart() noexcept;

  /// Of @p late [ns], what this machine answers for [ns]; the rest is a hole. Restarts.
  std::int64_t accountableLateness(std::int64_t late) noexcept;

 private:
  std::int64_t waited() const noexcept;

  int file_ = -1;
  std::int64_t before_ = 0;
};

/// The only clock of the engine: a thread that calls a tick at a fixed rate, as nearly as the
/// machine lets it, or at the pace that a device sets.
///
/// Sleeps to absolute times on CLOCK_MONOTONIC with a timer slack of 1 ns, and spins over the last
/// small part of a period, which hides most of the time that waking up takes. It asks for real-time
/// priority and locked memory, and works without them if they are not granted; see isRealtime(). It
/// never catches up on lost time: a burst of ticks would feel like a knock.
class RealtimeLoop {
 public:
  /// One step: @p dt is the nominal period [s], @p lateness how long after its due time [µs]. A
  /// whole period of lateness is a period that was missed.
  using Tick = std::function<void(double dt, double lateness)>;

  /// Longer spinning would run into the kernel's brake on real-time threads (950 ms of a second).
  static constexpr double kMostSpinning = 0.1;

  struct Options {
    double rate = 1000.0;    ///< [Hz], 1 to 10,000
    double spinning = 0.05;  ///< share of a period that is spun at its end, 0 to kMostSpinning
    bool asksForRealtime = true;
    devices::Pacer* pacer = nullptr;  ///< sets the pace if given; must outlive the loop
  };

  struct Report {
    std::uint64_t ticks = 0;
    std::uint64_t lateTicks = 0;  ///< later than a whole period: at least one period was missed
    std::uint64_t lateTicksOfOurs = 0;  ///< … which this machine answers for, not a hole
    std::uint64_t missedPeriods = 0;
    std::uint64_t holes = 0;                ///< late ticks that the host machine caused
    double longestHole = 0.0;               ///< [µs]
    bool knowsHoles = false;                ///< the kernel tells them apart
    double seconds = 0.0;                   ///< from the first tick to the last
    timing::LatenessHistogram lateness;     ///< of every tick
    timing::LatenessHistogram ownLateness;  ///< without holes
    timing::LatenessHistogram compute;      ///< how long the ticks took
  };

  /// Starts ticking. @p tick neither allocates, waits nor throws.
  /// @throws std::invalid_argument  if the rate or the share of spinning is out of range.
  RealtimeLoop(const Options& options, Tick tick);

  /// Stops, and waits until the last tick is over.
  ~RealtimeLoop();
  RealtimeLoop(const RealtimeLoop&) = delete;
  RealtimeLoop& operator=(const RealtimeLoop&) = delete;

  /// Stops the loop and returns its measurements. A second call returns the same.
  const Report& finish();

  /// Any thread, while it runs.
  std::uint64_t ticks() const noexcept { return ticks_.load(std::memory_order_relaxed); }
  std::uint64_t lateTicks() const noexcept { return lateTicks_.load(std::memory_order_relaxed); }
  bool isRealtime() const noexcept { return isRealtime_.load(std::memory_order_relaxed); }

 private:
  class Pace;
  void run(const std::stop_token& stop);
  void note(std::int64_t late, std::int64_t own, std::int64_t period) noexcept;

  Options options_;
  Tick tick_;
  Report report_;
  std::atomic<std::uint64_t> ticks_{0};
  std::atomic<std::uint64_t> lateTicks_{0};
  std::atomic<bool> isRealtime_{false};
  std::jthread thread_;
};

}  // namespace haptics::engine

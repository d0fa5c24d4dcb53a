#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <stop_token>
#include <thread>

#include "haptics/engine/lateness_histogram.h"

namespace haptics::engine {

/// The only clock of the engine: a thread that calls a tick at a fixed rate, as nearly as the
/// machine lets it.
///
/// Sleeps to absolute times on CLOCK_MONOTONIC with a timer slack of 1 ns. Real-time priority and
/// locked memory are asked for and done without where they are not granted: isRealtime() says
/// which. Lost time is never chased: a burst of ticks would feel like a knock.
class RealtimeLoop {
 public:
  /// One step: @p dt is the nominal period [s], @p lateness how long after its due time [µs].
  using Tick = std::function<void(double dt, double lateness)>;

  struct Report {
    std::uint64_t ticks = 0;
    std::uint64_t lateTicks = 0;  ///< later than a whole period: at least one beat was lost
    double seconds = 0.0;         ///< from the first tick to the last
    LatenessHistogram lateness;
  };

  /// Starts ticking. @p tick neither allocates, waits nor throws.
  /// @throws std::invalid_argument  if @p rate [Hz] is not from 1 to 10,000.
  RealtimeLoop(double rate, Tick tick);

  /// Stops, and waits until the last tick is over.
  ~RealtimeLoop();
  RealtimeLoop(const RealtimeLoop&) = delete;
  RealtimeLoop& operator=(const RealtimeLoop&) = delete;

  /// Stops; what the loop has measured. A second call returns the same.
  const Report& finish();

  /// Any thread, while it runs.
  std::uint64_t ticks() const noexcept { return ticks_.load(std::memory_order_relaxed); }
  std::uint64_t lateTicks() const noexcept { return lateTicks_.load(std::memory_order_relaxed); }
  bool isRealtime() const noexcept { return isRealtime_.load(std::memory_order_relaxed); }

 private:
  void run(const std::stop_token& stop);

  double rate_;
  Tick tick_;
  Report report_;
  std::atomic<std::uint64_t> ticks_{0};
  std::atomic<std::uint64_t> lateTicks_{0};
  std::atomic<bool> isRealtime_{false};
  std::jthread thread_;
};

}  // namespace haptics::engine

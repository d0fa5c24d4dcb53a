#pragma once

#include <array>
#include <cstddef>

#include "haptics/wire/fri_message.h"

namespace haptics::emulators {

/// How good the connection to a client is, as a controller tells it.
///
/// KUKA does not publish what its levels mean. **These thresholds are our own.** Of the last 100
/// answers that were due we look at
///
/// - the share that came in time: before the next was due;
/// - the latency, the mean time from a message to its answer;
/// - the jitter, the mean difference between the latencies of two answers that follow each other;
///
/// the latter two as parts of the receive period. All three must be good enough:
///
/// | level     | share  | latency | jitter |
/// |-----------|--------|---------|--------|
/// | Excellent | ≥ 0.98 | ≤ 0.50  | ≤ 0.10 |
/// | Good      | ≥ 0.90 | ≤ 0.80  | ≤ 0.30 |
/// | Fair      | ≥ 0.70 | ≤ 1.00  | ≤ 0.60 |
/// | Poor      | less   | more    | more   |
///
/// What has not yet been is as if unanswered. So every connection starts Poor, and one where
/// everything comes in time is Fair with the 70th answer, Good with the 90th and Excellent with the
/// 98th.
class ConnectionQuality {
 public:
  using Level = wire::fri::ConnectionQuality;

  static constexpr std::size_t kWindow = 100;  ///< answers due

  struct Measures {
    double share = 0.0;    ///< [0, 1]
    double latency = 0.0;  ///< [receive periods]
    double jitter = 0.0;   ///< [receive periods]
  };

  struct Threshold {
    Level level = Level::Poor;
    Measures worst;
  };
  static constexpr std::array kThresholds{
      Threshold{Level::Excellent, {.share = 0.98, .latency = 0.5, .jitter = 0.1}},
      Threshold{Level::Good, {.share = 0.90, .latency = 0.8, .jitter = 0.3}},
      Threshold{Level::Fair, {.share = 0.70, .latency = 1.0, .jitter = 0.6}}};

  /// The level of @p measures; what is no number is Poor.
  static Level levelOf(const Measures& measures) noexcept;

  /// An answer came in time, @p latency [receive periods] after its message.
  void answered(double latency) noexcept;
  /// An answer that was due did not come in time.
  void missed() noexcept;
  /// As new.
  void forget() noexcept { *this = ConnectionQuality(); }

  Measures measures() const noexcept;
  Level level() const noexcept { return levelOf(measures()); }

 private:
  static constexpr double kUnanswered = -1.0;
  static constexpr std::array<double, kWindow> unanswered() noexcept {
    std::array<double, kWindow> latencies{};
    latencies.fill(kUnanswered);
    return latencies;
  }

  void add(double latency) noexcept;

  std::array<double, kWindow> latencies_ = unanswered();
  std::size_t next_ = 0;  ///< the oldest, which is replaced next
};

}  // namespace haptics::emulators

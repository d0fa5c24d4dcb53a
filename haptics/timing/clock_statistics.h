#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace haptics::timing {

/// A histogram of the lateness of ticks, with a bin width of at most 1/16 of the value. It gives
/// quantiles without storing every tick, and without heap.
class LatenessHistogram {
 public:
  /// Adds @p lateness [µs]; negative values count as 0.
  void add(double lateness) noexcept;

  std::uint64_t count() const noexcept { return count_; }
  double largest() const noexcept { return largest_; }  ///< [µs], exact
  /// The @p q quantile of the lateness [µs], q in [0, 1]; 0 if there are no ticks.
  double quantile(double q) const noexcept;

 private:
  static constexpr int kBinsPerOctave = 16;
  static constexpr int kOctaves = 34;  ///< from 1/16 µs to 1000 s
  static int binOf(double lateness) noexcept;
  static double upperEdgeOf(int bin) noexcept;

  std::array<std::uint64_t, std::size_t{kBinsPerOctave} * kOctaves> bins_{};
  std::uint64_t count_ = 0;
  double largest_ = 0.0;
};

/// Estimates offset and drift of a device's clock against the host's from the time stamps of
/// messages.
///
/// A message is received after a delay that is never negative and often small. So only the least
/// delay of every window of 0.5 s is used, and a least-squares line is fitted through these,
///
///     host − device = offset + drift · (time since the first).
///
/// Memory and time per message are constant.
class ClockDrift {
 public:
  /// Adds a message with time stamp @p device that was received at @p host, both [ns] and both
  /// increasing.
  void add(std::int64_t device, std::int64_t host) noexcept;

  /// How much faster the host's clock is [parts per million]; std::nullopt before three windows.
  std::optional<double> partsPerMillion() const noexcept;

  /// Host time at device time 0 [ns], from the first message.
  std::int64_t offset() const noexcept { return offset_; }

  std::int64_t windows() const noexcept { return count_; }

 private:
  static constexpr std::int64_t kWindow = 500'000'000;  // [ns]

  void closeWindow() noexcept;

  bool hasAny_ = false;
  std::int64_t firstDevice_ = 0;
  std::int64_t offset_ = 0;
  std::int64_t windowEnd_ = 0;   // device time since the first message
  std::int64_t leastTime_ = 0;   // device time of the least delay in this window
  std::int64_t leastDelay_ = 0;  // host − device − offset
  std::int64_t count_ = 0;
  double sumX_ = 0.0, sumY_ = 0.0, sumXX_ = 0.0, sumXY_ = 0.0;  // [s], [µs]
};

}  // namespace haptics::timing

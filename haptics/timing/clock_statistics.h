#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace haptics::timing {

/// How late ticks were, counted in bins that are never wider than 1/16 of what they hold: quantiles
/// without keeping every tick, and without the heap.
class LatenessHistogram {
 public:
  /// @p lateness in [µs]; early counts as 0.
  void add(double lateness) noexcept;

  std::uint64_t count() const noexcept { return count_; }
  double largest() const noexcept { return largest_; }  ///< [µs], exact
  /// The lateness that a share @p q of all ticks did not exceed [µs]; 0 if there are none.
  double quantile(double q) const noexcept;

 private:
  static constexpr int kPerOctave = 16;
  static constexpr int kOctaves = 34;  ///< from 1/16 µs to 1000 s
  static int binOf(double lateness) noexcept;
  static double upperEdgeOf(int bin) noexcept;

  std::array<std::uint64_t, std::size_t{kPerOctave} * kOctaves> bins_{};
  std::uint64_t count_ = 0;
  double largest_ = 0.0;
};

/// The offset and drift of a device's clock against ours, from the time stamps of its messages.
///
/// What is received is late by a delay that is never negative and often small: of every window only
/// the least delay counts, and through these goes a straight line of least squares,
///
///     host − device = offset + drift · (time since the first).
///
/// Costs a few sums, at any length.
class ClockDrift {
 public:
  /// A message that was stamped @p device and received at @p host, both [ns] and both rising.
  void add(std::int64_t device, std::int64_t host) noexcept;

  /// How much faster our clock goes [parts per million]; std::nullopt before three
  /// windows.
  std::optional<double> partsPerMillion() const noexcept;

  /// Time of the device that is 0, on our clock [ns], from what was received first.
  std::int64_t offset() const noexcept { return offset_; }

  std::int64_t windows() const noexcept { return count_; }

 private:
  static constexpr std::int64_t kWindow = 500'000'000;  // [ns]

  void closeWindow() noexcept;

  bool hasAny_ = false;
  std::int64_t firstDevice_ = 0;
  std::int64_t offset_ = 0;
  std::int64_t windowEnd_ = 0;   // on the device's clock, since the first
  std::int64_t leastTime_ = 0;   // of the least delay in this window
  std::int64_t leastDelay_ = 0;  // host − device − offset
  std::int64_t count_ = 0;
  double sumX_ = 0.0, sumY_ = 0.0, sumXX_ = 0.0, sumXY_ = 0.0;  // [s], [µs]
};

}  // namespace haptics::timing

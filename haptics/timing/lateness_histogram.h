#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace haptics::timing {

/// How late ticks were, counted in bins that are never wider than 1/16 of what they hold: quantiles
/// without keeping every tick, and without the heap.
class LatenessHistogram {
 public:
  /// @p lateness in [µs]; early counts as 0.
  void add(double lateness) noexcept;

  std::uint64_t count() const noexcept { return count_; }
  double largest() const noexcept { return largest_; }  ///< [µs], exact
  /// The lateness that a share @p q of all ticks did not exceed [µs]; 0 where there are none.
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

}  // namespace haptics::timing

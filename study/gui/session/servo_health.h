#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "haptics/engine/sample_ring.h"
#include "haptics/timing/clock_statistics.h"

namespace study::gui {

/// Timing and safety statistics of a running trial, tick by tick: lateness, force limiting, and the
/// energy of the contact. It reads no clock of its own.
class ServoHealth {
 public:
  /// Upper edges of the lateness bars [µs]. The last bar has no upper edge.
  static constexpr std::array<double, 7> kEdges{10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0};

  void add(const haptics::engine::TickSample& sample);

  std::uint64_t ticks() const noexcept { return ticks_; }
  /// Ticks per bar; the first bar counts lateness up to kEdges[0].
  const std::array<std::uint64_t, kEdges.size() + 1>& bars() const noexcept { return bars_; }
  /// The quantile @p q of the ticks' lateness [µs].
  double lateness(double q) const noexcept { return histogram_.quantile(q); }
  double largestLateness() const noexcept { return histogram_.largest(); }  ///< [µs]
  /// The ticks in which the scene asked for more force than the limit, and their share, 0 … 1.
  std::uint64_t saturatedTicks() const noexcept { return saturated_; }
  double saturatedShare() const noexcept { return share(saturated_); }
  /// The share of ticks without a measurement from the device, 0 … 1.
  double invalidShare() const noexcept { return share(invalid_); }
  /// Changes of position that are too fast for any hand.
  std::uint32_t leaps() const noexcept { return leaps_; }
  /// The energy absorbed in the current contact, and the smallest value since the start. A negative
  /// value means that the contact released more energy than it received. [N·device's travel unit]
  double energy() const noexcept { return energy_; }
  double leastEnergy() const noexcept { return leastEnergy_; }

 private:
  double share(std::uint64_t ticks) const noexcept {
    return ticks_ == 0 ? 0.0 : static_cast<double>(ticks) / static_cast<double>(ticks_);
  }

  haptics::timing::LatenessHistogram histogram_;
  std::array<std::uint64_t, kEdges.size() + 1> bars_{};
  std::uint64_t ticks_ = 0;
  std::uint64_t saturated_ = 0;
  std::uint64_t invalid_ = 0;
  std::uint32_t leaps_ = 0;
  double energy_ = 0.0;
  double leastEnergy_ = 0.0;
};

}  // namespace study::gui

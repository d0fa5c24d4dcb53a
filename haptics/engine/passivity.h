#pragma once

#include <optional>

namespace haptics::engine {

/// A force that goes on changing while the tool rests.
struct LimitCycle {
  double amplitude = 0.0;  ///< peak to peak [N]
  double frequency = 0.0;  ///< [Hz]
  double travel = 0.0;     ///< of the largest value [travel units]
};

/// What a sampled force adds to the hand's energy, and what keeps it from that: eq. (25) of the
/// punch paper, b > K T / 2 (Colgate & Schenkel 1997).
///
/// A force that is held for a period while the tool moves on is too small on the way in and too
/// large on the way out. Damping of at least K T / 2, of the mechanism and the hand together, takes
/// up what that gives.
struct Passivity {
  double stiffness = 0.0;    ///< K: the steepest slope that is rendered [N per travel unit]
  double period = 0.001;     ///< of the loop [s]
  double lateness = 0.0;     ///< how late the loop may wake up, 99.9 % of ticks [s]
  double filterDelay = 0.0;  ///< of what is between the sensor and the force [s]
  std::optional<LimitCycle> limitCycle = {};  ///< on a resting hand: no damping takes that up

  /// T: a tick that is late holds the old force for longer; a delay counts twice, because the force
  /// is that much too old all along, not on average: b > K (T/2 + τ) (Gil, Sánchez, Hulin, Preusche
  /// & Hirzinger 2009). `palpate bench stability` shows walls that vibrate where it is counted once
  /// [s].
  constexpr double effectivePeriod() const noexcept {
    return period + lateness + 2.0 * filterDelay;
  }

  /// b: the damping that is needed [N·s per travel unit].
  constexpr double neededDamping() const noexcept { return stiffness * effectivePeriod() / 2.0; }

  /// Whether a @p damping of mechanism and hand [N·s per travel unit] dissipates the energy that
  /// the loop generates.
  constexpr bool isPassiveWith(double damping) const noexcept {
    return !limitCycle && neededDamping() <= damping;
  }

  /// How far the held force is off, on average, at a speed [travel units/s]: K v T / 2 [N].
  constexpr double forceErrorAt(double speed) const noexcept {
    return stiffness * speed * effectivePeriod() / 2.0;
  }

  /// The stiffness that a damping allows [N per travel unit].
  constexpr double allowedStiffness(double damping) const noexcept {
    return 2.0 * damping / effectivePeriod();
  }
};

}  // namespace haptics::engine

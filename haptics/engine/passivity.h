#pragma once

#include <limits>
#include <optional>

namespace haptics::engine {

/// A force that goes on changing while the tool rests.
struct LimitCycle {
  double amplitude = 0.0;  ///< peak to peak [N]
  double frequency = 0.0;  ///< [Hz]
  double travel = 0.0;     ///< of the largest value [travel units]
};

/// The energy that a sampled force adds to the hand, and the damping that prevents it: eq. (25) of
/// the punch paper, b > K T / 2 (Colgate & Schenkel 1997).
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

/// Observes whether a scene returns more energy than the hand put in, and damps it on request:
/// time-domain passivity (Hannaford & Ryu 2002; for a force that is held over a step Ryu, Preusche,
/// Hirzinger & Hannaford 2005).
///
/// The force f that is held while the tool moves on by Δx takes up f Δx; the mechanism's damping b
/// also takes up b v² Δt:
///
///     E ← E + f Δx + b v² Δt.
///
/// E < 0 says that the rendered scene and the mechanism together are active. Each contact is
/// counted separately: without a force E starts at 0 again, so that the dissipation of one cut does
/// not hide generation in the next. A turn is observed in the same way, with
/// torque [N·m] and angle [rad] for force and travel.
class EnergyObserver {
 public:
  struct Settings {
    double deviceDamping = 0.0;   ///< b [N·s per travel unit], >= 0
    double tolerance = 0.0;       ///< that E may lie below 0 [N·travel unit], >= 0
    double mostDamping = 0.0;     ///< that the controller may add [N·s per travel unit]; 0: none
    double leastVelocity = 1e-9;  ///< below, nothing is damped [travel unit/s], > 0
    double noForce = 1e-3;        ///< below, there is no contact [N]
  };

  explicit EnergyObserver(const Settings& settings) noexcept : settings_(settings) {}

  /// Counts what has happened since the last step: @p held [N] was on the tool while it moved by
  /// @p moved [travel unit] at @p velocity [travel unit/s].
  void observe(double held, double moved, double velocity, double dt) noexcept;

  /// The force that dissipates what was given too much: @p desired, and damping of at most
  /// mostDamping against the motion.
  double damped(double desired, double velocity, double dt) const noexcept;

  bool isActive() const noexcept { return energy_ < -settings_.tolerance; }
  double energy() const noexcept { return energy_; }  ///< E of this contact [N·travel unit]
  double least() const noexcept { return least_; }    ///< the least E ever seen
  void reset() noexcept { energy_ = 0.0; }

 private:
  Settings settings_;
  double energy_ = 0.0;
  double least_ = 0.0;
};

}  // namespace haptics::engine
